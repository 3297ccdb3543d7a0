// Counter-based random numbers and the slipping times drawn from them.
// (Logarithm and normal quantile: any other digit of them changes the golden checksums.)
#include "rupture/model/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rupture/model/derived.hpp"

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

}  // namespace rupture::testing
