// Every branch of the distance law against sequences worked out by hand, for the junction of
// hand_made_interface.hpp: it breaks beyond a stretch of 0.2 m, trails at 0.085 m and 0.17 N, and
// is pinned again after sliding by 0.3 m.
#include "rupture/forces/distance_law.hpp"

#include <gtest/gtest.h>

#include "hand_made_interface.hpp"
#include "rupture/model/random.hpp"

namespace rupture {
namespace {

using testing::Interface;
using testing::kBreakStretch;
using testing::kRounding;
using testing::kSlipStretch;

constexpr double kBrokenAt = 0.21, kDistance = 0.3;  // [m]

Parameters distance(std::int64_t N_s) {
  Parameters p = testing::hand_made(N_s);
  p.law = Law::distance;
  p.d_R = kDistance;
  p.delta_d_R = 0.0;
  return p;
}

/// An interface with junctions that have just broken at u = 0.21 m.
class Broken : public Interface {
 public:
  explicit Broken(const Parameters& p = distance(1), double sign = 1.0) : Interface(p) {
    move(sign * kBrokenAt, 0.0);
  }
  double slip_left() { return junctions().slip_left(0, 0); }
};

TEST(DistanceLaw, is_elastic_up_to_f_thres_and_breaks_above_it) {
  for (const double sign : {1.0, -1.0}) {
    Interface block(distance(1));
    EXPECT_EQ(block.move(sign * kBreakStretch, 0.0).broken, 0);
    EXPECT_DOUBLE_EQ(block.friction(), sign * 0.4);
    EXPECT_EQ(block.junctions().slip_left(0, 0), 0.0);
    EXPECT_EQ(block.move(sign * kBrokenAt, 0.0).broken, 1);
    EXPECT_NEAR(block.friction(), sign * 0.17, kRounding);
    EXPECT_EQ(block.pinned(), 0);
    EXPECT_EQ(block.junctions().draws(0, 0), 1U);
    EXPECT_EQ(block.junctions().slip_left(0, 0), kDistance);
    EXPECT_EQ(block.junctions().repin_time(0, 0), Junctions::unknown);
  }
}

TEST(DistanceLaw, slides_with_f_slip_for_d_R_and_is_then_pinned_without_force) {
  for (const double sign : {1.0, -1.0}) {
    Broken block(distance(1), sign);
    EXPECT_EQ(block.move(sign * (kBrokenAt + 0.2), 1e-3).repinned, 0);
    EXPECT_NEAR(block.slip_left(), 0.1, kRounding);
    EXPECT_NEAR(block.friction(), sign * 0.17, kRounding);
    EXPECT_EQ(block.move(sign * (kBrokenAt + 0.29), 2e-3).repinned, 0);
    EXPECT_EQ(block.move(sign * (kBrokenAt + 0.31), 3e-3).repinned, 1);
    EXPECT_EQ(block.friction(), 0.0);
    EXPECT_EQ(block.attachment(), sign * (kBrokenAt + 0.31));
    EXPECT_EQ(block.slip_left(), 0.0);
    EXPECT_EQ(block.pinned(), 1);
  }
}

TEST(DistanceLaw, never_pins_a_junction_of_a_block_at_rest) {
  Broken block;
  EXPECT_EQ(block.move(kBrokenAt, 1e6).repinned, 0);
  EXPECT_NEAR(block.friction(), 0.17, kRounding);
  EXPECT_EQ(block.slip_left(), kDistance);
}

TEST(DistanceLaw, counts_sliding_in_either_direction_but_no_play) {
  for (const double sign : {1.0, -1.0}) {
    Broken block(distance(1), sign);
    block.move(sign * (kBrokenAt + 0.1), 1e-3);
    EXPECT_NEAR(block.slip_left(), 0.2, kRounding);
    const double edge = kBrokenAt + 0.1 - 2.0 * kSlipStretch;  // where it slides backwards
    block.move(sign * (edge + 1e-6), 2e-3);
    EXPECT_NEAR(block.slip_left(), 0.2, kRounding) << "turned back, inside the play";
    block.move(sign * (edge - 0.1), 3e-3);
    EXPECT_NEAR(block.slip_left(), 0.1, kRounding);
    EXPECT_NEAR(block.friction(), sign * -0.17, kRounding);
    EXPECT_EQ(block.move(sign * (edge - 0.21), 4e-3).repinned, 1);
    EXPECT_EQ(block.friction(), 0.0);
  }
}

TEST(DistanceLaw, keeps_its_force_when_f_new_is_f_slip) {
  for (const double sign : {1.0, -1.0}) {
    Parameters p = distance(1);
    p.f_new = NewForce::f_slip;
    Broken block(p, sign);
    EXPECT_EQ(block.move(sign * (kBrokenAt + 0.4), 1e-3).repinned, 1);
    EXPECT_NEAR(block.friction(), sign * 0.17, kRounding);
  }
}

TEST(DistanceLaw, breaks_again_with_the_next_distance) {
  Parameters p = distance(1);
  p.delta_d_R = 0.1;
  Broken block(p);
  EXPECT_EQ(block.slip_left(), folded_gaussian(p.d_R, p.delta_d_R, p.seed, 0, 0, 0));
  block.move(5.0, 1e-3);
  EXPECT_EQ(block.move(5.0 + 0.9 * kBreakStretch, 2e-3).broken, 0);
  EXPECT_EQ(block.move(5.0 + 1.1 * kBreakStretch, 3e-3).broken, 1);
  EXPECT_EQ(block.slip_left(), folded_gaussian(p.d_R, p.delta_d_R, p.seed, 0, 0, 1));
}

TEST(DistanceLaw, pins_each_junction_after_its_own_distance) {
  Parameters p = distance(9);
  p.delta_d_R = 0.1;
  Broken block(p);
  block.move(kBrokenAt + kDistance, 1e-3);
  std::int32_t expected = 0;
  for (std::uint32_t j = 0; j < 9; ++j) {
    expected += folded_gaussian(p.d_R, p.delta_d_R, p.seed, 0, j, 0) <= kDistance ? 1 : 0;
  }
  EXPECT_GT(expected, 0);
  EXPECT_LT(expected, 9);
  EXPECT_EQ(block.pinned(), expected);
}

TEST(DistanceLaw, slides_when_the_normal_force_falls) {
  Broken block;
  block.press(0.25);  // k_ij = 1 N/m, w = 0.25 m: trails at 0.0425 m
  block.move(kBrokenAt, 1e-3);
  EXPECT_NEAR(block.friction(), 0.17 * 0.25, kRounding);
  EXPECT_NEAR(block.slip_left(), kDistance - kSlipStretch / 2.0, kRounding);
}

TEST(DistanceLaw, follows_a_block_without_contact_and_does_not_slide) {
  for (const double sign : {1.0, -1.0}) {
    Broken block(distance(1), sign);
    block.press(0.0);
    for (const double u : {1.0, -3.0}) {
      EXPECT_EQ(block.move(u, 1e-3).repinned, 0);
      EXPECT_EQ(block.friction(), 0.0);
      EXPECT_EQ(block.attachment(), u);
    }
    EXPECT_EQ(block.slip_left(), kDistance);
    block.press(1.0);
    block.move(-3.0 + sign * (kSlipStretch + 0.1), 2e-3);
    EXPECT_NEAR(block.friction(), sign * 0.17, kRounding);
    EXPECT_NEAR(block.slip_left(), 0.2, kRounding);
  }
}

/// Of two junctions that have broken, the first is pinned again.
TEST(ChangeOfLaw, lets_slipping_junctions_begin_anew) {
  Parameters by_time = testing::hand_made(2), by_distance = distance(2);
  by_distance.t_R = by_time.t_R;
  Interface block(by_time);
  block.move(kBrokenAt, 0.0);
  Junctions junctions = block.junctions();
  junctions.repin_time(0, 0) = Junctions::never;

  change_law(by_time, by_distance, 1.0, junctions);
  EXPECT_EQ(junctions.slip_left(0, 0), 0.0);
  EXPECT_EQ(junctions.repin_time(0, 0), Junctions::never);
  EXPECT_EQ(junctions.slip_left(0, 1), kDistance);
  EXPECT_EQ(junctions.repin_time(0, 1), Junctions::unknown);
  EXPECT_EQ(junctions.draws(0, 1), 2U);

  change_law(by_distance, by_time, 1.5, junctions);
  EXPECT_EQ(junctions.slip_left.size(), 0);
  EXPECT_EQ(junctions.repin_time(0, 0), Junctions::never);
  EXPECT_EQ(junctions.repin_time(0, 1), 1.5 + by_time.t_R);
  EXPECT_TRUE((junctions.attachment == block.junctions().attachment).all());
}

TEST(ChangeOfLaw, leaves_the_junctions_as_they_are_where_both_laws_know_the_time) {
  Parameters before = testing::hand_made(1), after = before;
  after.law = Law::decaying;
  Interface block(before);
  block.move(kBrokenAt, 0.0);
  Junctions junctions = block.junctions();
  change_law(before, after, 1e-3, junctions);
  EXPECT_EQ(junctions.repin_time(0, 0), before.t_R);
  EXPECT_EQ(junctions.draws(0, 0), 1U);
}

}  // namespace
}  // namespace rupture
