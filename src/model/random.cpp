#include "rupture/model/random.hpp"

#include <Random123/philox.h>

#include <array>
#include <bit>
#include <cmath>

namespace rupture {
namespace {

template <std::size_t N>
double polynomial(const std::array<double, N>& coefficients, double x) {
  double sum = 0.0;
  for (std::size_t n = N; n-- > 0;) sum = sum * x + coefficients[n];
  return sum;
}

// AS 241: numerators and denominators for the centre, the tail and the far tail.
constexpr std::array<double, 8> kCentreTop = {3.3871328727963666080e0, 1.3314166789178437745e2,
                                              1.9715909503065514427e3, 1.3731693765509461125e4,
                                              4.5921953931549871457e4, 6.7265770927008700853e4,
                                              3.3430575583588128105e4, 2.5090809287301226727e3};
constexpr std::array<double, 8> kCentreBottom = {1.0000000000000000000e0, 4.2313330701600911252e1,
                                                 6.8718700749205790830e2, 5.3941960214247511077e3,
                                                 2.1213794301586595867e4, 3.9307895800092710610e4,
                                                 2.8729085735721942674e4, 5.2264952788528545610e3};
constexpr std::array<double, 8> kTailTop = {1.42343711074968357734e0,  4.63033784615654529590e0,
                                            5.76949722146069140550e0,  3.64784832476320460504e0,
                                            1.27045825245236838258e0,  2.41780725177450611770e-1,
                                            2.27238449892691845833e-2, 7.74545014278341407640e-4};
constexpr std::array<double, 8> kTailBottom = {
    1.00000000000000000000e0,  2.05319162663775882187e0,  1.67638483018380384940e0,
    6.89767334985100004550e-1, 1.48103976427480074590e-1, 1.51986665636164571966e-2,
    5.47593808499534494600e-4, 1.05075007164441684324e-9};
constexpr std::array<double, 8> kFarTop = {6.65790464350110377720e0,  5.46378491116411436990e0,
                                           1.78482653991729133580e0,  2.96560571828504891230e-1,
                                           2.65321895265761230930e-2, 1.24266094738807843860e-3,
                                           2.71155556874348757815e-5, 2.01033439929228813265e-7};
constexpr std::array<double, 8> kFarBottom = {
    1.00000000000000000000e0,  5.99832206555887937690e-1, 1.36929880922735805310e-1,
    1.48753612908506148525e-2, 7.86869131145613259100e-4, 1.84631831751005468180e-5,
    1.42151175831644588870e-7, 2.04426310338993978564e-15};

}  // namespace

double exact_log(double x) {
  // x = m 2^e with m in [sqrt(1/2), sqrt(2)); ln m = 2 artanh(s) with s = (m - 1)/(m + 1).
  const auto bits = std::bit_cast<std::uint64_t>(x);
  int exponent = static_cast<int>(bits >> 52) - 1023;
  auto m = std::bit_cast<double>((bits & 0xFFFFFFFFFFFFFull) | 0x3FF0000000000000ull);
  if (m > 1.4142135623730951) {
    m *= 0.5;
    ++exponent;
  }
  const double s = (m - 1.0) / (m + 1.0);
  const double s2 = s * s;
  double series = 0.0;
  for (int n = 23; n >= 1; n -= 2) series = series * s2 + 1.0 / n;
  // ln 2 in two pieces, the first of which times the exponent is exact
  constexpr double kLn2High = 0x1.62e42fefa38p-1;
  constexpr double kLn2Low = 0x1.ef35793c7673p-45;
  return exponent * kLn2High + (2.0 * s * series + exponent * kLn2Low);
}

double normal_quantile(double p) {
  const double q = p - 0.5;
  if (std::abs(q) <= 0.425) {
    const double r = 0.180625 - q * q;
    return q * polynomial(kCentreTop, r) / polynomial(kCentreBottom, r);
  }
  const double r = std::sqrt(-exact_log(q < 0.0 ? p : 1.0 - p));
  const double magnitude = r <= 5.0
                               ? polynomial(kTailTop, r - 1.6) / polynomial(kTailBottom, r - 1.6)
                               : polynomial(kFarTop, r - 5.0) / polynomial(kFarBottom, r - 5.0);
  return q < 0.0 ? -magnitude : magnitude;
}

double uniform(std::int64_t seed, std::uint32_t block, std::uint32_t junction, Purpose purpose,
               std::uint32_t n) {
  const auto key = static_cast<std::uint64_t>(seed);
  const r123::Philox4x32::ctr_type counter = {
      {block, junction, static_cast<std::uint32_t>(purpose), n}};
  const r123::Philox4x32::key_type keys = {
      {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)}};
  const auto word = r123::Philox4x32{}(counter, keys);
  const std::uint64_t bits = (std::uint64_t{word[0]} << 32) | word[1];
  return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;  // exact, so never rounded to 1
}

double folded_gaussian(double mean, double deviation, std::int64_t seed, std::uint32_t block,
                       std::uint32_t junction, std::uint32_t n) {
  const double u = uniform(seed, block, junction, Purpose::slipping, n);
  return std::abs(mean + deviation * normal_quantile(u));
}

double slipping_time(const Parameters& p, std::uint32_t block, std::uint32_t junction,
                     std::uint32_t n) {
  if (p.slipping_times == SlippingTimes::exponential) {
    return -p.t_R[block] * exact_log(uniform(p.seed, block, junction, Purpose::slipping, n));
  }
  return folded_gaussian(p.t_R[block], p.delta_t_R[block], p.seed, block, junction, n);
}

}  // namespace rupture
