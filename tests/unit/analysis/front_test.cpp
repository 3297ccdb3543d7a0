// Rupture fronts measured in made-up rupture lines of known speed, on the reference slider: blocks
// 2.5 mm apart, slow below c_s/20 = 48.4 m/s. Splitting a made-up record into events.
#include "rupture/analysis/front.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "rupture/analysis/statistics.hpp"
#include "rupture/model/derived.hpp"

namespace rupture {
namespace {

constexpr std::size_t kBlocks = 57;
constexpr double kSpacing = 2.5e-3;            // [m]
constexpr double kFast = 300.0, kSlow = 10.0;  // [m/s]

/// A front that runs from block n to block n + 1 at speed(n), starting at block 0 at t = 1 s.
RuptureLine line_of(const std::function<double(std::size_t)>& speed) {
  RuptureLine line;
  double t = 1.0;
  for (std::size_t n = 0; n < kBlocks; ++n) {
    line.x.push_back(static_cast<double>(n) * kSpacing);
    line.t_rupture.push_back(t);
    t += kSpacing / speed(n);
  }
  return line;
}

RuptureLine slow_between(std::size_t first, std::size_t last) {
  return line_of([=](std::size_t n) { return n >= first && n < last ? kSlow : kFast; });
}

void arrest_behind(RuptureLine& line, std::size_t last) {
  for (std::size_t n = last + 1; n < kBlocks; ++n) line.t_rupture[n].reset();
}

Front measure(RuptureLine line, const FrontCriteria& criteria = {}) {
  return measure_front(Parameters{}, std::move(line), criteria);
}

TEST(RuptureLine, holds_the_first_rupture_of_each_block_in_the_window) {
  const std::vector<Rupture> ruptures = {{1, 0.1, 3}, {2, 0.2, 3}, {3, 0.3, 4},
                                         {4, 0.4, 3}, {5, 0.5, 5}, {6, 0.25, 6}};
  const RuptureLine line = rupture_line(Parameters{}, ruptures, 0.2, 0.4);
  ASSERT_EQ(line.x.size(), kBlocks);
  ASSERT_EQ(line.t_rupture.size(), kBlocks);
  EXPECT_DOUBLE_EQ(line.x[4], 4 * kSpacing);
  EXPECT_EQ(line.t_rupture[3], 0.2);
  EXPECT_EQ(line.t_rupture[4], 0.3);
  EXPECT_EQ(line.t_rupture[5], std::nullopt);
  EXPECT_EQ(line.t_rupture[6], 0.25);
  EXPECT_EQ(line.t_rupture[0], std::nullopt);
}

TEST(FrontSpeed, is_the_inverse_slope_over_the_stencil) {
  // blocks 20-24 take 3 fast intervals and a slow one
  const auto v_c = front_speed(slow_between(23, 40), {});
  EXPECT_NEAR(*v_c[22], 4.0 / (3.0 / kFast + 1.0 / kSlow), 1e-6);
  const auto v_3 = front_speed(slow_between(23, 40), {.stencil = 3});
  EXPECT_NEAR(*v_3[22], kFast, 1e-6 * kFast);
  EXPECT_NEAR(*v_3[23], 2.0 / (1.0 / kFast + 1.0 / kSlow), 1e-6);
  const auto v_7 = front_speed(slow_between(23, 40), {.stencil = 7});
  EXPECT_NEAR(*v_7[22], 6.0 / (4.0 / kFast + 2.0 / kSlow), 1e-6);
  EXPECT_FALSE(v_7[2]);
  EXPECT_TRUE(v_7[3]);
}

TEST(FrontSpeed, has_no_value_near_the_edges_and_holes_or_where_the_ends_rupture_at_once) {
  RuptureLine line = line_of([](std::size_t) { return kFast; });
  line.t_rupture[30].reset();
  line.t_rupture[12] = line.t_rupture[8];
  const auto v_c = front_speed(line, {});
  for (const std::size_t i : {0U, 1U, 55U, 56U, 28U, 30U, 32U, 10U}) EXPECT_FALSE(v_c[i]) << i;
  for (const std::size_t i : {2U, 54U, 27U, 29U, 31U, 33U}) EXPECT_TRUE(v_c[i]) << i;
}

TEST(Front, that_does_not_reach_the_leading_edge_is_arrested) {
  RuptureLine line = slow_between(20, 35);
  arrest_behind(line, 40);
  const Front front = measure(line);
  EXPECT_EQ(front.type, FrontType::arrested);
  ASSERT_TRUE(front.x_arrest);
  EXPECT_DOUBLE_EQ(*front.x_arrest, 40 * kSpacing);
  EXPECT_TRUE(front.slow) << "its slow stretch is still told";
}

TEST(Front, spans_if_more_than_half_rupture_and_the_edge_not_first) {
  const auto is_spanned_from = [](std::size_t first) {  // 48 blocks count, from block 9 on
    RuptureLine line = line_of([](std::size_t) { return kFast; });
    for (std::size_t n = 0; n < first; ++n) line.t_rupture[n].reset();
    return spans(measure(line).type);
  };
  EXPECT_TRUE(is_spanned_from(32)) << "25 of 48";
  EXPECT_FALSE(is_spanned_from(33)) << "24 of 48";
  EXPECT_FALSE(is_spanned_from(56)) << "one block at the edge";
  RuptureLine line = line_of([](std::size_t) { return kFast; });
  std::reverse(line.t_rupture.begin(), line.t_rupture.end());
  EXPECT_EQ(measure(line).type, FrontType::arrested) << "it runs backwards from the edge";
  EXPECT_TRUE(measure(line).reached_edge);
  EXPECT_DOUBLE_EQ(*measure(line).x_arrest, 56 * kSpacing);
  line.t_rupture[8] = *line.t_rupture[56] - 1e-6;
  EXPECT_FALSE(spans(measure(line).type)) << "the one before it is in the loading zone";
  line.t_rupture[30] = line.t_rupture[56];
  EXPECT_FALSE(spans(measure(line).type)) << "the edge is the first with another";
  line.t_rupture[30] = *line.t_rupture[56] - 1e-6;
  EXPECT_TRUE(spans(measure(line).type)) << "the edge is the second";
}

TEST(Front, that_arrests_in_its_slow_stretch_has_no_speed_after_it) {
  RuptureLine line = slow_between(20, kBlocks);
  arrest_behind(line, 30);
  const Front front = measure(line);
  ASSERT_TRUE(front.slow);
  EXPECT_DOUBLE_EQ(front.slow->x_to, 26 * kSpacing) << "28 is the last with a whole stencil";
  EXPECT_TRUE(front.slow->fast_before);
  EXPECT_FALSE(front.slow->fast_after);
}

TEST(Front, is_slow_by_the_criteria_given) {
  const double c_s = shear_wave_speed(Parameters{});
  const RuptureLine fast = line_of([](std::size_t) { return kFast; });
  const RuptureLine at_first = slow_between(0, 5);  // seen by stencils up to block 6, 15 mm
  EXPECT_EQ(measure(at_first).type, FrontType::fast) << "in the loading zone";
  EXPECT_EQ(measure(at_first, {.skip_below_x = 0.005}).type, FrontType::slow);
  EXPECT_EQ(measure(slow_between(20, 35), {.slow_below = 0.5 * kSlow / c_s}).type, FrontType::fast);
  EXPECT_EQ(measure(fast, {.slow_below = 2.0 * kFast / c_s}).type, FrontType::slow);
}

TEST(Front, tells_of_the_slow_stretch_that_lasted_longest) {
  // ten blocks at 40 m/s last less than five at 10 m/s
  const auto line = line_of([](std::size_t n) {
    if (n >= 12 && n < 22) return 40.0;
    return n >= 35 && n < 40 ? kSlow : kFast;
  });
  const Front front = measure(line);
  ASSERT_TRUE(front.slow);
  EXPECT_GT(front.slow->x_from, 30 * kSpacing);
}

TEST(Front, tells_its_slowest_and_its_mean_speed) {
  const auto line = line_of([](std::size_t n) {
    if (n == 28) return 4.0;
    return n >= 20 && n < 35 ? kSlow : kFast;
  });
  const Front front = measure(line);
  ASSERT_TRUE(front.slow);
  EXPECT_NEAR(front.slow->slowest, 4.0 / (3.0 / kSlow + 1.0 / 4.0), 1e-6);
  ASSERT_TRUE(front.slow->mean());
  EXPECT_NEAR(*front.slow->mean(), 13.0 / (12.0 / kSlow + 1.0 / 4.0), 1e-6);
  EXPECT_NEAR(front.slow->speed, kSlow, 1e-6);
}

TEST(Front, is_slow_by_the_magnitude_of_its_speed_but_counts_forwards_only) {
  const Front front =
      measure(line_of([](std::size_t n) { return n >= 20 && n < 25 ? -kSlow : kFast; }));
  EXPECT_EQ(front.type, FrontType::slow);
  EXPECT_FALSE(front.slow);
  EXPECT_EQ(front.backward_stencils, 8U) << "around blocks 19 to 26";
  const Front later = measure(line_of([](std::size_t n) {
    if (n >= 38 && n < 50) return -0.5 * kFast;  // seen by stencils around blocks 38 to 50
    return n >= 20 && n < 35 ? kSlow : kFast;
  }));
  EXPECT_EQ(later.backward_stencils, 13U);
  EXPECT_NEAR(later.slow->fast_after.value(), kFast, 1e-4) << "no median holds them";
}

TEST(Front, is_fast_slow_fast_by_the_papers_words) {
  const auto is_so = [](double speed, std::size_t from, std::size_t to, double beside = kFast,
                        std::size_t beside_from = 0, std::size_t beside_to = 0) {
    return measure(line_of([=](std::size_t n) {
             if (n >= beside_from && n < beside_to) return beside;
             return n >= from && n < to ? speed : kFast;
           }))
        .fast_slow_fast;
  };
  EXPECT_TRUE(is_so(kSlow, 20, 35));
  EXPECT_TRUE(is_so(60.0, 20, 35)) << "c_s/16, and so never below c_s/20";
  EXPECT_FALSE(is_so(65.0, 20, 23)) << "two stencils";
  EXPECT_TRUE(is_so(65.0, 20, 24)) << "three stencils";
  EXPECT_FALSE(is_so(kFast, 20, 35));
  EXPECT_FALSE(is_so(kSlow, 0, 35)) << "nothing before";
  EXPECT_FALSE(is_so(kSlow, 20, kBlocks)) << "nothing after";
  EXPECT_TRUE(is_so(kSlow, 30, 40, 80.0, 9, 15));
  EXPECT_FALSE(is_so(kSlow, 30, 40, 80.0, 9, 25)) << "median before it: c_s/12";
  EXPECT_FALSE(is_so(kSlow, 30, 40, 80.0, 45, 56)) << "median after it: c_s/12";
  RuptureLine arrested = slow_between(20, 35);
  arrest_behind(arrested, 50);
  EXPECT_FALSE(measure(arrested).fast_slow_fast);
  const SlowStretch slow = measure(slow_between(20, 35)).in_words.value();
  EXPECT_EQ(std::pair(slow.x_from, slow.x_to), std::pair(arrested.x[17], arrested.x[38]))
      << "two blocks on either side of the stencils that touch the slow stretch";
  EXPECT_NEAR(measure(slow_between(20, 35)).speed.value(), kFast, 1e-4);
}

TEST(Front, may_skip_a_block_in_its_slow_stretch) {
  RuptureLine line = slow_between(20, 40);
  line.t_rupture[30].reset();
  const Front front = measure(line);
  EXPECT_EQ(front.type, FrontType::slow);
  ASSERT_TRUE(front.slow);
  EXPECT_LE(front.slow->x_to, 41 * kSpacing);
}

// --- stencils at the ends of the slow stretch

/// Centres that count: to the slow stretch, and next to it to the fast sides.
struct Centres {
  std::size_t slow_from, slow_to, before_to, after_from;
};

/// The front is slow between blocks 20 and 35, at 5 m/s; everywhere else each interval has another
/// speed, so that the medians tell which stencils they are of. With h blocks on either side of its
/// centre, a stencil is slow if its centre lies between blocks 21 - h and 34 + h.
class StencilAtEnds : public ::testing::TestWithParam<std::size_t> {
 protected:
  static constexpr std::size_t kFirstCounted = 9;  // the first beyond the loading zone

