#include "rupture/model/phi_shape.hpp"

#include <cmath>

namespace rupture {
namespace {

/// Positive quantile of the bell: phi integrates to 1 - q = 5/4 y^4 - 3/4 y^5 with y = 1 - xi,
/// which falls monotonically in xi and is solved by bisection to the last bit.
double bell_quantile(double q) {
  double low = 0.0, high = 1.0;
  for (;;) {
    const double xi = 0.5 * (low + high);
    if (xi <= low || xi >= high) return xi;
    const double y = 1.0 - xi;
    const double y4 = (y * y) * (y * y);
    (1.25 * y4 - 0.75 * (y4 * y) > 1.0 - q ? low : high) = xi;
  }
}

}  // namespace

double unit_sigma(PhiShape shape) {
  return shape == PhiShape::uniform ? 1.0 / std::sqrt(3.0) : std::sqrt(2.0 / 21.0);
}

std::vector<double> unit_quantiles(PhiShape shape, std::int64_t n) {
  std::vector<double> quantiles(static_cast<std::size_t>(n), 0.0);
  for (std::int64_t j = 0; j < n / 2; ++j) {
    const double q = 1.0 - (static_cast<double>(j) + 0.5) / static_cast<double>(n);
    const double xi = shape == PhiShape::uniform ? 2.0 * q - 1.0 : bell_quantile(q);
    quantiles[static_cast<std::size_t>(j)] = -xi;
    quantiles[static_cast<std::size_t>(n - 1 - j)] = xi;
  }
  return quantiles;
}

}  // namespace rupture
