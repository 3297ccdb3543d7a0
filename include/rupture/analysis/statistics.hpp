// Small statistics that several measurements share.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace rupture {

/// The median; the mean of the two middle values of an even number; no value if there are none.
std::optional<double> median(std::vector<double> values);

/// y = intercept + slope x by least squares.
struct LineFit {
  double slope, intercept;
  double r_squared;    ///< coefficient of determination
  double slope_error;  ///< standard error of the slope
};

/// Needs at least three points with different x; otherwise no value.
std::optional<LineFit> fit_line(std::span<const double> x, std::span<const double> y);

}  // namespace rupture
