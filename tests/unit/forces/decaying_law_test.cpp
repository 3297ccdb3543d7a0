// Every branch of the decaying interface law against sequences worked out by hand, for the junction
// of hand_made_interface.hpp with mu_d = 0.2 and mu_new = 0.12: broken, it carries 0.2 N at first
// and 0.12 N after 2 ms, 0.04 N less per millisecond.
#include "rupture/forces/decaying_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hand_made_interface.hpp"
#include "rupture/model/random.hpp"

namespace rupture {
namespace {

using testing::Interface;
using testing::kBreakStretch;
using testing::kRounding;
using testing::kSlippingTime;

Parameters decaying(std::int64_t N_s) {
  Parameters p = testing::hand_made(N_s);
  p.law = Law::decaying;
  p.mu_d = 0.2;
  p.mu_new = 0.12;
  return p;
}

/// An interface with one junction that has just broken at u = 0.21 m, t = 0.
class Decaying : public Interface {
 public:
  explicit Decaying(const Parameters& p = decaying(1), double sign = 1.0) : Interface(p) {
    move(sign * kBrokenAt, 0.0);
  }
  static constexpr double kBrokenAt = 0.21;
};

TEST(DecayingLaw, is_elastic_up_to_f_thres_and_breaks_above_it) {
  for (const double sign : {1.0, -1.0}) {
    Interface block(decaying(1));
    block.move(sign * 0.1, 0.0);
    EXPECT_DOUBLE_EQ(block.friction(), sign * 0.2);
    EXPECT_EQ(block.move(sign * kBreakStretch, 0.0).broken, 0);
    EXPECT_EQ(block.move(sign * std::nextafter(kBreakStretch, 1.0), 0.0).broken, 1);
    EXPECT_NEAR(block.friction(), sign * 0.2, kRounding) << "mu_d f_N";
    EXPECT_EQ(block.pinned(), 0);
    EXPECT_EQ(block.junctions().draws(0, 0), 1U);
  }
}

TEST(DecayingLaw, lets_the_force_fall_linearly_under_a_block_at_rest) {
  for (const double sign : {1.0, -1.0}) {
    Decaying block(decaying(1), sign);
    for (const double part : {0.0, 0.25, 0.5, 0.75, 0.9375}) {
      block.move(sign * Decaying::kBrokenAt, part * kSlippingTime);
      EXPECT_NEAR(block.friction(), sign * (0.2 - 0.08 * part), kRounding);
      EXPECT_NEAR(block.attachment(), sign * (0.21 - 0.1 + 0.04 * part), kRounding);
    }
    EXPECT_EQ(block.pinned(), 0);
  }
}

TEST(DecayingLaw, trails_a_moving_block_at_the_force_of_the_time) {
  for (const double sign : {1.0, -1.0}) {
    Decaying block(decaying(1), sign);
    block.move(sign * 0.3, 0.5e-3);
    EXPECT_NEAR(block.friction(), sign * 0.18, kRounding);
    block.move(sign * 2.0, 1.5e-3);
    EXPECT_NEAR(block.friction(), sign * 0.14, kRounding);
  }
}

TEST(DecayingLaw, stays_put_while_a_reversed_force_is_within_the_limit) {
  Decaying block;
  const double attachment = block.attachment();  // 0.11 m
  for (const double u : {0.18, 0.11, 0.04}) {    // |f| <= 0.14 N
    block.move(u, 1e-3);                         // limit 0.16 N
    EXPECT_EQ(block.attachment(), attachment);
    EXPECT_NEAR(block.friction(), 2.0 * (u - 0.11), kRounding);
  }
  block.move(0.02, 1e-3);
  EXPECT_NEAR(block.friction(), -0.16, kRounding) << "trails in the reversed direction";
  block.move(0.02, 1.5e-3);
  EXPECT_NEAR(block.friction(), -0.14, kRounding) << "and decays there too";
}

TEST(DecayingLaw, pins_with_f_new_after_t_R) {
  for (const double sign : {1.0, -1.0}) {
    Decaying block(decaying(1), sign);
    EXPECT_EQ(block.move(sign * 0.3, std::nextafter(kSlippingTime, 0.0)).repinned, 0);
    EXPECT_NEAR(block.friction(), sign * 0.12, kRounding);
    EXPECT_EQ(block.move(sign * 0.31, kSlippingTime).repinned, 1);
    EXPECT_NEAR(block.friction(), sign * 0.12, kRounding);
    EXPECT_EQ(block.pinned(), 1);
    const double attachment = block.attachment();
    // from 0.12 N it takes 0.14 m to f_thres
    EXPECT_EQ(block.move(sign * (0.31 + 0.1399), 3e-3).broken, 0);
    EXPECT_EQ(block.attachment(), attachment);
    EXPECT_EQ(block.move(sign * (0.31 + 0.1401), 4e-3).broken, 1);
    EXPECT_NEAR(block.friction(), sign * 0.2, kRounding) << "a new slip begins at mu_d f_N";
    block.move(sign * 0.5, 5e-3);
    EXPECT_NEAR(block.friction(), sign * 0.16, kRounding) << "and decays from its own beginning";
  }
}

TEST(DecayingLaw, pins_a_late_junction_with_f_new) {
  Decaying block;
  EXPECT_EQ(block.move(0.3, 2.0 * kSlippingTime).repinned, 1);
  EXPECT_NEAR(block.friction(), 0.12, kRounding);
}

TEST(DecayingLaw, pins_inside_the_play_with_the_force_there_is) {
  Decaying block;
  block.move(0.11 + 0.01, 1e-3);
  block.move(0.11 + 0.01, kSlippingTime);
  EXPECT_EQ(block.pinned(), 1);
  EXPECT_NEAR(block.friction(), 0.02, kRounding);
}

TEST(DecayingLaw, pins_with_exactly_f_new_if_it_is_to) {
  Parameters p = decaying(1);
  p.repin = Repin::exact;
  for (const double sign : {1.0, -1.0}) {
    for (const double force : {0.02, -0.02, 0.12}) {  // 0.11 m is the attachment point
      Decaying block(p, sign);
      block.move(sign * (0.11 + 0.5 * force), kSlippingTime);
      EXPECT_EQ(block.pinned(), 1);
      EXPECT_NEAR(block.friction(), std::copysign(0.12, sign * force), kRounding);
    }
  }
}

TEST(DecayingLaw, pins_without_force_where_there_is_none_even_if_exact) {
  Parameters p = decaying(1);
  p.repin = Repin::exact;
  Decaying block(p);
  block.move(block.attachment(), kSlippingTime);
  EXPECT_EQ(block.pinned(), 1);
  EXPECT_EQ(block.friction(), 0.0);
}

TEST(DecayingLaw, pins_a_sliding_junction_with_f_new_exactly_or_as_it_is_alike) {
  Parameters p = decaying(1);
  p.repin = Repin::exact;
  Decaying exact(p), as_is;
  for (const double t : {1e-3, kSlippingTime, 3e-3}) {
    exact.move(0.3 + t, t);
    as_is.move(0.3 + t, t);
    EXPECT_NEAR(exact.friction(), as_is.friction(), kRounding);
  }
}

TEST(DecayingLaw, ends_without_force_if_mu_new_is_zero) {
  Parameters p = decaying(1);
  p.mu_new = 0.0;
  Decaying block(p);
  block.move(0.21, 1e-3);
  EXPECT_NEAR(block.friction(), 0.1, kRounding);
  block.move(0.21, kSlippingTime);
  EXPECT_EQ(block.friction(), 0.0);
}

TEST(DecayingLaw, follows_the_current_normal_force) {
  Decaying block;
  block.press(0.25);  // k_ij = 1 N/m, w = 0.25 m
  block.move(Decaying::kBrokenAt, 1e-3);
  EXPECT_NEAR(block.friction(), 0.16 * 0.25, kRounding);
  block.move(Decaying::kBrokenAt, kSlippingTime);
  EXPECT_NEAR(block.friction(), 0.12 * 0.25, kRounding);
}

TEST(DecayingLaw, has_no_friction_without_contact_and_its_time_runs_on) {
  for (const double sign : {1.0, -1.0}) {
    Decaying block(decaying(1), sign);
    block.press(0.0);
    for (const double u : {1.0, -3.0}) {
      EXPECT_EQ(block.move(u, 0.2e-3).broken, 0);
      EXPECT_EQ(block.friction(), 0.0);
      EXPECT_EQ(block.attachment(), u);
    }
    block.press(1.0);
    block.move(-3.0 + sign * 0.5, 0.5e-3);
    EXPECT_NEAR(block.friction(), sign * 0.18, kRounding);
    block.press(0.0);
    EXPECT_EQ(block.move(1.0, kSlippingTime).repinned, 1);
    EXPECT_EQ(block.move(0.5, 3e-3).broken, 0) << "pinned: follows the block";
    EXPECT_EQ(block.attachment(), 0.5);
    EXPECT_EQ(block.pinned(), 1);
  }
}

TEST(DecayingLaw, lets_each_junction_decay_in_its_own_slipping_time) {
  Parameters p = decaying(9);
  p.delta_t_R = 0.2e-3;
  Decaying block(p);
  const double t = 0.7e-3;  // all still slip
  block.move(0.4, t);
  double expected = 0.0;
  for (std::uint32_t j = 0; j < 9; ++j) {
    expected += 0.2 - 0.08 * t / slipping_time(p, 0, j, 0);
  }
  EXPECT_EQ(block.pinned(), 0);
  EXPECT_NEAR(block.friction(), expected, 20 * kRounding);
}

TEST(DecayingLaw, takes_up_a_slip_in_progress_from_the_junctions_alone) {
  const Parameters p = decaying(1);
  Decaying block(p);
  Junctions junctions = block.junctions();
  DecayingLaw law(p, junctions);
  double u = 0.5, v = 0.0, p_i = 1.0, k_ij = 2.0, w = 0.5, tau = 0.0;
  law.update(&u, &v, {&p_i, &k_ij, &w}, 1e-3);
  law.friction(&u, {&p_i, &k_ij, &w}, &tau);
  EXPECT_NEAR(tau, 0.16, kRounding);
  EXPECT_EQ(law.pinned()[0], 0);
}

TEST(DecayingLaw, stays_between_mu_d_and_mu_new_when_t_R_has_changed) {
  Decaying block;
  for (const double t_R : {1e-3, 8e-3}) {  // instead of 2 ms, of which 1 ms is left
    Parameters p = decaying(1);
    p.t_R = t_R;
    Junctions junctions = block.junctions();
    DecayingLaw law(p, junctions);
    double u = 0.5, v = 0.0, p_i = 1.0, k_ij = 2.0, w = 0.5, tau = 0.0;
    law.update(&u, &v, {&p_i, &k_ij, &w}, 1e-3 - 1e-6);
    law.friction(&u, {&p_i, &k_ij, &w}, &tau);
    EXPECT_NEAR(tau, t_R == 1e-3 ? 0.2 : 0.12 + 0.08 * 1.001 / 8.0, kRounding);
  }
}

}  // namespace
}  // namespace rupture
