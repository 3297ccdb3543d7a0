// Counter-based random numbers and the slipping times drawn from them.
#include "rupture/model/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace rupture {
namespace {

constexpr auto kAnyPurpose = Purpose::slipping;

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

TEST(Uniform, differs_when_any_argument_differs) {
  const std::set<double> numbers = {uniform(1, 2, 3, Purpose::slipping, 4),
                                    uniform(9, 2, 3, Purpose::slipping, 4),
                                    uniform(1, 9, 3, Purpose::slipping, 4),
                                    uniform(1, 2, 9, Purpose::slipping, 4),
                                    uniform(1, 2, 3, Purpose::force_distribution, 4),
                                    uniform(1, 2, 3, Purpose::slipping, 9),
                                    uniform(1 + (std::int64_t{1} << 32), 2, 3, kAnyPurpose, 4)};
  EXPECT_EQ(numbers.size(), 7U);
}

struct Moments {
  double mean = 0, sd = 0, smallest = 0, largest = 0;
};

constexpr std::uint32_t kDraws = 200000;

template <class Draw>
Moments moments(const Draw& draw) {
  Moments m{0, 0, draw(0), draw(0)};
  double squares = 0;
  for (std::uint32_t n = 0; n < kDraws; ++n) {
    const double x = draw(n);
    m.mean += x / kDraws;
    squares += x * x / kDraws;
    m.smallest = std::min(m.smallest, x);
    m.largest = std::max(m.largest, x);
  }
  m.sd = std::sqrt(squares - m.mean * m.mean);
  return m;
}

/// Four standard errors of the mean of kDraws numbers with standard deviation sd; the seed is
/// fixed, so a test that passes passes for ever.
double four_errors(double sd) {
  return 4.0 * sd / std::sqrt(static_cast<double>(kDraws));
}

TEST(Uniform, fills_the_open_interval_evenly) {
  const auto m =
      moments([](std::uint32_t n) { return uniform(1, n / 100, n % 100, kAnyPurpose, n); });
  const double sd = 1.0 / std::sqrt(12.0);
  EXPECT_NEAR(m.mean, 0.5, four_errors(sd));
  EXPECT_NEAR(m.sd, sd, four_errors(sd));
  EXPECT_GT(m.smallest, 0.0);
  EXPECT_LT(m.largest, 1.0);
  EXPECT_LT(m.smallest, 1e-4);  // 20 numbers are expected below, 20 above
  EXPECT_GT(m.largest, 1.0 - 1e-4);
}

Moments slipping_times(const Parameters& p) {
  return moments([&](std::uint32_t n) { return slipping_time(p, n / 1000, n % 1000, n % 7); });
}

TEST(SlippingTime, has_mean_and_spread_of_the_gaussian) {
  const Parameters p;  // 2 +- 0.6 ms: folding changes neither moment by 1e-3
  const auto m = slipping_times(p);
  EXPECT_NEAR(m.mean, p.t_R, four_errors(p.delta_t_R));
  EXPECT_NEAR(m.sd, p.delta_t_R, four_errors(p.delta_t_R));
  EXPECT_GT(m.smallest, 0.0);
}

TEST(SlippingTime, has_mean_and_spread_of_a_strongly_folded_gaussian) {
  Parameters p;
  p.delta_t_R = p.t_R;
  // |N(mu, sigma)|: mean = sigma sqrt(2/pi) exp(-mu^2/2 sigma^2) + mu erf(mu/(sigma sqrt 2)),
  // mean square = mu^2 + sigma^2
  const double mean = p.t_R * (std::sqrt(2.0 / std::numbers::pi) * std::exp(-0.5) +
                               std::erf(1.0 / std::numbers::sqrt2));
  const double sd = std::sqrt(2.0 * p.t_R * p.t_R - mean * mean);
  const auto m = slipping_times(p);
  EXPECT_NEAR(m.mean, mean, four_errors(sd));
  EXPECT_NEAR(m.sd, sd, four_errors(sd));
  EXPECT_GE(m.smallest, 0.0);
}

TEST(SlippingTime, has_mean_and_spread_of_the_exponential) {
  Parameters p;
  p.slipping_times = SlippingTimes::exponential;
  const auto m = slipping_times(p);
  EXPECT_NEAR(m.mean, p.t_R, four_errors(p.t_R));
  // the variance of x^2 is 8 sd^4, of the sd about 2 sd^2
  EXPECT_NEAR(m.sd, p.t_R, four_errors(std::sqrt(2.0) * p.t_R));
  EXPECT_GT(m.smallest, 0.0);
}

TEST(SlippingTime, is_exact_without_spread) {
  Parameters p;
  p.delta_t_R = 0.0;
  EXPECT_EQ(slipping_time(p, 1, 2, 3), p.t_R);
}

}  // namespace
}  // namespace rupture
