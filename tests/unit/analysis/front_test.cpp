// Rupture fronts measured in made-up rupture lines of known speed, on the reference slider: blocks
// 2.5 mm apart, slow below c_s/20 = 48.4 m/s.
#include "rupture/analysis/front.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "rupture/analysis/statistics.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::testing {

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

RuptureLine slow_between(std::size_t first, std::size_t last, double speed = kSlow) {
  return line_of([=](std::size_t n) { return n >= first && n < last ? speed : kFast; });
}

void arrest_behind(RuptureLine& line, std::size_t last) {
  for (std::size_t n = last + 1; n < kBlocks; ++n) line.t_rupture[n].reset();
}

Front measure(RuptureLine line, const FrontCriteria& criteria = {}) {
  return measure_front(Parameters{}, std::move(line), criteria);
}

constexpr FrontCriteria kRaw = {.line = Line::raw};

TEST(FrontSpeed, has_no_value_near_the_edges_and_holes_or_where_the_ends_rupture_at_once) {
  RuptureLine line = line_of([](std::size_t) { return kFast; });
  line.t_rupture[30].reset();
  line.t_rupture[12] = line.t_rupture[8];
  const auto v_c = front_speed(line.x, line.t_rupture, {});
  for (const std::size_t i : {0U, 1U, 55U, 56U, 28U, 30U, 32U, 10U}) EXPECT_FALSE(v_c[i]) << i;
  for (const std::size_t i : {2U, 54U, 27U, 29U, 31U, 33U}) EXPECT_TRUE(v_c[i]) << i;
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
  EXPECT_DOUBLE_EQ(front.slow->x_to, 28 * kSpacing) << "the last with a whole stencil";
  EXPECT_TRUE(front.slow->fast_before);
  EXPECT_FALSE(front.slow->fast_after);
}

TEST(Front, tells_its_slowest_and_its_mean_speed) {
  const auto line = line_of([](std::size_t n) {
    if (n == 28) return 4.0;
    return n >= 20 && n < 35 ? kSlow : kFast;
  });
  const Front front = measure(line);
  ASSERT_TRUE(front.slow);
  EXPECT_NEAR(front.slow->slowest, 4.0 / (3.0 / kSlow + 1.0 / 4.0), 1e-6);
  ASSERT_TRUE(front.slow->mean_speed());
  // between blocks 19 and 36, the first and last stencils with a slow interval
  EXPECT_NEAR(*front.slow->mean_speed(), 17.0 / (14.0 / kSlow + 1.0 / 4.0 + 2.0 / kFast), 1e-6);
  EXPECT_NEAR(front.slow->speed, kSlow, 1e-6);
}

TEST(Front, is_slow_by_the_magnitude_of_its_speed_but_counts_forwards_only) {
  const Front front = measure(slow_between(20, 25, -kSlow), kRaw);
  EXPECT_EQ(front.type, FrontType::slow);
  EXPECT_FALSE(front.slow);
  EXPECT_EQ(front.backward_stencils, 8U) << "around blocks 19 to 26";
  const Front later = measure(line_of([](std::size_t n) {
                                if (n >= 38 && n < 50)
                                  return -0.5 * kFast;  // seen by stencils around blocks 38 to 50
                                return n >= 20 && n < 35 ? kSlow : kFast;
                              }),
                              kRaw);
  EXPECT_EQ(later.backward_stencils, 13U);
  EXPECT_NEAR(later.slow->fast_after.value(), kFast, 1e-4) << "no median holds them";
}

TEST(Front, is_fast_slow_fast_by_the_papers_words) {
  const auto is_so = [](const RuptureLine& line) {
    return measure(line).fast_slow_fast == Answer::yes;
  };
  EXPECT_TRUE(is_so(slow_between(20, 35)));
  EXPECT_TRUE(is_so(slow_between(20, 35, 60.0))) << "c_s/16, and so never below c_s/20";
  EXPECT_FALSE(is_so(slow_between(20, 23, 65.0))) << "two stencils";
  EXPECT_TRUE(is_so(slow_between(20, 24, 65.0))) << "three stencils";
  EXPECT_FALSE(is_so(slow_between(20, 35, kFast)));
  const auto at_100 = [](std::size_t n) { return n >= 20 && n < 35 ? kSlow : 100.0; };
  EXPECT_TRUE(is_so(line_of(at_100))) << "little more than c_s/10 before and after";
  EXPECT_FALSE(is_so(slow_between(0, 35))) << "nothing before";
  EXPECT_FALSE(is_so(slow_between(20, kBlocks))) << "nothing after";
  const auto also_at_80 = [](std::size_t from, std::size_t to) {  // [m/s], c_s/12
    return line_of([=](std::size_t n) {
      if (n >= from && n < to) return 80.0;
      return n >= 30 && n < 40 ? kSlow : kFast;
    });
  };
  EXPECT_TRUE(is_so(also_at_80(9, 15)));
  EXPECT_FALSE(is_so(also_at_80(9, 25))) << "the median before it";
  EXPECT_FALSE(is_so(also_at_80(45, 56))) << "the median after it";
  RuptureLine arrested = slow_between(20, 35);
  arrest_behind(arrested, 50);
  EXPECT_EQ(measure(arrested).fast_slow_fast, Answer::no);
  const SlowStretch slow = measure(slow_between(20, 35)).in_words.value();
  EXPECT_EQ(std::pair(slow.x_from, slow.x_to), std::pair(arrested.x[19], arrested.x[36]));
  EXPECT_NEAR(measure(slow_between(20, 35)).speed.value(), kFast, 1e-4);
}

// --- the contiguous front

