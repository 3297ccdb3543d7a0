// Shapes of the distribution phi(f_T) of junction forces, and their exact quantiles.
#pragma once

#include <cstdint>
#include <vector>

namespace rupture {

/// Shapes of phi: uniform, or the bell phi(xi) = 5/(4a) (1 + 3|xi/a|) (1 - |xi/a|)^3 on [-a, a].
enum class PhiShape { uniform, bell };

/// Standard deviation of a shape of half-width 1: 1/sqrt(3) (uniform), sqrt(2/21) (bell). The
/// half-width that gives a wanted sigma is sigma / unit_sigma(shape).
double unit_sigma(PhiShape shape);

/// The n exact quantiles (j + 1/2)/n, j = 0..n-1, of a shape of half-width 1, ascending, with mean
/// zero to the last bit.
std::vector<double> unit_quantiles(PhiShape shape, std::int64_t n);

}  // namespace rupture
