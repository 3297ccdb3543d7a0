#include "rupture/analysis/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rupture {

std::optional<double> median(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

std::optional<LineFit> fit_line(std::span<const double> x, std::span<const double> y) {
  const std::size_t n = x.size();
  if (n < 3 || y.size() != n) return std::nullopt;
  double mean_x = 0, mean_y = 0;
  for (std::size_t i = 0; i < n; ++i) {
    mean_x += x[i] / static_cast<double>(n);
    mean_y += y[i] / static_cast<double>(n);
  }
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t i = 0; i < n; ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
  }
  if (xx <= 0.0) return std::nullopt;
  const double slope = xy / xx;
  const double unexplained = std::max(0.0, yy - slope * xy);
  LineFit fit{};
  fit.slope = slope;
  fit.r_squared = yy > 0.0 ? 1.0 - unexplained / yy : 1.0;
  const double variance = unexplained / static_cast<double>(n - 2);  // of one y about the line
  fit.slope_error = std::sqrt(variance / xx);
  fit.rms = std::sqrt(unexplained / static_cast<double>(n));
  return fit;
}

std::optional<Mean> mean_of(std::span<const double> values) {
  if (values.size() < 2) return std::nullopt;
  const auto n = static_cast<double>(values.size());
  Mean mean{};
  mean.value = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0;
  for (const double value : values) squares += (value - mean.value) * (value - mean.value);
  mean.deviation = std::sqrt(squares / (n - 1.0));
  mean.standard_error = mean.deviation / std::sqrt(n);
  return mean;
}

}  // namespace rupture
