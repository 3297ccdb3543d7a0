#include "rupture/model/random.hpp"

#include <Random123/philox.h>

#include <cmath>

#include "rupture/model/exact_math.hpp"

namespace rupture {

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
    return -p.t_R * exact_log(uniform(p.seed, block, junction, Purpose::slipping, n));
  }
  return folded_gaussian(p.t_R, p.delta_t_R, p.seed, block, junction, n);
}

}  // namespace rupture