  void expect_centres(const Centres& centres, StencilsAtEnds rule) const {
    const FrontCriteria criteria = {.stencil = GetParam(), .stencils_at_ends = rule};
    const Front front = measure(line_, criteria);
    ASSERT_EQ(front.type, FrontType::slow);
    EXPECT_FALSE(front.x_arrest);
    ASSERT_TRUE(front.slow);
    EXPECT_EQ(front.slow->x_from, line_.x[centres.slow_from]);
    EXPECT_EQ(front.slow->x_to, line_.x[centres.slow_to]);
    EXPECT_EQ(front.slow->t_from, line_.t_rupture[centres.slow_from]);
    EXPECT_EQ(front.slow->t_to, line_.t_rupture[centres.slow_to]);
    EXPECT_EQ(front.slow->speed, median_of(centres.slow_from, centres.slow_to));
    EXPECT_EQ(front.slow->fast_before, median_of(kFirstCounted, centres.before_to));
    EXPECT_EQ(front.slow->fast_after, median_of(centres.after_from, kBlocks - 1 - h_));
  }

  const std::size_t h_ = GetParam() / 2;

 private:
  /// Median of v_c at blocks from..to.
  std::optional<double> median_of(std::size_t from, std::size_t to) const {
    std::vector<double> v_c;
    for (std::size_t i = from; i <= to; ++i) {
      v_c.push_back((line_.x[i + h_] - line_.x[i - h_]) /
                    (*line_.t_rupture[i + h_] - *line_.t_rupture[i - h_]));
    }
    return median(v_c);
  }

