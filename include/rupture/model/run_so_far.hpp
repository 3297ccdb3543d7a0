// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

// The memory of a run beyond its state.
#pragma once

#include <cstdint>

namespace rupture {

/// Events that a run has seen since it began. With them, a run that was interrupted goes on and
/// ends as if it had not been.
struct RunSoFar {
  std::int64_t first_step = 0;         ///< step at which the run began
  std::int64_t last_break = 0;         ///< step at which a junction last broke, or first_step
  std::int64_t ruptures = 0;           ///< block ruptures
  bool leading_edge_ruptured = false;  ///< whether the block at the leading edge was among them

  bool operator==(const RunSoFar&) const = default;
};

}  // namespace rupture
