// The support of a slider and F_N against it, on a foundation and under a ceiling.
#include "rupture/model/normal_contact.hpp"

#include <gtest/gtest.h>

#include "rupture/model/derived.hpp"

namespace rupture::testing {

class NormalContactOf : public ::testing::TestWithParam<Support> {
 protected:
  static Parameters with_support() {
    Parameters p;
    p.support = GetParam();
    return p;
  }
  const Parameters p_ = with_support();
  const NormalContact contact_{p_, 0};
};

INSTANTIATE_TEST_SUITE_P(Supports, NormalContactOf,
                         ::testing::Values(Support::foundation, Support::ceiling),
                         [](const auto& support) {
                           return support.param == Support::foundation ? "foundation" : "ceiling";
                         });

// k_f = 6.75 MN/m: 1 um is 6.75 N. The support pushes and never pulls; the other side bears F_N.
TEST(NormalContact, comes_from_the_support_on_one_side_and_F_N_on_the_other) {
  Parameters p;
  const NormalContact foundation(p, 0);
  EXPECT_DOUBLE_EQ(foundation.normal_force(-1e-6), 6.75);
  EXPECT_EQ(foundation.normal_force(1e-6), 0.0);
  EXPECT_DOUBLE_EQ(foundation.top_force(-1e-6), 1920.0 / 57);
  EXPECT_DOUBLE_EQ(foundation.top_force(1e-6), 1920.0 / 57);
  EXPECT_FALSE(has_constant_p(p));
  p.support = Support::ceiling;
  const NormalContact ceiling(p, 0);
  EXPECT_DOUBLE_EQ(ceiling.normal_force(-1e-6), 1920.0 / 57);
  EXPECT_DOUBLE_EQ(ceiling.normal_force(1e-6), 1920.0 / 57);
  EXPECT_DOUBLE_EQ(ceiling.top_force(1e-6), 6.75);
  EXPECT_EQ(ceiling.top_force(-1e-6), 0.0);
  EXPECT_TRUE(has_constant_p(p));
}

TEST_P(NormalContactOf, slopes_are_the_derivatives_of_the_forces) {
  const double h = 1e-9;
  for (const double u : {-3e-6, 2e-6}) {
    const double bottom = contact_.normal_force(u + h) - contact_.normal_force(u - h);
    const double top = contact_.top_force(u + h) - contact_.top_force(u - h);
    EXPECT_NEAR(contact_.normal_force_slope(u), bottom / (2.0 * h), 1.0);
    EXPECT_NEAR(contact_.top_force_slope(u), top / (2.0 * h), 1.0);
  }
}

TEST_P(NormalContactOf, forces_are_minus_the_gradient_of_the_energies) {
  const double h = 1e-9;
  const auto energy = [&](double bottom, double top) {
    return contact_.contact_energy(bottom, top) + contact_.load_energy(bottom, top);
  };
  for (const double u : {-3e-6, 2e-6}) {
    const double upwards = -(energy(u + h, u) - energy(u - h, u)) / (2.0 * h);
    const double downwards = (energy(u, u + h) - energy(u, u - h)) / (2.0 * h);
    EXPECT_NEAR(contact_.normal_force(u), upwards, 1e-5);
    EXPECT_NEAR(contact_.top_force(u), downwards, 1e-5);
  }
}

TEST_P(NormalContactOf, a_compressed_column_is_in_balance) {
  const double bottom = contact_.compressed_u_z(0.0), top = contact_.compressed_u_z(p_.H);
  EXPECT_GT(contact_.compression(bottom, top), 0.0);
  EXPECT_NEAR(contact_.normal_force(bottom), mean_normal_force(p_), 1e-12);
  EXPECT_NEAR(contact_.top_force(top), mean_normal_force(p_), 1e-12);
  EXPECT_NEAR((bottom - top) / p_.H, p_.F_N / (p_.L * p_.B * p_.E), 1e-15);
}

}  // namespace rupture::testing
