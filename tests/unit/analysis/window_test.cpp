// What a window shows of an event that begins before it or goes on after it: the reference slider,
// whose front passes a block every 10 us, in an event from 1 s on.
#include <gtest/gtest.h>

#include "rupture/analysis/front.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::testing {

constexpr std::int64_t kInRow = 57;
constexpr double kPerBlock = 1e-5, kPause = 0.01;  // [s]

double t_of(std::int64_t block) {
  return 1.0 + static_cast<double>(block) * kPerBlock;
}

std::vector<Rupture> ruptures_up_to(std::int64_t last) {
  std::vector<Rupture> ruptures;
  for (std::int64_t i = 0; i <= last; ++i) ruptures.push_back({0, t_of(i), i});
  return ruptures;
}

std::vector<Event> events_of(const std::vector<Rupture>& ruptures, double from, double to) {
  const std::vector<double> time = {from, to}, F_T = {300.0, 200.0};
  return find_events(Parameters{}, ruptures, {time, F_T}, kPause, {});
}

TEST(Window, does_not_begin_with_an_event_that_is_over) {
  auto ruptures = ruptures_up_to(5);
  ruptures.push_back({0, t_of(5) + kPause + kPerBlock, 3});
  const auto events = events_of(ruptures, t_of(5), 2.0);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].front.line.ruptured_before(), 0U);
  EXPECT_EQ(events[0].front.line.t_rupture[3], ruptures.back().time);
}

TEST(Window, does_not_know_a_speed_before_the_slow_stretch_that_is_before_it) {
  std::vector<Rupture> ruptures;
  double t = 1.0;
  for (std::int64_t i = 0; i < kInRow; ++i) {
    ruptures.push_back({0, t, i});
    t += i >= 20 && i < 40 ? 2.5e-4 : kPerBlock;  // 10 m/s, and 250 m/s
  }
  const auto answer = [&](std::size_t first) {
    return events_of(ruptures, ruptures[first].time, 2.0).at(0).front.fast_slow_fast;
  };
  EXPECT_EQ(answer(8), Answer::yes);
  EXPECT_EQ(answer(22), Answer::unknown);
  EXPECT_EQ(answer(39), Answer::no) << "beyond the slow stretch";
}

}  // namespace rupture::testing
