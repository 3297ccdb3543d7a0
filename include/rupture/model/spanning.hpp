// Which events span the interface (docs/decisions/0022-what-spans.md), for runs and analyses alike.
#pragma once

#include <optional>
#include <vector>

#include "rupture/model/parameters.hpp"

namespace rupture {

/// Blocks up to this x do not count: driving or a trigger ruptures them [m].
inline constexpr double kLoadingZone = 0.02;

/// First rupture of each interface block in one event [s]; none where it did not rupture.
using FirstRuptures = std::vector<std::optional<double>>;

/// Whether the event spans: more than half of the blocks at x > skip_below_x rupture in it, the one
/// at the leading edge among them, and that one after at least one other of them.
bool spans(const Parameters& p, const FirstRuptures& first, double skip_below_x = kLoadingZone);

/// Time without block ruptures that separates events, 5 t_R [s].
inline double pause_between_events(const Parameters& p) {
  return 5.0 * p.t_R;
}

}  // namespace rupture
