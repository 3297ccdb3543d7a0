// Splitting a made-up record of the reference slider into events.
#include <gtest/gtest.h>

#include "rupture/analysis/front.hpp"

namespace rupture::testing {

constexpr double kQuiet = 0.010;   // [s]
constexpr double kApart = 2.5e-3;  // blocks [m]

/// Blocks 0, 1, 2 at 0.1 s; blocks 3 and 1 at 0.2 s, 5 ms apart; the last block at 0.3 s.
const std::vector<Rupture> kRuptures = {{100, 0.100, 0}, {101, 0.101, 2}, {102, 0.102, 1},
                                        {200, 0.200, 3}, {205, 0.205, 1}, {300, 0.300, 56}};
const std::vector<double> kTime = {0.0, 0.09, 0.105, 0.115, 0.199, 0.21, 0.29, 0.305, 0.5};
const std::vector<double> kForce = {10, 50, 30, 20, 60, 40, 80, 70, 5};

std::vector<Event> events(double quiet = kQuiet) {
  return find_events(Parameters{}, kRuptures, {kTime, kForce}, quiet, FrontCriteria{});
}

TEST(Events, are_split_by_quiet_times) {
  EXPECT_EQ(events(0.2).size(), 1U);
  EXPECT_EQ(events(0.004).size(), 4U);
  EXPECT_EQ(events(1e-4).size(), 6U);
}

TEST(Events, tell_times_places_and_the_force_before_and_its_smallest_value_until_it_is_quiet) {
  struct Expected {
    double t_start, t_end, x_first, x_last, F_T_before, F_T_after;
  };
  // the last force before each event; the 20 N at 0.115 s come after the quiet time
  const std::vector<Expected> expected = {{0.100, 0.102, 0.0, 2 * kApart, 50.0, 30.0},
                                          {0.200, 0.205, 3 * kApart, 3 * kApart, 60.0, 40.0},
                                          {0.300, 0.300, 56 * kApart, 56 * kApart, 80.0, 70.0}};
  const auto found = events();
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t n = 0; n < found.size(); ++n) {
    EXPECT_EQ(found[n].t_start, expected[n].t_start);
    EXPECT_EQ(found[n].t_end, expected[n].t_end);
    EXPECT_DOUBLE_EQ(found[n].x_first, expected[n].x_first);
    EXPECT_DOUBLE_EQ(found[n].x_last, expected[n].x_last);
    EXPECT_EQ(found[n].F_T_before, expected[n].F_T_before);
    EXPECT_EQ(found[n].F_T_after, expected[n].F_T_after);
  }
}

/// Ruptures at 1.0 s, 1.25 s and 1.5 s are an event that is over at 1.75 s.
struct ForceByHand {
  const char* why;
  std::vector<double> time, F_T;
  double before, after;
};

TEST(Events, have_the_force_of_the_right_samples) {
  const std::vector<Rupture> ruptures = {{100, 1.0, 0}, {125, 1.25, 1}, {150, 1.5, 2}};
  const std::vector<ForceByHand> all = {
      {"a sample at its start is before it", {0.5, 1.0, 1.25, 3}, {5, 4, 3, 0}, 4, 3},
      {"it falls within the event", {0.5, 1.25, 1.5, 1.75, 3}, {5, 2, 4, 4.5, 0}, 5, 2},
      {"it falls until it is quiet", {0.5, 1.5, 1.75, 2, 3}, {5, 4, 3, 1, 0}, 5, 3},
      {"there is no sample in that time", {0.5, 2, 3}, {5, 1, 0}, 5, 5},
      {"it rises", {0.5, 1.0, 1.5, 3}, {5, 6, 7, 0}, 6, 6},
      {"it began before the first sample", {1.25, 1.5, 3}, {4, 5, 0}, 5, 5}};
  for (const ForceByHand& row : all) {
    SCOPED_TRACE(row.why);
    const auto found = find_events(Parameters{}, ruptures, {row.time, row.F_T}, 0.25, {});
    ASSERT_EQ(found.size(), 1U) << "pauses of just 0.25 s";
    EXPECT_EQ(found[0].F_T_before, row.before);
    EXPECT_EQ(found[0].F_T_after, row.after);
  }
}

TEST(Events, carry_the_front_of_their_own_ruptures) {
  const auto found = events();
  EXPECT_EQ(found[0].front.line.t_rupture[1], 0.102);
  EXPECT_EQ(found[0].front.line.t_rupture[3], std::nullopt);
  EXPECT_EQ(found[1].front.line.t_rupture[1], 0.205);
  EXPECT_EQ(found[0].front.type, FrontType::arrested);
  EXPECT_EQ(found[2].front.type, FrontType::arrested) << "one block, at the leading edge";
}

}  // namespace rupture::testing
