// A slider twice as large, of the same material and under the same pressure, whose slipping times
// are twice as long, does everything at exactly twice the time (docs/model.md): factors of two
// change no digit of a number.
#include <gtest/gtest.h>

#include "support/sliders.hpp"

namespace rupture::testing {

Parameters twice_as_large(Parameters p) {
  for (double* length : {&p.L, &p.H, &p.B, &p.h}) *length *= 2;
  p.M *= 8;
  p.F_N *= 4;
  p.K *= 2;
  for (auto* all : {&p.t_R, &p.delta_t_R, &p.d_R, &p.delta_d_R}) *all = 2 * (*all)[0];
  p.dt *= 2;
  return p;
}

class Scaling : public ::testing::TestWithParam<Law> {};

INSTANTIATE_TEST_SUITE_P(Law, Scaling, ::testing::ValuesIn(kAllLaws),
                         [](const auto& law) { return law_name(law.param); });

TEST_P(Scaling, of_lengths_and_times_by_two_is_exact) {
  const Parameters p = quick_slider(GetParam()), large = twice_as_large(p);
  Simulation one(p, normal_load_equilibrium(p)), other(large, normal_load_equilibrium(large));
  one.advance(2500);
  other.advance(2500);
  ASSERT_GE(one.ruptures().size(), 9U);
  ASSERT_EQ(one.ruptures().size(), other.ruptures().size());
  for (std::size_t i = 0; i < one.ruptures().size(); ++i) {
    EXPECT_EQ(other.ruptures()[i].block, one.ruptures()[i].block);
    EXPECT_EQ(other.ruptures()[i].time, 2 * one.ruptures()[i].time);
  }
  EXPECT_TRUE((other.state().u_x.blocks() == 2 * one.state().u_x.blocks()).all());
}

}  // namespace rupture::testing
