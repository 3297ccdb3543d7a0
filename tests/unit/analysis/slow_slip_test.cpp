// Eq. S1 and the one-block relaxation behind its coefficient.
#include "rupture/analysis/slow_slip.hpp"

#include <gtest/gtest.h>

namespace rupture::testing {

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
