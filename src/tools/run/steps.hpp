// Steps and blocks that options name by their time and place.
#pragma once

#include <cmath>
#include <string>

#include "rupture/model/state.hpp"

namespace rupture::tools {

/// The block nearest to `x` [m], the value of an option. Throws UsageError beyond the interface.
std::int64_t block_at(const Parameters& parameters, double x, const std::string& option);

/// The steps nearest to the multiples of an interval of time. They are counted from t = 0, so that
/// split runs do it at the same steps.
struct Interval {
  double time = 1;        ///< the interval, at least dt [s]
  double dt = 1;          ///< [s]
  std::int64_t zero = 0;  ///< step nearest to t = 0 by the clock; below 0 if dt was longer before
  double offset = 0;      ///< t = 0 comes so much later than that step [steps]

  /// Step of the multiple with that number.
  std::int64_t step_of(std::int64_t number) const {
    return zero + std::llround(static_cast<double>(number) * time / dt + offset);
  }
  /// Number of the last such step that is not after `step`.
  std::int64_t number_at(std::int64_t step) const {
    const double passed = (static_cast<double>(step - zero) - offset) * dt;  // [s]
    const auto number = static_cast<std::int64_t>(passed / time);
    return step_of(number + 1) <= step ? number + 1 : number;
  }
  std::int64_t last_until(std::int64_t step) const { return step_of(number_at(step)); }
  /// The first such step after `step`.
  std::int64_t after(std::int64_t step) const { return step_of(number_at(step) + 1); }
  /// Samples from step `first` to `last`: at both, and at such steps between.
  std::int64_t samples(std::int64_t first, std::int64_t last) const {
    const bool extra_at_end = last > first && last != last_until(last);
    return 1 + number_at(last) - number_at(first) + (extra_at_end ? 1 : 0);
  }
};

/// The interval that `option` gives. Throws UsageError if it is shorter than a step.
Interval interval(const Parameters& parameters, const Clock& clock, double t,
                  std::string_view option);

}  // namespace rupture::tools
