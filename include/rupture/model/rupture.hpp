// Ruptures of interface blocks, the events that they make (docs/decisions/0022-what-spans.md), and
// the memory of a run beyond its state.
#pragma once

#include <optional>

#include "rupture/model/parameters.hpp"

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

/// With fewer pinned junctions than this a block is below the fraction: with 55 of 100 it is not
/// below 0.55, although 0.55 * 100 is more than 55.
double pinned_limit(const Parameters& p, double fraction);

/// Blocks up to this x do not count: driving or a trigger ruptures them [m].
inline constexpr double kLoadingZone = 0.02;

/// First rupture of each interface block in one event [s]; none where it did not rupture.
using FirstRuptures = std::vector<std::optional<double>>;

/// Whether the event spans: more than half of the blocks at x > skip_below_x rupture in it, the one
/// at the leading edge among them, and that one after at least one other of them.
bool spans(const Parameters& p, const FirstRuptures& first, double skip_below_x = kLoadingZone);

/// Time without block ruptures that separates events, 5 t_R, the longest along the interface [s].
inline double pause_between_events(const Parameters& p) {
  return 5.0 * p.t_R.largest();
}

/// Whether at `t` an event is under way whose last block ruptured at `last_rupture` [s].
inline bool is_under_way(const Parameters& p, double last_rupture, double t) {
  return t - last_rupture <= pause_between_events(p);
}

/// What ends a run before its last step. Breaks and events are counted from the start of the run.
struct EarlyEnd {
  std::optional<std::int64_t> quiet_steps = {};  ///< no junction has broken for this many steps
  bool spanned = false;                          ///< an event has spanned
  /// Then a smaller fraction than this of the junctions at the leading edge must be pinned, too.
  std::optional<double> arrived_below = {};
  std::optional<std::int64_t> rupture_of = {};  ///< this block ruptures

  bool may_come() const { return quiet_steps || spanned || rupture_of; }
  bool operator==(const EarlyEnd&) const = default;
};

/// Events that a run has seen since it began. With them, an interrupted run continues and
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
  EarlyEnd early = {};  ///< by which alone a run that may end early is known to have ended

  bool operator==(const RunSoFar&) const = default;
};

/// A run that begins at this step.
RunSoFar run_from(const Parameters& p, std::int64_t step);

/// Adds the rupture of a block, later than all before it.
void add_rupture(const Parameters& p, const Rupture& rupture, RunSoFar& run);

}  // namespace rupture