TEST(Front, jumps_over_blocks_that_had_ruptured_and_is_fast_there) {
  RuptureLine line = slow_between(20, 35);
  for (std::size_t n = 24; n < 30; ++n) line.t_rupture[n] = 0.9;  // at block 30, it has all
  const Front front = measure(line);
  EXPECT_EQ(front.t_front[26], front.t_front[23]);
  EXPECT_FALSE(front.v_c[26]);
  ASSERT_TRUE(front.slow);
  EXPECT_EQ(front.slow->x_from, line.x[19]);
  EXPECT_EQ(front.slow->x_to, line.x[36]) << "the jump cuts no stretch";
  EXPECT_EQ(front.slow->stencils, 15U) << "18 without those around blocks 25 to 27";
  for (std::size_t n = 37; n < 57; ++n) line.t_rupture[n] = 0.9;
  EXPECT_FALSE(measure(line).slow->fast_after) << "a jump has no speed";
}

// --- the slow stretch

/// The front is slow between blocks 20 and 35, at 5 m/s; everywhere else each interval has another
/// speed, so that the medians tell which stencils they are of. With h blocks on either side of its
/// centre, a stencil is slow if its centre lies between blocks 21 - h and 34 + h.
class SlowStretchOf : public ::testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Stencil, SlowStretchOf, ::testing::Values(3U, 5U, 7U));

TEST_P(SlowStretchOf, goes_from_its_first_to_its_last_stencil) {
  const RuptureLine line = line_of([](std::size_t n) {
    return n >= 20 && n < 35 ? 5.0 : kFast + 10.0 * static_cast<double>(n);
  });
  const std::size_t h = GetParam() / 2, first = 21 - h, last = 34 + h;
  const auto median_of = [&](std::size_t from, std::size_t to) {
    std::vector<double> v_c;
    for (std::size_t i = from; i <= to; ++i) {
      v_c.push_back((line.x[i + h] - line.x[i - h]) /
                    (*line.t_rupture[i + h] - *line.t_rupture[i - h]));
    }
    return median(v_c);
  };
  const Front front = measure(line, {.stencil = GetParam()});
  ASSERT_TRUE(front.slow);
  EXPECT_EQ(front.slow->x_from, line.x[first]);
  EXPECT_EQ(front.slow->x_to, line.x[last]);
  EXPECT_EQ(front.slow->t_from, line.t_rupture[first]);
  EXPECT_EQ(front.slow->t_to, line.t_rupture[last]);
  EXPECT_EQ(front.slow->stencils, last - first + 1);
  EXPECT_EQ(front.slow->speed, median_of(first, last));
  EXPECT_EQ(front.slow->fast_before, median_of(9, first - h - 1)) << "beyond the loading zone";
  EXPECT_EQ(front.slow->fast_after, median_of(last + h + 1, kBlocks - 1 - h));
}

TEST(SlowStretch, is_measured_as_the_twelve_blocks_in_docs_claims_md_show) {
  RuptureLine line;
  for (const double ms : {0.00, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.57, 0.02, 0.59, 0.60}) {
    line.x.push_back(static_cast<double>(line.x.size()) * kSpacing);
    line.t_rupture.push_back(1e-3 * ms);
  }
  Parameters p;
  p.Nx = 12;
  const Front front = measure_front(p, line, {.skip_below_x = 0.0});
  EXPECT_EQ(front.t_front[9], 0.57e-3);
  EXPECT_EQ(front.ahead, 1U);
  const double c_s = shear_wave_speed(Parameters{});
  const SlowStretch slow = front.slow.value();
  EXPECT_EQ(std::pair(slow.x_from, slow.x_to), std::pair(line.x[6], line.x[9]));
  EXPECT_NEAR(slow.duration().value(), 0.51e-3, 1e-12);
  EXPECT_NEAR(c_s / slow.slowest, 51, 0.5);
  EXPECT_NEAR(c_s / slow.fast_before.value(), 4, 0.5);
  EXPECT_FALSE(slow.fast_after);
  EXPECT_NEAR(slow.mean_speed().value(), 7.5e-3 / 0.51e-3, 1e-6);
}

TEST(Front, has_the_speed_beyond_the_loading_zone) {
  RuptureLine line = slow_between(0, 9);
  arrest_behind(line, 16);
  EXPECT_NEAR(measure(line).speed.value(), kFast, 1e-4)
      << "of 6 stencils, the first two are slower";
}

TEST(SlowStretch, does_not_reach_into_the_loading_zone) {
  EXPECT_EQ(measure(slow_between(5, 35)).slow->x_from, 9 * kSpacing);
}

TEST(SlowStretch, of_a_single_stencil_has_no_duration_and_no_mean_speed) {
  const double limit =
      66.0 / shear_wave_speed(Parameters{});  // a stencil with one fast interval: 75
  const Front front = measure(slow_between(20, 24, 60.0), {.slow_below = limit});
  ASSERT_TRUE(front.slow);
  EXPECT_EQ(front.slow->x_from, 22 * kSpacing);
  EXPECT_EQ(front.slow->x_from, front.slow->x_to);
  EXPECT_FALSE(front.slow->duration());
  EXPECT_FALSE(front.slow->mean_speed());
}

TEST(SlowStretch, in_words_is_below_a_tenth_of_the_speed_of_shear_waves) {
  const double limit = shear_wave_speed(Parameters{}) / 10.0;
  EXPECT_TRUE(measure(slow_between(20, 35, 0.999 * limit)).in_words);
  EXPECT_FALSE(measure(slow_between(20, 35, 1.001 * limit)).in_words);
}

}  // namespace rupture::testing
