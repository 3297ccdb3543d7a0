// Every branch of the reference interface law against sequences worked out by hand, for the
// junction of hand_made_interface.hpp.
#include "rupture/forces/reference_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hand_made_interface.hpp"
#include "rupture/model/random.hpp"

namespace rupture {
namespace {

using testing::hand_made;
using testing::Interface;
using testing::kBreakStretch;
using testing::kRounding;
using testing::kSlipForce;
using testing::kSlippingTime;
using testing::kSlipStretch;

/// An interface with one junction that has just broken at u = 0.21 m, t = 0.
class Slipping : public Interface {
 public:
  explicit Slipping(const Parameters& p = hand_made(1)) : Interface(p) { move(kBrokenAt, 0.0); }
  static constexpr double kBrokenAt = 0.21;
};

TEST(PinnedJunction, pulls_back_in_proportion_to_the_stretch) {
  Interface block(hand_made(1));
  for (const double u : {0.05, 0.19, -0.05, -0.19, 0.0}) {
    const auto changes = block.move(u, 0.0);
    EXPECT_DOUBLE_EQ(block.friction(), 2.0 * u);
    EXPECT_EQ(changes.broken + changes.repinned, 0);
    EXPECT_EQ(block.attachment(), 0.0);
  }
}

TEST(PinnedJunction, holds_at_f_thres_and_breaks_above_it) {
  Interface block(hand_made(1));
  EXPECT_EQ(block.move(kBreakStretch, 0.0).broken, 0);
  EXPECT_EQ(block.move(-kBreakStretch, 0.0).broken, 0);
  EXPECT_EQ(block.pinned(), 1);
  EXPECT_EQ(block.move(std::nextafter(kBreakStretch, 1.0), 0.0).broken, 1);
  EXPECT_EQ(block.pinned(), 0);
}

TEST(PinnedJunction, carries_f_slip_of_the_same_sign_once_broken) {
  for (const double sign : {1.0, -1.0}) {
    Interface block(hand_made(1));
    EXPECT_EQ(block.move(sign * 0.3, 0.0).broken, 1);
    EXPECT_NEAR(block.friction(), sign * kSlipForce, kRounding);
    EXPECT_NEAR(block.attachment(), sign * (0.3 - kSlipStretch), kRounding);
  }
}

TEST(PinnedJunction, breaks_when_the_normal_force_falls) {
  // At f_N = 0.25 N: k_ij = 1 N/m, w = 0.25 m, f_thres = 0.1 N, f_slip = 0.0425 N.
  Interface block(hand_made(1));
  block.move(0.15, 0.0);
  block.press(0.25);
  EXPECT_EQ(block.move(0.15, 0.0).broken, 1);
  EXPECT_NEAR(block.friction(), 0.0425, kRounding);
}

TEST(PinnedJunction, keeps_its_stretch_when_the_normal_force_rises) {
  Interface block(hand_made(1));
  block.move(0.15, 0.0);
  block.press(4.0);  // k_ij = 4 N/m
  EXPECT_EQ(block.move(0.15, 0.0).broken, 0);
  EXPECT_NEAR(block.friction(), 0.6, kRounding);
}

TEST(SlippingJunction, trails_the_block_at_f_slip) {
  for (const double sign : {1.0, -1.0}) {
    Interface block(hand_made(1));
    for (const double u : {0.21, 0.25, 0.4, 2.0}) {
      block.move(sign * u, 1e-4);
      EXPECT_NEAR(block.friction(), sign * kSlipForce, kRounding);
      EXPECT_NEAR(block.attachment(), sign * (u - kSlipStretch), kRounding);
    }
  }
}

TEST(SlippingJunction, stays_put_while_a_reversed_force_is_within_f_slip) {
  Slipping block;
  const double attachment = block.attachment();
  for (const double back : {0.01, 0.085, 0.16, 0.03}) {
    block.move(Slipping::kBrokenAt - back, 1e-4);
    EXPECT_EQ(block.attachment(), attachment);
    EXPECT_NEAR(block.friction(), kSlipForce - 2.0 * back, kRounding);
  }
}

TEST(SlippingJunction, trails_in_the_reversed_direction_and_forwards_again) {
  Slipping block;
  block.move(-0.1, 1e-4);
  EXPECT_NEAR(block.friction(), -kSlipForce, kRounding);
  EXPECT_NEAR(block.attachment(), -0.1 + kSlipStretch, kRounding);
  block.move(0.0, 2e-4);  // within the play of 0.17 m: 0.1 m forwards add 0.2 N
  EXPECT_NEAR(block.friction(), -kSlipForce + 0.2, kRounding);
  block.move(0.2, 3e-4);
  EXPECT_NEAR(block.friction(), kSlipForce, kRounding);
  EXPECT_EQ(block.pinned(), 0);
}

TEST(SlippingJunction, does_not_break_again_however_far_the_block_jumps) {
  Slipping block;
  EXPECT_EQ(block.move(-5.0, 1e-4).broken, 0);
  EXPECT_EQ(block.junctions().draws(0, 0), 1U);
  EXPECT_NEAR(block.friction(), -kSlipForce, kRounding);
}

TEST(SlippingJunction, follows_f_slip_of_the_current_normal_force) {
  Slipping block;
  block.press(0.25);  // f_slip = 0.0425 N
  block.move(Slipping::kBrokenAt, 1e-4);
  EXPECT_NEAR(block.friction(), 0.0425, kRounding);
  block.press(1.0);  // trailed closer: 0.0425 m at 2 N/m, and no force pulls it away again
  block.move(Slipping::kBrokenAt, 2e-4);
  EXPECT_NEAR(block.friction(), 0.085, kRounding);
}

TEST(SlippingJunction, is_pinned_without_force_after_t_R) {
  Slipping block;
  EXPECT_EQ(block.move(0.3, std::nextafter(kSlippingTime, 0.0)).repinned, 0);
  EXPECT_NEAR(block.friction(), kSlipForce, kRounding);
  EXPECT_EQ(block.move(0.31, kSlippingTime).repinned, 1);
  EXPECT_EQ(block.friction(), 0.0);
  EXPECT_EQ(block.attachment(), 0.31);
  EXPECT_EQ(block.pinned(), 1);
  block.move(0.36, 3e-3);
  EXPECT_NEAR(block.friction(), 0.1, kRounding);
}

TEST(SlippingJunction, keeps_its_force_when_f_new_is_f_slip) {
  Parameters p = hand_made(1);
  p.f_new = NewForce::f_slip;
  Slipping block(p);
  EXPECT_EQ(block.move(0.31, kSlippingTime).repinned, 1);
  EXPECT_NEAR(block.friction(), kSlipForce, kRounding);
  EXPECT_EQ(block.pinned(), 1);
  // pinned where it is: 0.115 m more reach f_thres
  EXPECT_EQ(block.move(0.31 + 0.1149, 3e-3).broken, 0);
  EXPECT_EQ(block.move(0.31 + 0.1151, 3e-3).broken, 1);
}

TEST(SlippingJunction, is_pinned_inside_its_play_when_f_new_is_f_slip) {
  Parameters p = hand_made(1);
  p.f_new = NewForce::f_slip;
  Slipping block(p);
  block.move(Slipping::kBrokenAt - 0.085, 1e-3);  // reversed to zero force
  block.move(Slipping::kBrokenAt - 0.085, kSlippingTime);
  EXPECT_EQ(block.pinned(), 1);
  EXPECT_NEAR(block.friction(), 0.0, kRounding);
}

TEST(WithoutContact, there_is_no_friction_and_attachment_points_follow) {
  Interface block(hand_made(1));
  block.move(0.1, 0.0);
  block.press(0.0);
  for (const double u : {0.1, 5.0, -3.0}) {
    EXPECT_EQ(block.move(u, 1e-4).broken, 0);
    EXPECT_EQ(block.friction(), 0.0);
    EXPECT_EQ(block.attachment(), u);
  }
  EXPECT_EQ(block.pinned(), 1);
  block.press(1.0);
  block.move(-2.95, 2e-4);  // pressed again: the stretch is what the block moved since
  EXPECT_NEAR(block.friction(), 0.1, kRounding);
}

TEST(WithoutContact, slipping_times_run_on) {
  Slipping block;
  block.press(0.0);
  EXPECT_EQ(block.move(1.0, 1e-3).repinned, 0);
  EXPECT_EQ(block.pinned(), 0);
  EXPECT_EQ(block.move(1.0, kSlippingTime).repinned, 1);
  EXPECT_EQ(block.pinned(), 1);
}

TEST(WithoutContact, a_junction_still_slipping_when_pressed_again_slips_on) {
  Slipping block;
  block.press(0.0);
  block.move(1.0, 1e-3);
  block.press(1.0);
  block.move(1.05, 1.1e-3);  // 0.05 m of the play of 0.085 m
  EXPECT_NEAR(block.friction(), 0.1, kRounding);
  block.move(1.2, 1.2e-3);
  EXPECT_NEAR(block.friction(), kSlipForce, kRounding);
  EXPECT_EQ(block.move(1.2, kSlippingTime).repinned, 1);
}

TEST(WithoutContact, pinned_junctions_break_if_they_are_to) {
  Parameters p = hand_made(1);
  p.without_contact = WithoutContact::break_all;
  Interface block(p);
  block.move(0.1, 0.0);
  block.press(0.0);
  EXPECT_EQ(block.move(0.15, 1e-3).broken, 1);
  EXPECT_EQ(block.friction(), 0.0);
  EXPECT_EQ(block.move(0.2, 1.1e-3).broken, 0);
  EXPECT_EQ(block.attachment(), 0.2);
  block.press(1.0);
  block.move(0.5, 1.5e-3);
  EXPECT_NEAR(block.friction(), kSlipForce, kRounding) << "it slips when pressed again";
  EXPECT_EQ(block.move(0.5, 1e-3 + kSlippingTime).repinned, 1) << "t_R after it broke";
  EXPECT_EQ(block.move(0.51, 4e-3).broken, 0);
}

TEST(WithoutContact, what_is_pinned_in_the_air_breaks_again_if_it_is_to) {
  Parameters p = hand_made(1);
  p.without_contact = WithoutContact::break_all;
  Interface block(p);
  block.press(0.0);
  EXPECT_EQ(block.move(0.1, 0.0).broken, 1);
  EXPECT_EQ(block.move(0.1, kSlippingTime).repinned, 1);
  EXPECT_EQ(block.move(0.1, 1.1 * kSlippingTime).broken, 1);
  EXPECT_EQ(block.junctions().draws(0, 0), 2U);
}

TEST(SlippingTimes, each_break_draws_the_next_number_of_its_junction) {
  Parameters p = hand_made(3);
  p.delta_t_R = 0.6e-3;
  Interface block(p);
  double t = 0.0;
  for (std::uint32_t n = 0; n < 4; ++n) {
    block.move(block.u() + 0.21, t);
    for (std::uint32_t j = 0; j < 3; ++j) {
      EXPECT_EQ(block.junctions().draws(0, j), n + 1);
      EXPECT_EQ(block.junctions().repin_time(0, j), t + slipping_time(p, 0, j, n));
    }
    t += 1.0;  // all are pinned again
    block.move(block.u(), t);
    EXPECT_EQ(block.pinned(), 3);
  }
}

TEST(Claim1F, one_junction_rises_to_mu_s_drops_to_mu_d_and_is_zero_after_t_R) {
  Parameters p;  // the reference junction
  p.Nx = 1;
  p.N_s = 1;
  Interface block(p);
  const double f_N = mean_normal_force(Parameters{}) / 100.0;
  block.press(f_N);
  const double to_break = p.mu_s * f_N / block.k_ij();
  for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0 - 1e-13}) {
    block.move(part * to_break, 0.0);
    EXPECT_NEAR(block.friction() / f_N, 0.4 * part, 1e-12 * 0.4);
  }
  block.move(to_break * (1.0 + 1e-13), 0.0);
  EXPECT_NEAR(block.friction() / f_N, 0.17, 1e-12 * 0.17);
  const double t_R = slipping_time(p, 0, 0, 0);
  block.move(3.0 * to_break, 0.999 * t_R);
  EXPECT_NEAR(block.friction() / f_N, 0.17, 1e-12 * 0.17);
  block.move(3.0 * to_break, t_R);
  EXPECT_EQ(block.friction(), 0.0);
}

