// The rupture of one interface block.
#pragma once

#include <cstdint>

namespace rupture {

/// Pinned fraction below which a block counts as ruptured (Fig. 2: 70 % of its junctions broken).
inline constexpr double kRupturedFraction = 0.3;

/// A block's pinned fraction fell below kRupturedFraction, or below another one, known to the step.
struct Rupture {
  std::int64_t step = 0;
  double time = 0;  ///< [s]
  std::int64_t block = 0;
  double pinned_below = kRupturedFraction;  ///< [1]

  bool operator==(const Rupture&) const = default;
};

}  // namespace rupture