  const RuptureLine line_ = line_of([](std::size_t n) {
    return n >= 20 && n < 35 ? 5.0 : kFast + 10.0 * static_cast<double>(n);
  });
};

INSTANTIATE_TEST_SUITE_P(Front, StencilAtEnds, ::testing::Values(3U, 5U, 7U));

TEST_P(StencilAtEnds, counts_to_neither_to_the_slow_stretch_or_to_the_fast_sides) {
  const std::size_t first = 21 - h_, last = 34 + h_;  // centres of slow stencils
  expect_centres({first + h_, last - h_, first - h_ - 1, last + h_ + 1}, StencilsAtEnds::neither);
  expect_centres({first - h_, last + h_, first - h_ - 1, last + h_ + 1}, StencilsAtEnds::slow);
  expect_centres({first + h_, last - h_, first + h_ - 1, last - h_ + 1}, StencilsAtEnds::fast);
}

FrontCriteria with_ends(StencilsAtEnds rule) {
  return {.stencils_at_ends = rule};
}

TEST(SlowStretches, grow_only_over_stencils_that_exist_and_not_into_the_loading_zone) {
  const FrontCriteria slow = with_ends(StencilsAtEnds::slow);
  EXPECT_DOUBLE_EQ(measure(slow_between(50, kBlocks), slow).slow->x_to, 54 * kSpacing);
  RuptureLine line = slow_between(20, 35);
  arrest_behind(line, 37);  // the last stencil is that around block 35
  EXPECT_DOUBLE_EQ(measure(line, slow).slow->x_to, 35 * kSpacing);
  EXPECT_DOUBLE_EQ(measure(slow_between(11, 35), slow).slow->x_from, 9 * kSpacing);
}

TEST(SlowStretches, grow_only_while_blocks_rupture_one_after_the_other) {
  RuptureLine line = slow_between(20, 35);
  line.t_rupture[18] = *line.t_rupture[19] + 1e-7;
  line.t_rupture[38] = *line.t_rupture[37] - 1e-7;
  const Front front = measure(line, with_ends(StencilsAtEnds::slow));
  EXPECT_DOUBLE_EQ(front.slow->x_from, 19 * kSpacing);
  EXPECT_DOUBLE_EQ(front.slow->x_to, 37 * kSpacing);
}

TEST(SlowStretches, of_a_single_block_have_no_mean_speed) {
  const Front front = measure(slow_between(20, 22));  // slow stencils around blocks 19 to 23
  ASSERT_TRUE(front.slow);
  EXPECT_EQ(front.slow->x_from, front.slow->x_to);
  EXPECT_GT(front.slow->speed, 0.0);
  EXPECT_FALSE(front.slow->mean());
}

TEST(SlowStretches, shorter_than_a_stencil_are_none_but_the_front_is_slow) {
  const RuptureLine line = slow_between(20, 21);  // slow stencils around blocks 19 to 22
  for (const auto rule : {StencilsAtEnds::neither, StencilsAtEnds::fast}) {
    const Front front = measure(line, with_ends(rule));
    EXPECT_EQ(front.type, FrontType::slow);
    EXPECT_FALSE(front.slow);
  }
  const Front front = measure(line, with_ends(StencilsAtEnds::slow));
  ASSERT_TRUE(front.slow);
  EXPECT_DOUBLE_EQ(front.slow->x_from, 17 * kSpacing);
  EXPECT_DOUBLE_EQ(front.slow->x_to, 24 * kSpacing);
}

TEST(SlowStretches, are_compared_by_the_blocks_that_count) {
  // one interval at 0.5 m/s lasts longer than five at 10 m/s, but is shorter than a stencil
  const auto line = line_of([](std::size_t n) {
    if (n == 15) return 0.5;
    return n >= 35 && n < 40 ? kSlow : kFast;
  });
  EXPECT_DOUBLE_EQ(measure(line).slow->x_from, 36 * kSpacing);
  EXPECT_LT(measure(line, with_ends(StencilsAtEnds::slow)).slow->x_from, 15 * kSpacing);
}

// --- events

constexpr double kQuiet = 0.010;  // [s]

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
  const std::vector<Expected> expected = {{0.100, 0.102, 0.0, 2 * kSpacing, 50.0, 30.0},
                                          {0.200, 0.205, 3 * kSpacing, 3 * kSpacing, 60.0, 40.0},
                                          {0.300, 0.300, 56 * kSpacing, 56 * kSpacing, 80.0, 70.0}};
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

TEST(Events, carry_the_front_of_their_own_ruptures) {
  const auto found = events();
  EXPECT_EQ(found[0].front.line.t_rupture[1], 0.102);
  EXPECT_EQ(found[0].front.line.t_rupture[3], std::nullopt);
  EXPECT_EQ(found[1].front.line.t_rupture[1], 0.205);
  EXPECT_EQ(found[0].front.type, FrontType::arrested);
  EXPECT_EQ(found[2].front.type, FrontType::arrested) << "one block, at the leading edge";
}

}  // namespace
}  // namespace rupture