TEST(SeveralBlocks, draw_and_rub_independently) {
  Parameters p = hand_made(2);
  p.Nx = 3;
  p.delta_t_R = 0.6e-3;
  Junctions junctions = State(p).junctions;
  ReferenceLaw law(p, junctions);
  std::vector<double> u = {0.1, 0.21, 0.21}, p_i = {2.0, 2.0, 0.0}, k_ij = {2.0, 2.0, 0.0},
                      w = {0.5, 0.5, 0.0}, v(3), tau(3);
  const ContactView contact = {p_i.data(), k_ij.data(), w.data()};
  EXPECT_EQ(law.update(u.data(), v.data(), contact, 0.0).broken, 2);
  law.friction(u.data(), contact, tau.data());
  EXPECT_NEAR(tau[0], 2 * 0.2, kRounding);
  EXPECT_NEAR(tau[1], 2 * kSlipForce, kRounding);
  EXPECT_EQ(tau[2], 0.0);
  EXPECT_EQ(law.pinned(), (std::vector<std::int32_t>{2, 0, 2}));
  for (std::uint32_t j = 0; j < 2; ++j) {
    EXPECT_EQ(junctions.repin_time(1, j), slipping_time(p, 1, j, 0));
  }
}

}  // namespace
}  // namespace rupture
