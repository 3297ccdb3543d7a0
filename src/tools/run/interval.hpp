// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

// What a run does again and again: record a sample, write a checkpoint.
#pragma once

#include <cstdint>

namespace rupture::tools {

/// Steps at which multiples of an interval of time have passed since t = 0, so that split runs do
/// it at the same steps.
struct Interval {
  std::int64_t steps = 1;
  std::int64_t zero = 0;  ///< step that t = 0 has by the clock; below 0 if dt was longer before

  /// Number of the last such step that is not after `step`.
  std::int64_t number_at(std::int64_t step) const { return (step - zero) / steps; }
  /// Step of that number.
  std::int64_t step_of(std::int64_t number) const { return zero + number * steps; }
  /// The first such step after `step`.
  std::int64_t after(std::int64_t step) const { return step_of(number_at(step) + 1); }
};

}  // namespace rupture::tools
