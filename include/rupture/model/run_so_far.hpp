// The memory of a run beyond its state.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rupture/model/rupture.hpp"
#include "rupture/model/spanning.hpp"

namespace rupture {

/// Events that a run has seen since it began. With them, a run that was interrupted goes on and
/// ends as if it had not been.
struct RunSoFar {
  std::string id = {};                 ///< that all files of the run share (docs/schema.md)
  std::int64_t first_step = 0;         ///< step at which the run began
  std::int64_t last_break = 0;         ///< step at which a junction last broke, or first_step
  std::int64_t ruptures = 0;           ///< block ruptures
  bool leading_edge_ruptured = false;  ///< whether the block at the leading edge was among them
  FirstRuptures event = {};            ///< the latest event, from the run's start on; empty, as the
                                       ///< next two, if a build without them began the run
  double last_rupture = 0;             ///< of any block in this event; 0 before the first [s]
  bool spanned = false;                ///< whether this event or one before it has spanned
  std::optional<std::int64_t> quiet_steps =
      {};                                    ///< its StopRule (dynamics/run.hpp), by which alone
  std::optional<double> arrived_below = {};  ///< a run until quiet is known to have ended

  bool operator==(const RunSoFar&) const = default;
};

/// A run that begins at this step.
RunSoFar run_from(const Parameters& p, std::int64_t step);

/// Adds the rupture of a block, later than all before it.
void add_rupture(const Parameters& p, const Rupture& rupture, RunSoFar& run);

}  // namespace rupture
