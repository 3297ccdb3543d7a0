// Slip measured in a made-up history: creep at 1 mm/s until 1 ms, 0.1 ms of fast slip at 100 mm/s,
// 0.2 ms at rest, then slow slip at 2 mm/s until 4 ms. Slow slip behind a made-up front.
#include "rupture/analysis/slip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "rupture/analysis/slow_slip.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::testing {

constexpr double kRupture = 1e-3, kArrest = 1.1e-3, kRestart = 1.3e-3, kEnd = 4e-3;  // [s]
constexpr double kCreep = 1e-3, kFastSlip = 0.1, kSlowSlip = 2e-3;                   // [m/s]
constexpr double kInterval = 1e-5;                                                   // [s]
constexpr double kNextFast = 20e-3;                                                  // [m/s]

struct Samples {
  std::vector<double> time, u_x;
  SlipHistory history() const { return {time, u_x}; }
};

Samples made_up(double until = kEnd) {
  Samples s;
  for (int n = 0; n * kInterval < until + kInterval / 2; ++n) {
    const double t = n * kInterval;
    s.time.push_back(t);
    s.u_x.push_back(5e-6 + kCreep * std::min(t, kRupture) +
                    kFastSlip * (std::clamp(t, kRupture, kArrest) - kRupture) +
                    kSlowSlip * (std::max(t, kRestart) - kRestart));
  }
  return s;
}

TEST(Slip, is_told_apart_into_fast_and_slow_of_which_20_to_80_percent_are_fitted) {
  const Samples samples = made_up();
  const auto slip = measure_slip(samples.history(), kRupture, kNextFast);
  ASSERT_TRUE(slip && slip->slow);
  EXPECT_NEAR(slip->t_arrest, kArrest, 1.01 * kInterval);
  EXPECT_NEAR(slip->fast_slip, kCreep * kRupture + kFastSlip * (kArrest - kRupture), 1e-12);
  EXPECT_NEAR(slip->slow_slip, kSlowSlip * (kEnd - kRestart), 1e-12);
  EXPECT_NEAR(slip->t_from, kRestart + 0.2 * (kEnd - kRestart), 1.01 * kInterval);
  EXPECT_NEAR(slip->t_to, kRestart + 0.8 * (kEnd - kRestart), 1.01 * kInterval);
  EXPECT_NEAR(slip->slow->slope, kSlowSlip, 1e-9 * kSlowSlip);
  EXPECT_NEAR(slip->slow->r_squared, 1.0, 1e-12);
}

TEST(Slip, needs_an_arrest_after_a_rupture_that_was_sampled) {
  const Samples samples = made_up(), moving = made_up(kArrest - 2 * kInterval);
  EXPECT_FALSE(measure_slip(moving.history(), kRupture, kNextFast)) << "ends before the arrest";
  EXPECT_FALSE(measure_slip(samples.history(), 2e-3, kNextFast)) << "slow slip that never stops";
  EXPECT_FALSE(measure_slip(samples.history(), 1.0, kNextFast)) << "after the last sample";
}

TEST(Slip, of_a_block_that_stays_arrested_has_no_slow_part) {
  const Samples samples = made_up(kRestart - kInterval);
  const auto slip = measure_slip(samples.history(), kRupture, kNextFast);
  ASSERT_TRUE(slip);
  EXPECT_NEAR(slip->slow_slip, 0.0, 1e-18);
  EXPECT_FALSE(slip->slow) << "nothing to fit";
}

TEST(Slip, is_slow_until_the_block_next_slips_fast) {
  for (const double again : {1.05 * kNextFast, 0.95 * kNextFast}) {
    Samples samples = made_up();
    for (int n = 0; n < 50; ++n) {
      samples.time.push_back(samples.time.back() + kInterval);
      samples.u_x.push_back(samples.u_x.back() + again * kInterval);
    }
    const auto slip = measure_slip(samples.history(), kRupture, kNextFast);
    ASSERT_TRUE(slip);
    const bool ends = again > kNextFast;
    const double later = ends ? 0.0 : 50 * kInterval;
    EXPECT_NEAR(slip->t_end, kEnd + later, 1e-9) << again;
    EXPECT_NEAR(slip->slow_slip, kSlowSlip * (kEnd - kRestart) + again * later, 1e-12) << again;
  }
}

TEST(SlowSlip, is_fitted_between_20_and_80_percent_of_what_happens_in_its_time) {
  Samples samples;  // 1 um/ms for 1 ms, 4 um/ms for 1 ms, 1 um/ms ever after
  for (int n = 0; n <= 400; ++n) {
    const double t = n * kInterval;
    samples.time.push_back(t);
    samples.u_x.push_back(1e-3 * t + 3e-3 * (std::clamp(t, 1e-3, 2e-3) - 1e-3));
  }
  // 6 um in 3 ms, 1.2 um to 4.8 um of which happen within the fast millisecond
  const auto line = fit_slow_slip(samples.history(), {0.0, 3e-3});
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->slope, 4e-3, 0.05e-3);
  const auto late = fit_slow_slip(samples.history(), {2.1e-3, 3e-3});
  ASSERT_TRUE(late);
  EXPECT_NEAR(late->slope, 1e-3, 1e-9);
  EXPECT_FALSE(fit_slow_slip(samples.history(), {3e-3, 3.01e-3})) << "two samples";
  EXPECT_FALSE(fit_slow_slip(samples.history(), {5e-3, 6e-3})) << "after the last sample";
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

