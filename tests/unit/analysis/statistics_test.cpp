// Median and straight-line fit.
#include "rupture/analysis/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rupture::testing {

using Values = std::vector<double>;

TEST(Median, is_the_middle_value_or_the_mean_of_the_two_middle_ones) {
  EXPECT_EQ(median({}), std::nullopt);
  EXPECT_EQ(median({3.0}), 3.0);
  EXPECT_EQ(median({5.0, -1.0, 3.0}), 3.0);
  EXPECT_EQ(median({5.0, 1.0, 4.0, -100.0}), 2.5);
  EXPECT_EQ(median({2.0, 2.0, 9.0}), 2.0);
}

TEST(FitLine, finds_an_exact_line_also_a_flat_one) {
  const Values x = {0.0, 1.0, 4.0}, y = {7.0, 5.0, -1.0};
  const auto fit = fit_line(x, y);
  ASSERT_TRUE(fit);
  EXPECT_DOUBLE_EQ(fit->slope, -2.0);
  EXPECT_DOUBLE_EQ(fit->r_squared, 1.0);
  EXPECT_NEAR(fit->slope_error, 0.0, 1e-7);  // the root of rounding, 1e-15
  const auto flat = fit_line(x, Values{3.0, 3.0, 3.0});
  EXPECT_EQ(flat->slope, 0.0);
  EXPECT_EQ(flat->r_squared, 1.0);
}

TEST(FitLine, tells_how_well_it_fits) {
  // Slope 1.4, residuals (0.2, -0.6, 0.6, -0.2): sum of squares 0.8 of 10.6, with 2 degrees of
  // freedom and sum (x - <x>)^2 = 5.
  const Values x = {0.0, 1.0, 2.0, 3.0}, y = {1.0, 1.6, 4.2, 4.8};
  const auto fit = fit_line(x, y);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->slope, 1.4, 1e-14);
  EXPECT_NEAR(fit->r_squared, 1.0 - 0.8 / 10.6, 1e-14);
  EXPECT_NEAR(fit->rms, std::sqrt(0.8 / 4.0), 1e-14);
  EXPECT_NEAR(fit->slope_error, std::sqrt(0.8 / 2.0 / 5.0), 1e-14);
}

TEST(FitLine, keeps_its_digits_far_from_the_origin) {
  Values x, y;  // slip during 1 ms after 1 s
  for (int n = 0; n < 100; ++n) {
    x.push_back(1.0 + 1e-5 * n);
    y.push_back(1e-4 + 1e-3 * (x.back() - 1.0));
  }
  EXPECT_NEAR(fit_line(x, y)->slope, 1e-3, 1e-12);
}

TEST(FitLine, needs_three_points_with_different_x) {
  EXPECT_FALSE(fit_line(Values{0.0, 1.0}, Values{0.0, 1.0}));
  EXPECT_FALSE(fit_line(Values{1.0, 1.0, 1.0}, Values{0.0, 1.0, 2.0}));
  EXPECT_FALSE(fit_line(Values{0.0, 1.0, 2.0}, Values{0.0, 1.0}));
}

TEST(MeanOf, knows_how_well_it_is_known) {
  // deviations -2, -1, 0, 3: variance 14/3 with 3 degrees of freedom
  const auto mean = mean_of(Values{3.0, 4.0, 5.0, 8.0});
  ASSERT_TRUE(mean);
  EXPECT_DOUBLE_EQ(mean->value, 5.0);
  EXPECT_NEAR(mean->deviation, std::sqrt(14.0 / 3.0), 1e-14);
  EXPECT_NEAR(mean->standard_error, std::sqrt(14.0 / 3.0) / 2.0, 1e-14);
  EXPECT_FALSE(mean_of(Values{1.0})) << "needs two values";
}

}  // namespace rupture::testing
