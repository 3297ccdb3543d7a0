// Every branch of the simplified interface law against sequences worked out by hand.
//
// One spring with k_i = 2 N/m under p_i = 1 N (N_s = 1): it breaks beyond 0.2 m and slides at
// 0.17 N, that is a stretch of 0.085 m. Slow slip moves its attachment point by v_slow dt = 0.001 m
// per update, until 2 ms after the break.
#include "rupture/forces/simplified_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hand_made_interface.hpp"

namespace rupture {
namespace {

using testing::Interface;
using testing::kBreakStretch;
using testing::kRounding;
using testing::kSlipForce;
using testing::kSlippingTime;
using testing::kSlipStretch;

constexpr double kSlowSlip = 0.001;  // v_slow dt [m]

Parameters simplified(std::int64_t N_s = 1) {
  Parameters p = testing::hand_made(N_s);
  p.law = Law::simplified;
  p.dt = 1e-4;
  p.v_slow = 10.0;
  return p;
}

/// An interface whose spring has just broken at u = 0.21 m (times `sign`), t = 0.
class Sliding : public Interface {
 public:
  explicit Sliding(double sign = 1.0, const Parameters& p = simplified()) : Interface(p) {
    move(sign * kBrokenAt, 0.0);
  }
  static constexpr double kBrokenAt = 0.21;
};

TEST(SimplifiedLaw, pulls_back_in_proportion_to_the_stretch) {
  Interface block(simplified());
  for (const double u : {0.05, 0.19, -0.05, -0.19, 0.0}) {
    const auto changes = block.move(u, 1e-4);
    EXPECT_DOUBLE_EQ(block.friction(), 2.0 * u);
    EXPECT_EQ(changes.broken + changes.repinned, 0);
    EXPECT_EQ(block.attachment(), 0.0) << "no slow slip before the first break";
  }
}

TEST(SimplifiedLaw, breaks_above_the_strength_and_slides_at_mu_d_p_of_the_same_sign) {
  for (const double sign : {1.0, -1.0}) {
    Interface block(simplified());
    EXPECT_EQ(block.move(sign * kBreakStretch, 0.0).broken, 0);
    EXPECT_EQ(block.pinned(), 1);
    EXPECT_EQ(block.move(sign * std::nextafter(kBreakStretch, 1.0), 0.0).broken, 1);
    EXPECT_EQ(block.pinned(), 0);
    EXPECT_NEAR(block.friction(), sign * kSlipForce, kRounding);
    EXPECT_EQ(block.junctions().slow_until(0, 0), sign * kSlippingTime);
    EXPECT_EQ(block.junctions().draws(0, 0), 0U);
  }
}

TEST(SimplifiedLaw, has_the_stiffness_and_strength_of_all_junctions_together) {
  Interface block(simplified(50));  // f_N = 1 N on each of 50
  EXPECT_EQ(block.junctions().attachment.cols(), 1);
  block.move(0.1, 0.0);
  EXPECT_NEAR(block.friction(), 50 * 0.2, 1e-13);
  EXPECT_EQ(block.move(0.21, 0.0).broken, 1);
  EXPECT_NEAR(block.friction(), 50 * kSlipForce, 1e-13);
}

TEST(SimplifiedLaw, trails_a_block_that_is_faster_than_slow_slip) {
  for (const double sign : {1.0, -1.0}) {
    Sliding block(sign);
    for (const double u : {0.25, 0.4, 2.0}) {
      EXPECT_EQ(block.move(sign * u, 1e-4).repinned, 0);
      EXPECT_NEAR(block.friction(), sign * kSlipForce, kRounding);
      EXPECT_NEAR(block.attachment(), sign * (u - kSlipStretch), kRounding);
    }
  }
}

TEST(SimplifiedLaw, moves_the_attachment_at_v_slow_while_the_block_is_slower) {
  for (const double sign : {1.0, -1.0}) {
    Sliding block(sign);
    const double attachment = block.attachment();
    for (int n = 1; n <= 3; ++n) {
      block.move(sign * (Sliding::kBrokenAt + n * 1e-6), n * 1e-4);
      EXPECT_NEAR(block.attachment(), attachment + sign * n * kSlowSlip, kRounding);
      EXPECT_EQ(block.pinned(), 0);
    }
  }
}

TEST(SimplifiedLaw, stops_slow_slip_t_R_after_the_break_while_slipping) {
  for (const double sign : {1.0, -1.0}) {
    Sliding block(sign);
    const double attachment = block.attachment();
    block.move(sign * (Sliding::kBrokenAt + 1e-6), std::nextafter(kSlippingTime, 0.0));
    EXPECT_NEAR(block.attachment(), attachment + sign * kSlowSlip, kRounding);
    const double end = block.attachment();
    block.move(sign * (Sliding::kBrokenAt + 2e-6), kSlippingTime);
    EXPECT_EQ(block.attachment(), end);
    EXPECT_EQ(block.pinned(), 0);
  }
}

TEST(SimplifiedLaw, pulls_a_sliding_block_forwards_no_harder_than_mu_d_p) {
  for (const double sign : {1.0, -1.0}) {
    Sliding block(sign);
    double u = Sliding::kBrokenAt;
    for (int n = 1; n < 400; ++n) block.move(sign * (u += 1e-6), 1e-4);  // 0.4 m if nothing stopped
    EXPECT_NEAR(block.friction(), -sign * kSlipForce, kRounding);
    EXPECT_NEAR(block.attachment(), sign * (u + kSlipStretch), kRounding);
    EXPECT_EQ(block.pinned(), 0);
  }
}

TEST(SimplifiedLaw, pins_with_its_force_when_the_block_turns_back) {
  for (const double sign : {1.0, -1.0}) {
    Parameters p = simplified();
    p.v_slow = 0.0;
    Sliding block(sign, p);
    EXPECT_EQ(block.move(sign * 0.3, 1e-4).repinned, 0);
    EXPECT_EQ(block.move(sign * 0.299, 2e-4).repinned, 1);
    EXPECT_EQ(block.pinned(), 1);
    EXPECT_NEAR(block.friction(), sign * (kSlipForce - 0.002), kRounding);
    const double attachment = block.attachment();
    EXPECT_EQ(block.move(sign * (attachment * sign + 0.199), 3e-4).broken, 0);
    EXPECT_EQ(block.attachment(), attachment) << "no slow slip at v_slow = 0";
    EXPECT_EQ(block.move(sign * (attachment * sign + 0.201), 4e-4).broken, 1);
  }
}

TEST(SimplifiedLaw, pins_when_the_block_stands_still) {
  Sliding block;
  EXPECT_EQ(block.move(Sliding::kBrokenAt, 1e-4).repinned, 1);
  EXPECT_EQ(block.pinned(), 1);
}

TEST(SimplifiedLaw, goes_on_slipping_slowly_when_pinned_until_t_R_after_the_break) {
  for (const double sign : {1.0, -1.0}) {
    Sliding block(sign);
    block.move(sign * 0.2, 1e-4);
    ASSERT_EQ(block.pinned(), 1);
    const double attachment = block.attachment();
    for (int n = 1; n <= 18; ++n) {
      block.move(sign * 0.2, 1e-4 + n * 1e-4);
      EXPECT_NEAR(block.attachment(), attachment + sign * n * kSlowSlip, kRounding) << n;
      EXPECT_NEAR(block.friction(), 2.0 * (sign * 0.2 - block.attachment()), kRounding);
    }
    const double end = block.attachment();
    block.move(sign * 0.2, kSlippingTime);
    block.move(sign * 0.2, 2.0 * kSlippingTime);
    EXPECT_EQ(block.attachment(), end);
    EXPECT_EQ(block.pinned(), 1);
  }
}

TEST(SimplifiedLaw, moves_slowly_before_it_asks_whether_a_pinned_spring_breaks) {
  Sliding block;
  block.move(0.2, 1e-4);
  const double attachment = block.attachment();
  EXPECT_EQ(block.move(attachment + kSlowSlip + 0.1999, 2e-4).broken, 0);
  EXPECT_EQ(block.move(attachment + 2.0 * kSlowSlip + 0.2001, 3e-4).broken, 1);
}

TEST(SimplifiedLaw, takes_direction_and_time_of_the_last_break) {
  for (const double sign : {1.0, -1.0}) {
    Sliding block(sign);
    block.move(sign * 0.2, 1e-4);  // pinned
    EXPECT_EQ(block.move(-sign * 0.3, 1.5e-3).broken, 1);
    EXPECT_NEAR(block.friction(), -sign * kSlipForce, kRounding);
    EXPECT_EQ(block.junctions().slow_until(0, 0), -sign * (1.5e-3 + kSlippingTime));
    const double attachment = block.attachment();
    EXPECT_EQ(block.move(-sign * 0.3001, 2.5e-3).repinned, 0) << "moves on along the new direction";
    EXPECT_NEAR(block.attachment(), attachment - sign * kSlowSlip, kRounding);
    EXPECT_EQ(block.move(-sign * 0.3, 2.6e-3).repinned, 1);
  }
}

TEST(SimplifiedLaw, pins_at_once_a_block_that_moves_against_its_force) {
  Interface block(simplified());
  block.move(0.19, 0.0);
  block.press(0.25);  // k_i = 1 N/m, strength 0.1 N
  EXPECT_EQ(block.move(0.18, 1e-4).broken, 1) << "moving back, but pulled back too hard";
  EXPECT_NEAR(block.friction(), 0.0425, kRounding);
  EXPECT_EQ(block.move(0.17, 2e-4).repinned, 1);
}

TEST(SimplifiedLaw, follows_the_current_normal_force) {
  Parameters p = simplified();
  p.v_slow = 0.0;
  Sliding block(1.0, p);
  block.press(0.25);  // k_i = 1 N/m, w = 0.25 m
  block.move(0.22, 1e-4);
  EXPECT_NEAR(block.friction(), 0.0425, kRounding);
  block.press(4.0);  // k_i = 4 N/m: slides at a stretch of 0.17 m, and no force pulls it there
  block.move(0.23, 2e-4);
  EXPECT_NEAR(block.friction(), 4.0 * (0.0425 + 0.01), kRounding);
}

TEST(SimplifiedLaw, has_no_friction_without_contact_and_its_time_runs_on) {
  for (const double sign : {1.0, -1.0}) {
    Sliding block(sign);
    block.press(0.0);
    EXPECT_EQ(block.move(sign * 1.0, 1e-4).repinned, 0);
    EXPECT_EQ(block.friction(), 0.0);
    EXPECT_EQ(block.attachment(), sign * 1.0);
    EXPECT_EQ(block.move(sign * 0.9, 2e-4).repinned, 1) << "turned back in the air";
    EXPECT_EQ(block.move(sign * 5.0, 3e-4).broken, 0);
    EXPECT_EQ(block.attachment(), sign * 5.0);
    block.press(1.0);
    block.move(sign * 5.0, 4e-4);
    EXPECT_NEAR(block.attachment(), sign * (5.0 + kSlowSlip), kRounding) << "before t_R";
    EXPECT_NEAR(block.friction(), -sign * 2.0 * kSlowSlip, 10 * kRounding);
  }
}

TEST(SimplifiedLaw, takes_up_a_slip_in_progress_from_the_junctions_alone) {
  Sliding block;
  Junctions junctions = block.junctions();
  SimplifiedLaw law(simplified(), junctions);
  EXPECT_EQ(law.pinned()[0], 0);
  double u = 0.2, v = -1.0, p_i = 1.0, k_ij = 2.0, w = 0.5;
  EXPECT_EQ(law.update(&u, &v, {&p_i, &k_ij, &w}, 1e-4).repinned, 1);
  EXPECT_NEAR(junctions.attachment(0, 0), 0.125 + kSlowSlip, kRounding);
  EXPECT_EQ(SimplifiedLaw(simplified(), junctions).pinned()[0], 1);
}

}  // namespace
}  // namespace rupture
