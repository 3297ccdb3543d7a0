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

TEST(Window, does_not_take_a_block_that_ruptures_again_behind_the_front_for_the_front) {
  auto ruptures = ruptures_up_to(56);
  ruptures.push_back({0, t_of(70), 12});  // 10 blocks had ruptured, and one of them does again
  const Event whole = events_of(ruptures, 0.9, 2.0).at(0);
  const Event cut = events_of(ruptures, t_of(19), 2.0).at(0);
  EXPECT_EQ(cut.front.line.ruptured_before(), 20U);
  EXPECT_EQ(cut.t_start, t_of(20)) << "a block that ruptures in the first sample did so before";
  EXPECT_EQ(cut.front.line.t_rupture[12], std::nullopt);
  EXPECT_EQ(cut.front.line.before[12], t_of(12));
  EXPECT_EQ(cut.front.t_front[19], std::nullopt);
  for (std::size_t i = 0; i < 22; ++i) EXPECT_FALSE(cut.front.v_c[i]) << i;
  for (std::size_t i = 22; i < 57; ++i) EXPECT_EQ(cut.front.v_c[i], whole.front.v_c[i]) << i;
  EXPECT_EQ(cut.front.type, FrontType::fast);
  EXPECT_EQ(cut.front.backward_stencils, 0U);
}

TEST(Window, counts_what_ruptured_before_it_where_an_event_spans_or_arrests) {
  const Event spanning = events_of(ruptures_up_to(56), t_of(54), 2.0).at(0);
  EXPECT_EQ(spanning.front.type, FrontType::fast) << "two blocks rupture in it";
  const Event arrested = events_of(ruptures_up_to(30), t_of(25), 2.0).at(0);
  EXPECT_EQ(arrested.front.x_arrest, block_position({}, 30));
  auto far = ruptures_up_to(30);
  far.insert(far.begin(), {0, t_of(0), 40});
  const Event ahead = events_of(far, t_of(25), 2.0).at(0);
  EXPECT_EQ(ahead.front.x_arrest, block_position({}, 40)) << "alone, and before the window";
  EXPECT_EQ(ahead.x_last, block_position({}, 40));
}

TEST(Window, does_not_begin_with_an_event_that_is_over) {
  auto ruptures = ruptures_up_to(5);
  ruptures.push_back({0, t_of(5) + kPause + kPerBlock, 3});
  const auto events = events_of(ruptures, t_of(5), 2.0);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].front.line.ruptured_before(), 0U);
  EXPECT_EQ(events[0].front.line.t_rupture[3], ruptures.back().time);
}

TEST(Window, that_ends_before_the_event_is_over_does_not_say_where_it_arrests) {
  const double end = t_of(30);
  for (const double silence : {0.0, 0.999 * kPause, kPause}) {
    const Event event = events_of(ruptures_up_to(30), 0.9, end + silence).at(0);
    EXPECT_NEAR(event.silence, silence, 1e-12);
    const bool is_over = silence == kPause;
    EXPECT_EQ(event.front.line.is_over, is_over) << silence;
    EXPECT_EQ(event.front.type, is_over ? FrontType::arrested : FrontType::unfinished);
    EXPECT_EQ(event.front.x_arrest.has_value(), is_over);
    EXPECT_EQ(event.front.fast_slow_fast, is_over ? Answer::no : Answer::unknown);
  }
  const Event spanned = events_of(ruptures_up_to(56), 0.9, t_of(56)).at(0);
  EXPECT_EQ(spanned.front.type, FrontType::fast) << "nothing that follows can change that";
  EXPECT_EQ(spanned.front.fast_slow_fast, Answer::no);
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

TEST(Window, in_which_nothing_ruptures_shows_where_the_event_arrested) {
  RuptureLine line = rupture_line({}, ruptures_up_to(30), t_of(30) + kPerBlock, 2.0);
  EXPECT_EQ(measure_front({}, line, {}).type, FrontType::arrested);
  EXPECT_EQ(measure_front({}, line, {}).x_arrest, block_position({}, 30));
  line = rupture_line({}, ruptures_up_to(56), t_of(56) + kPerBlock, 2.0);
  EXPECT_EQ(measure_front({}, line, {}).type, FrontType::none) << "it had spanned before";
}

}  // namespace rupture::testing