class SlowSlipBehindAFront : public ::testing::Test {
 protected:
  std::optional<SlowSlipTime> time_of(std::size_t block,
                                      const SlowSlipCriteria& criteria = {}) const {
    return slow_slip_time(p_, front_, block, criteria);
  }
  double t_rupture(std::size_t block) const { return *front_.line.t_rupture[block]; }

  const Parameters p_{};
  Front front_ = made_up_front();
  const double wait_ = p_.H / shear_wave_speed(p_);
  const double t_R_ = mean_slipping_time(p_, 0);
};

TEST_F(SlowSlipBehindAFront,
       begins_after_the_rupture_of_the_block_and_after_the_front_became_slow) {
  ASSERT_TRUE(time_of(12) && time_of(3));
  EXPECT_NEAR(time_of(12)->from, t_rupture(12) + wait_, 1e-12);
  EXPECT_NEAR(time_of(12)->to, time_of(12)->from + t_R_, 1e-12);
  EXPECT_NEAR(time_of(3)->from, front_.slow->t_from + wait_, 1e-12);
}

TEST_F(SlowSlipBehindAFront, ends_with_the_last_slow_stencil) {
  ASSERT_TRUE(time_of(24));
  EXPECT_LT(time_of(24)->to, time_of(24)->from + t_R_);
  EXPECT_EQ(time_of(24)->to, t_rupture(slow_blocks(front_).back() + 2));
}

TEST_F(SlowSlipBehindAFront, needs_some_time_and_a_slow_front) {
  EXPECT_FALSE(time_of(26) || time_of(40));
  EXPECT_TRUE(time_of(26, {1.0, 0.1}));
  front_.slow.reset();
  EXPECT_FALSE(time_of(12));
  EXPECT_TRUE(slow_blocks(front_).empty());
}

TEST_F(SlowSlipBehindAFront, is_that_of_the_blocks_with_a_whole_stencil_in_the_slow_stretch) {
  const auto blocks = slow_blocks(front_);
  ASSERT_FALSE(blocks.empty());
  EXPECT_EQ(front_.line.x[blocks.front() - 2], front_.slow->x_from);
  EXPECT_EQ(front_.line.x[blocks.back() + 2], front_.slow->x_to);
}

// --- Eq. S1 and the one-block relaxation behind its coefficient

TEST(SlowSlipEstimate, is_zero_where_nothing_drives_it) {
  Parameters p;
  EXPECT_EQ(slow_slip_estimate(p, 0, 0.0), 0.0);
  p.f_new = NewForce::f_slip;
  EXPECT_EQ(slow_slip_estimate(p, 0, 25.0), 0.0);
}

TEST(Relaxation, without_breaking_slips_by_the_harmonic_sum) {
  Parameters p;
  p.mu_s = 100.0;
  const auto relaxation = relax(p, 0);
  ASSERT_TRUE(relaxation);
  EXPECT_NEAR(relaxation->net_slip, 5.187377517639621, 1e-12);  // H_100
  EXPECT_EQ(relaxation->duration, relaxation->quiet_time);
  EXPECT_EQ(relaxation->slip_at_return, relaxation->net_slip);
  p.N_s = 3;
  EXPECT_NEAR(relax(p, 0)->net_slip, 1.0 + 1.0 / 2.0 + 1.0 / 3.0, 1e-15);
}

TEST(Relaxation, of_three_junctions_with_breaking_follows_the_hand) {
  // Pinned in the order A, B, C. f_thres = 1.4 f_slip: A makes the slip 1. B would make it 1.5, but
  // A breaks at 1.4, and B alone makes it 2. The next one, attached there, would make it 2.5, but B
  // breaks at 2.4, and so on: one stays pinned, and each return adds 1 for ever.
  Parameters p;
  p.N_s = 3;
  p.mu_d = 0.2;
  p.mu_s = 1.4 * 0.2;
  EXPECT_FALSE(relax(p, 0));
  // f_thres = 1.6 f_slip: B makes it 1.5. C, attached there, would make it 1 + 2.5/3, but A breaks
  // at 1.6, which makes it 1 + 2.5/2 = 2.25. A, attached there: 1 + 4.75/3 = 2.58, and B bears 2.6.
  p.mu_s = 1.6 * 0.2;
  const auto relaxation = relax(p, 0);
  ASSERT_TRUE(relaxation);
  EXPECT_NEAR(relaxation->net_slip, 1.0 + 4.75 / 3.0, 1e-14);
  EXPECT_NEAR(relaxation->slip_at_return, 2.25, 1e-14);
  EXPECT_GT(relaxation->quiet_time, relaxation->duration);
}

TEST(Relaxation, counts_time_in_mean_slipping_times) {
  Parameters fast;
  fast.t_R = fast.t_R[0] / 8.0;
  fast.delta_t_R = fast.delta_t_R[0] / 8.0;
  EXPECT_DOUBLE_EQ(relax(fast, 3)->duration, relax(Parameters{}, 3)->duration);
  Parameters equal;
  equal.delta_t_R = 0.0;
  EXPECT_DOUBLE_EQ(relax(equal, 0)->duration, 1.0);
}

TEST(Relaxation, does_not_happen_when_junctions_keep_f_slip) {
  Parameters p;
  p.f_new = NewForce::f_slip;
  EXPECT_NEAR(relax(p, 0)->net_slip, 0.0, 1e-12);
}

}  // namespace rupture::testing
