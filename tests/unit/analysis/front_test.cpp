// Rupture fronts measured in made-up rupture lines of known speed, on the reference slider: blocks
// 2.5 mm apart, slow below c_s/20 = 48.4 m/s.
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

TEST(FrontSpeed, is_exact_for_a_constant_speed) {
  const auto v_c = front_speed(line_of([](std::size_t) { return kFast; }));
  for (std::size_t i = 2; i + 2 < kBlocks; ++i) {
    ASSERT_TRUE(v_c[i]) << i;
    EXPECT_NEAR(*v_c[i], kFast, 1e-7 * kFast) << i;  // t is known to 1e-16 s, of 33 us
  }
}

TEST(FrontSpeed, is_the_inverse_slope_over_five_blocks) {
  // blocks 20-24 take 3 fast intervals and a slow one
  const auto v_c = front_speed(slow_between(23, 40));
  EXPECT_NEAR(*v_c[22], 4.0 / (3.0 / kFast + 1.0 / kSlow), 1e-6);
}

TEST(FrontSpeed, has_no_value_near_the_edges_and_holes) {
  RuptureLine line = line_of([](std::size_t) { return kFast; });
  line.t_rupture[30].reset();
  const auto v_c = front_speed(line);
  for (const std::size_t i : {0U, 1U, 55U, 56U, 28U, 30U, 32U}) EXPECT_FALSE(v_c[i]) << i;
  for (const std::size_t i : {2U, 54U, 27U, 29U, 31U, 33U}) EXPECT_TRUE(v_c[i]) << i;
}

TEST(FrontSpeed, has_no_value_where_the_ends_rupture_at_once) {
  RuptureLine line = line_of([](std::size_t) { return kFast; });
  line.t_rupture[12] = line.t_rupture[8];
  EXPECT_FALSE(front_speed(line)[10]);
}

TEST(FrontSpeed, is_negative_towards_the_driven_edge) {
  RuptureLine line = line_of([](std::size_t) { return kFast; });
  std::reverse(line.t_rupture.begin(), line.t_rupture.end());
  EXPECT_NEAR(*front_speed(line)[20], -kFast, 1e-7 * kFast);
}

TEST(Front, without_a_slow_stretch_is_fast) {
  const Front front = measure(line_of([](std::size_t) { return kFast; }));
  EXPECT_EQ(front.type, FrontType::fast);
  EXPECT_FALSE(front.slow);
  EXPECT_FALSE(front.x_arrest);
}

TEST(Front, with_a_slow_stretch_is_slow_and_tells_where_and_how_slow) {
  // Slow from block 20 to 35. A stencil with one slow interval of four is slow already (36 m/s), so
  // the stretch reaches from block 19 to block 36.
  const Front front = measure(slow_between(20, 35));
  EXPECT_EQ(front.type, FrontType::slow);
  ASSERT_TRUE(front.slow);
  EXPECT_DOUBLE_EQ(front.slow->x_from, 19 * kSpacing);
  EXPECT_DOUBLE_EQ(front.slow->x_to, 36 * kSpacing);
  EXPECT_NEAR(front.slow->duration(), 15 * kSpacing / kSlow + 2 * kSpacing / kFast, 1e-12);
  EXPECT_NEAR(front.slow->t_from, 1.0 + 19 * kSpacing / kFast, 1e-12);
  EXPECT_NEAR(front.slow->speed, kSlow, 1e-6);
  ASSERT_TRUE(front.slow->fast_before);
  ASSERT_TRUE(front.slow->fast_after);
  EXPECT_NEAR(*front.slow->fast_before, kFast, 1e-4);
  EXPECT_NEAR(*front.slow->fast_after, kFast, 1e-4);
  EXPECT_FALSE(front.x_arrest);
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

TEST(Front, that_arrests_in_its_slow_stretch_has_no_speed_after_it) {
  RuptureLine line = slow_between(20, kBlocks);
  arrest_behind(line, 30);
  const Front front = measure(line);
  ASSERT_TRUE(front.slow);
  EXPECT_DOUBLE_EQ(front.slow->x_to, 28 * kSpacing) << "the last block with a whole stencil";
  EXPECT_TRUE(front.slow->fast_before);
  EXPECT_FALSE(front.slow->fast_after);
}

TEST(Front, is_not_slow_for_what_happens_in_the_loading_zone) {
  const Front front = measure(slow_between(0, 5));  // seen by stencils up to block 6, 15 mm
  EXPECT_EQ(front.type, FrontType::fast);
  FrontCriteria criteria;
  criteria.skip_below_x = 0.005;
  EXPECT_EQ(measure(slow_between(0, 5), criteria).type, FrontType::slow);
}

TEST(Front, is_slow_by_the_criterion_given) {
  FrontCriteria criteria;
  criteria.slow_below = 0.5 * kSlow / shear_wave_speed(Parameters{});
  EXPECT_EQ(measure(slow_between(20, 35), criteria).type, FrontType::fast);
  criteria.slow_below = 2.0 * kFast / shear_wave_speed(Parameters{});
  EXPECT_EQ(measure(line_of([](std::size_t) { return kFast; }), criteria).type, FrontType::slow);
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

TEST(Front, may_skip_a_block_in_its_slow_stretch) {
  RuptureLine line = slow_between(20, 40);
  line.t_rupture[30].reset();
  const Front front = measure(line);
  EXPECT_EQ(front.type, FrontType::slow);
  ASSERT_TRUE(front.slow);
  EXPECT_LE(front.slow->x_to, 41 * kSpacing);
}

TEST(Front, of_no_rupture_is_none) {
  RuptureLine line = slow_between(20, 35);
  for (auto& t : line.t_rupture) t.reset();
  const Front front = measure(line);
  EXPECT_EQ(front.type, FrontType::none);
  EXPECT_FALSE(front.x_arrest);
  EXPECT_FALSE(front.slow);
}

TEST(FrontTypes, have_names) {
  EXPECT_EQ(front_type_name(FrontType::none), "none");
  EXPECT_EQ(front_type_name(FrontType::arrested), "arrested");
  EXPECT_EQ(front_type_name(FrontType::slow), "slow");
  EXPECT_EQ(front_type_name(FrontType::fast), "fast");
}

TEST(FrontTypes, that_span_are_slow_and_fast) {
  EXPECT_FALSE(spans(FrontType::none));
  EXPECT_FALSE(spans(FrontType::arrested));
  EXPECT_TRUE(spans(FrontType::slow));
  EXPECT_TRUE(spans(FrontType::fast));
}

}  // namespace
}  // namespace rupture
