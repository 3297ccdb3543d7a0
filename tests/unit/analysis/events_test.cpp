// Splitting a made-up record into events.
#include <gtest/gtest.h>

#include "rupture/analysis/front.hpp"

namespace rupture {
namespace {

constexpr double kBlockSpacing = 2.5e-3;  // of the reference slider [m]
constexpr double kQuiet = 0.010;          // [s]

/// Blocks 0, 1, 2 at 0.1 s; blocks 3 and 1 at 0.2 s, 5 ms apart; the last block at 0.3 s.
const std::vector<Rupture> kRuptures = {{100, 0.100, 0}, {101, 0.101, 2}, {102, 0.102, 1},
                                        {200, 0.200, 3}, {205, 0.205, 1}, {300, 0.300, 56}};
const std::vector<double> kTime = {0.0, 0.09, 0.105, 0.115, 0.199, 0.21, 0.29, 0.305, 0.5};
const std::vector<double> kForce = {10, 50, 30, 20, 60, 40, 80, 70, 5};

std::vector<Event> events(double quiet = kQuiet) {
  return find_events(Parameters{}, kRuptures, {kTime, kForce}, quiet, FrontCriteria{});
}

TEST(Events, are_split_by_quiet_times) {
  const auto found = events();
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].t_start, 0.100);
  EXPECT_EQ(found[0].t_end, 0.102);
  EXPECT_EQ(found[1].t_start, 0.200);
  EXPECT_EQ(found[1].t_end, 0.205);
  EXPECT_EQ(found[2].t_start, 0.300);
  EXPECT_EQ(found[2].t_end, 0.300);
  EXPECT_EQ(events(0.2).size(), 1U);
  EXPECT_EQ(events(0.004).size(), 4U);
  EXPECT_EQ(events(1e-4).size(), 6U);
}

TEST(Events, tell_where_they_began_and_how_far_they_reached) {
  const auto found = events();
  EXPECT_DOUBLE_EQ(found[0].x_first, 0.0);
  EXPECT_DOUBLE_EQ(found[0].x_last, 2 * kBlockSpacing);
  EXPECT_DOUBLE_EQ(found[1].x_first, 3 * kBlockSpacing);
  EXPECT_DOUBLE_EQ(found[1].x_last, 3 * kBlockSpacing);
  EXPECT_DOUBLE_EQ(found[2].x_last, 56 * kBlockSpacing);
}

TEST(Events, tell_the_driving_force_before_and_its_smallest_value_until_it_is_quiet) {
  const auto found = events();
  EXPECT_EQ(found[0].F_T_before, 50.0) << "the last sample before";
  EXPECT_EQ(found[0].F_T_after, 30.0) << "the 20 N at 0.115 s come after the quiet time";
  EXPECT_EQ(found[1].F_T_before, 60.0);
  EXPECT_EQ(found[1].F_T_after, 40.0);
  EXPECT_EQ(found[2].F_T_before, 80.0);
  EXPECT_EQ(found[2].F_T_after, 70.0);
}

TEST(Events, carry_the_front_of_their_own_ruptures) {
  const auto found = events();
  EXPECT_EQ(found[0].front.line.t_rupture[1], 0.102);
  EXPECT_EQ(found[0].front.line.t_rupture[3], std::nullopt);
  EXPECT_EQ(found[1].front.line.t_rupture[1], 0.205);
  EXPECT_EQ(found[0].front.type, FrontType::arrested);
  EXPECT_EQ(found[2].front.type, FrontType::arrested) << "one block, at the leading edge";
}

TEST(Events, are_none_without_ruptures) {
  EXPECT_TRUE(find_events(Parameters{}, {}, {kTime, kForce}, kQuiet, FrontCriteria{}).empty());
}

}  // namespace
}  // namespace rupture
