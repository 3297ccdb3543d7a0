// Quantities that follow from the parameters.
#include "rupture/model/derived.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rupture {
namespace {

TEST(JunctionStiffness, follows_the_root_of_the_normal_force) {
  const Parameters p;
  const double mean = mean_normal_force(p);
  EXPECT_DOUBLE_EQ(junction_stiffness(p, mean), std::sqrt(39.2e9 * 1920 / 57 / 100));
  EXPECT_DOUBLE_EQ(junction_stiffness(p, 4.0 * mean), 2.0 * junction_stiffness(p, mean));
  EXPECT_EQ(junction_stiffness(p, 0.0), 0.0);
}

TEST(JunctionStiffness, from_the_initial_force_is_that_of_an_even_load_where_there_is_contact) {
  const Parameters current;
  Parameters p;
  p.k_ij_from = StiffnessFrom::initial;
  const double mean = mean_normal_force(p);
  for (const double p_i : {0.01 * mean, mean, 4.0 * mean}) {
    EXPECT_EQ(junction_stiffness(p, p_i), junction_stiffness(current, mean));
  }
  EXPECT_EQ(junction_stiffness(p, 0.0), 0.0);
  EXPECT_EQ(friction_stretch(p, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(friction_stretch(p, mean), friction_stretch(current, mean));
}

TEST(FrictionStretch, makes_the_strength_follow_the_current_force_whatever_the_stiffness) {
  Parameters p;
  for (const auto from : {StiffnessFrom::current, StiffnessFrom::initial}) {
    p.k_ij_from = from;
    for (const double p_i : {0.3, 30.0, 300.0}) {
      EXPECT_DOUBLE_EQ(junction_stiffness(p, p_i) * friction_stretch(p, p_i), p_i / 100.0);
    }
  }
}

}  // namespace
}  // namespace rupture
