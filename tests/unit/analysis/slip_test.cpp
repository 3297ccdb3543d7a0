// Slip in made-up histories; slow slip behind a made-up front.
#include "rupture/analysis/slip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "rupture/analysis/slow_slip.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::testing {

/// One sample a second [mm]; slow slip ends above 5 mm/s.
std::optional<SlipMeasure> slip_of(const std::vector<double>& u, double t_rupture) {
  std::vector<double> time(u.size());
  std::iota(time.begin(), time.end(), 0.0);
  return measure_slip({time, u}, t_rupture, 5.0);
}

struct SlipByHand {
  double t_arrest, fast_slip, t_end, slow_slip, t_from, t_to;
  std::optional<double> slope = {};  // [mm/s]
};

void expect_slip(const char* why, const std::vector<double>& u, double t_rupture,
                 const SlipByHand& expected) {
  SCOPED_TRACE(why);
  const SlipMeasure slip = slip_of(u, t_rupture).value();
  EXPECT_EQ(slip.t_arrest, expected.t_arrest);
  EXPECT_EQ(slip.fast_slip, expected.fast_slip);
  EXPECT_EQ(slip.t_end, expected.t_end);
  EXPECT_EQ(slip.slow_slip, expected.slow_slip);
  EXPECT_EQ(slip.t_from, expected.t_from);
  EXPECT_EQ(slip.t_to, expected.t_to);
  ASSERT_EQ(slip.slow.has_value(), expected.slope.has_value());
  EXPECT_NEAR(slip.slow ? slip.slow->slope : 0.0, expected.slope.value_or(0.0), 1e-12);
}

TEST(Slip, is_as_worked_out_by_hand) {
  expect_slip("Before it moves, it has not stopped. 20 % are of the 8 mm at the end, not of 10 mm.",
              {0, 0, 10, 20, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 29, 28}, 0.0,
              {3, 20, 16, 8, 6, 11, 1.0});
  // the four are -1.5, -0.5, 0.5 and 1.5 s, and -2.25, -1.25, -0.25 and 3.75 mm, from their mean
  expect_slip("The samples just at 20 and 80 % are fitted.", {0, 0, 10, 20, 20, 22, 23, 24, 28, 30},
              1.0, {3, 20, 9, 10, 5, 8, 9.5 / 5.0});
  expect_slip(
      "It has moved before its rupture; 5 mm/s are still slow, and two samples have no slope.",
      {1, 2, 2, 12, 22, 22, 27, 32, 38, 50}, 2.0, {4, 21, 7, 10, 6, 7});
  expect_slip("The step from the sample at its rupture counts.", {1, 11, 11, 12}, 0.0,
              {1, 10, 3, 1, 3, 3});
  expect_slip("It stays at rest.", {1, 11, 11, 11}, 0.0, {1, 10, 3, 0, 1, 1});
}

TEST(Slip, needs_an_arrest_after_a_rupture_that_was_sampled) {
  EXPECT_FALSE(slip_of({0, 10, 20}, 0.0)) << "ends before the arrest";
  EXPECT_FALSE(slip_of({0, 10, 10, 11, 12}, 2.0)) << "slow slip that never stops";
  EXPECT_FALSE(slip_of({0, 10, 10}, 3.0)) << "after the last sample";
}

/// Blocks 2.5 mm apart, of which 0..9 rupture at once, 10..29 one per 0.25 ms, the rest at once.
Front made_up_front() {
  Parameters p;
  std::vector<Rupture> ruptures;
  for (std::int64_t i = 0; i < p.Nx; ++i) {
    const double slow_blocks = static_cast<double>(std::clamp<std::int64_t>(i - 9, 0, 21));
    const double t = 1e-3 + 8e-6 * static_cast<double>(i) + 0.25e-3 * slow_blocks;
    ruptures.push_back({static_cast<std::int64_t>(t / p.dt), t, i});
  }
  return measure_front(p, rupture_line(p, ruptures, 0.0, 1.0), {});
}

// How it is measured otherwise is in tests/tools/tables/analyze.txt.
TEST(SlowSlipBehindAFront, is_followed_for_the_slipping_time_of_its_own_block) {
  Parameters p;
  std::vector<double> t_R(57, p.t_R[0]);
  t_R[12] /= 2.0;
  p.t_R = AlongX(std::move(t_R));
  const SlowSlipTime time = slow_slip_time(p, made_up_front(), 12, {}).value();
  EXPECT_NEAR(time.to - time.from, mean_slipping_time(p, 12), 1e-12);
}

// --- Eq. S1; the relaxation of one block is in tests/tools/tables/estimate.txt

TEST(Relaxation, of_a_junction_that_always_breaks_never_ends) {
  Parameters p;
  p.N_s = 3;
  p.mu_d = 0.2;
  p.mu_s = 1.4 * 0.2;  // each return breaks another and adds 1 f_slip/k_ij
  EXPECT_FALSE(relax(p, 0));
}

TEST(Relaxation, counts_time_in_mean_slipping_times) {
  Parameters fast;
  fast.t_R = fast.t_R[0] / 8.0;
  fast.delta_t_R = fast.delta_t_R[0] / 8.0;
  EXPECT_DOUBLE_EQ(relax(fast, 3)->duration, relax(Parameters{}, 3)->duration);
  EXPECT_DOUBLE_EQ(relax(fast, 3)->quiet_time, relax(Parameters{}, 3)->quiet_time);
}

TEST(Relaxation, does_not_happen_when_junctions_keep_f_slip) {
  Parameters p;
  p.f_new = NewForce::f_slip;
  EXPECT_NEAR(relax(p, 0)->net_slip, 0.0, 1e-12);
}

TEST(SlowSlipEstimate, is_zero_where_nothing_drives_it) {
  Parameters p;
  EXPECT_EQ(slow_slip_estimate(p, 0, 0.0), 0.0);
  p.f_new = NewForce::f_slip;
  EXPECT_EQ(slow_slip_estimate(p, 0, 25.0), 0.0);
}

TEST(SlowSlipEstimate, has_the_parameters_of_its_block) {
  Parameters p;
  const double everywhere = slow_slip_estimate(p, 1, 25.0);
  const auto times = [](const AlongX<double>& value, double factor) {
    return AlongX(std::vector{value[0], value[1] * factor});
  };
  p.mu_d = times(p.mu_d, 3.0);
  p.kappa = times(p.kappa, 4.0);  // k_ij ~ sqrt(kappa)
  p.t_R = times(p.t_R, 8.0);
  p.delta_t_R = times(p.delta_t_R, 8.0);
  EXPECT_DOUBLE_EQ(slow_slip_estimate(p, 1, 25.0), 3.0 / (2.0 * 8.0) * everywhere);
}

}  // namespace rupture::testing
