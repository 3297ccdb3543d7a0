// Slip measured in a made-up history: at rest until 1 ms, 0.1 ms of fast slip at 100 mm/s, 0.2 ms
// at rest, then slow slip at 2 mm/s until 4 ms.
#include "rupture/analysis/slip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace rupture {
namespace {

constexpr double kRupture = 1e-3, kArrest = 1.1e-3, kRestart = 1.3e-3, kEnd = 4e-3;  // [s]
constexpr double kFast = 0.1, kSlow = 2e-3;                                          // [m/s]
constexpr double kInterval = 1e-5;                                                   // [s]
constexpr double kFastWithin = 1e-3;                                                 // [s]

struct Samples {
  std::vector<double> time, u_x;
  SlipHistory history() const { return {time, u_x}; }
};

Samples made_up(double until = kEnd) {
  Samples s;
  for (int n = 0; n * kInterval < until + kInterval / 2; ++n) {
    const double t = n * kInterval;
    s.time.push_back(t);
    s.u_x.push_back(5e-6 + kFast * (std::clamp(t, kRupture, kArrest) - kRupture) +
                    kSlow * (std::max(t, kRestart) - kRestart));
  }
  return s;
}

TEST(Slip, is_told_apart_into_fast_and_slow) {
  const Samples samples = made_up();
  const auto slip = measure_slip(samples.history(), kRupture, kFastWithin);
  ASSERT_TRUE(slip);
  EXPECT_NEAR(slip->t_arrest, kArrest, 1.01 * kInterval);
  EXPECT_NEAR(slip->fast_slip, kFast * (kArrest - kRupture), 1e-12);
  EXPECT_NEAR(slip->slow_slip, kSlow * (kEnd - kRestart), 1e-12);
}

TEST(Slip, is_fitted_between_20_and_80_percent_of_the_slow_part) {
  const Samples samples = made_up();
  const auto slip = measure_slip(samples.history(), kRupture, kFastWithin);
  ASSERT_TRUE(slip && slip->slow);
  EXPECT_NEAR(slip->t_from, kRestart + 0.2 * (kEnd - kRestart), 1.01 * kInterval);
  EXPECT_NEAR(slip->t_to, kRestart + 0.8 * (kEnd - kRestart), 1.01 * kInterval);
  EXPECT_NEAR(slip->slow->slope, kSlow, 1e-9 * kSlow);
  EXPECT_NEAR(slip->slow->r_squared, 1.0, 1e-12);
}

TEST(Slip, needs_an_arrest) {
  const Samples samples = made_up(kArrest - 2 * kInterval);
  EXPECT_FALSE(measure_slip(samples.history(), kRupture, kFastWithin));
}

TEST(Slip, takes_for_fast_only_what_follows_the_rupture_closely) {
  // Sought within 20 us from 2 ms on, the fastest slip is the slow one, which never stops.
  const Samples samples = made_up();
  EXPECT_FALSE(measure_slip(samples.history(), 2e-3, 2e-5));
}

TEST(Slip, of_a_block_that_stays_arrested_has_no_slow_part) {
  const Samples samples = made_up(kRestart - kInterval);
  const auto slip = measure_slip(samples.history(), kRupture, kFastWithin);
  ASSERT_TRUE(slip);
  EXPECT_NEAR(slip->slow_slip, 0.0, 1e-18);
  EXPECT_FALSE(slip->slow) << "nothing to fit";
}

TEST(Slip, after_the_last_sample_has_no_value) {
  const Samples samples = made_up();
  EXPECT_FALSE(measure_slip(samples.history(), 1.0, kFastWithin));
}

}  // namespace
}  // namespace rupture
