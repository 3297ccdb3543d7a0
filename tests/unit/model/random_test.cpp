// Counter-based random numbers and the slipping times drawn from them.
// Logarithm and normal quantile made of exact operations, against the C library.
#include "rupture/model/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/sliders.hpp"

namespace rupture::testing {

/// The uniform number that the first two words of a Philox output stand for.
double uniform_of(std::uint32_t first, std::uint32_t second) {
  const std::uint64_t bits = ((std::uint64_t{first} << 32) | second) >> 12;
  return (static_cast<double>(bits) + 0.5) * 0x1p-52;
}

// Known answers for philox4x32 with 10 rounds, from Random123's kat_vectors: counter (4 words), key
// (2 words, low word of the seed first), output (4 words, of which the first two are used).
TEST(Uniform, is_philox4x32_10) {
  EXPECT_EQ(uniform(0, 0, 0, Purpose{0}, 0), uniform_of(0x6627e8d5, 0xe169c58d));
  EXPECT_EQ(uniform(-1, 0xffffffff, 0xffffffff, Purpose{0xffffffff}, 0xffffffff),
            uniform_of(0x408f276d, 0x41c83b0e));
  EXPECT_EQ(uniform(0x299f31d0a4093822, 0x243f6a88, 0x85a308d3, Purpose{0x13198a2e}, 0x03707344),
            uniform_of(0xd16cfe09, 0x94fdcceb));
}

constexpr std::uint32_t kDraws = 200000;

/// Four standard errors of the mean of kDraws numbers with standard deviation
/// sd; the seed is fixed, so a test that passes passes for ever.
double four_errors(double sd) {
  return 4.0 * sd / std::sqrt(static_cast<double>(kDraws));
}

TEST(SlippingTime, has_mean_and_spread_of_its_distribution) {
  Parameters strongly_folded, exponential;
  strongly_folded.delta_t_R = strongly_folded.t_R;
  exponential.slipping_times = SlippingTimes::exponential;
  for (const Parameters& p : {Parameters{}, strongly_folded, exponential}) {
    const double mean = mean_slipping_time(p, 0);
    const bool folded = p.slipping_times == SlippingTimes::gaussian;  // mean square t_R^2 + sd^2
    const double sd =
        folded ? std::sqrt(p.t_R[0] * p.t_R[0] + p.delta_t_R[0] * p.delta_t_R[0] - mean * mean)
               : p.t_R[0];
    double sum = 0.0, squares = 0.0;
    for (std::uint32_t n = 0; n < kDraws; ++n) {
      const double t = slipping_time(p, n / 1000, n % 1000, n % 7);
      ASSERT_GT(t, 0.0);
      sum += t / kDraws;
      squares += t * t / kDraws;
    }
    EXPECT_NEAR(sum, mean, four_errors(sd));
    // of the exponential the variance of x^2 is 8 sd^4, of the sd about 2 sd^2
    EXPECT_NEAR(std::sqrt(squares - sum * sum), sd,
                four_errors(folded ? sd : std::numbers::sqrt2 * sd));
  }
}

// --- logarithm and normal quantile

void expect_log(double x) {
  // std::log itself may be off by 1e-16 of its value
  EXPECT_NEAR(exact_log(x), std::log(x), std::max(1e-15 * std::abs(std::log(x)), 1e-16)) << x;
}

TEST(ExactLog, agrees_with_the_library_over_all_magnitudes) {
  Noise noise(1.0);
  for (int exponent = -1021; exponent <= 1023; ++exponent) {
    for (int n = 0; n < 10; ++n) expect_log(std::ldexp(1.5 + 0.499 * noise(), exponent));
  }
  expect_log(std::numeric_limits<double>::min());
  expect_log(std::numeric_limits<double>::max());
}

TEST(ExactLog, agrees_with_the_library_near_one_and_at_its_branches) {
  EXPECT_EQ(exact_log(1.0), 0.0);
  for (const double centre : {0.5, std::sqrt(0.5), 1.0, std::sqrt(2.0), 2.0}) {
    for (double step = 1e-16; step < 0.1; step *= 3.0) {
      expect_log(centre * (1.0 + step));
      expect_log(centre * (1.0 - step));
    }
  }
}

/// Standard normal distribution function, accurate in the lower tail.
double Phi(double z) {
  return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

TEST(NormalQuantile, inverts_the_distribution_function) {
  for (int n = 1; n < 1000; ++n) {
    const double p = n / 1000.0;
    EXPECT_NEAR(Phi(normal_quantile(p)), p, 1e-14 * p) << p;
  }
  // dPhi/Phi = (z^2 + ...) dz/z: far out, rounding of z weighs z^2 times as much
  for (double p = 1e-3; p > 1e-30; p *= 0.1) {
    const double z = normal_quantile(p);
    EXPECT_NEAR(Phi(z), p, 1e-15 * (1.0 + z * z) * p) << p;
  }
}

TEST(NormalQuantile, is_antisymmetric_to_the_last_bit) {
  for (int n = 1; n < 4096; ++n) {
    const double p = n * 0x1p-13;  // 1 - p is exact
    EXPECT_EQ(normal_quantile(1.0 - p), -normal_quantile(p));
  }
}

}  // namespace rupture::testing
