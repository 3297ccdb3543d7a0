// Small statistics that several measurements share.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace rupture {

/// The median; the mean of the two middle values of an even number; no value if there are none.
std::optional<double> median(std::vector<double> values);

/// A straight line by least squares. The standard error, like that below, assumes independent
/// residuals; for a smooth series, whose neighbouring residuals are alike, it is too small.
struct LineFit {
  double slope;
  double r_squared;    ///< coefficient of determination
  double slope_error;  ///< standard error of the slope
  double rms;          ///< root mean square distance of the values from the line
};

/// Needs at least three points with different x; otherwise no value.
std::optional<LineFit> fit_line(std::span<const double> x, std::span<const double> y);

/// A mean and how well it is known.
struct Mean {
  double value;
  double deviation;       ///< standard deviation of one value
  double standard_error;  ///< deviation / sqrt(n)
};

/// The mean of independent values; needs at least two.
std::optional<Mean> mean_of(std::span<const double> values);

}  // namespace rupture
