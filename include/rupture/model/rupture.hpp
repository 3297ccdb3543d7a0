// Ruptures of interface blocks, the events that they make (docs/decisions/0022-what-spans.md), and
// the memory of a run beyond its state.
#pragma once

#include <map>
#include <optional>
#include <span>

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

/// Time without block ruptures that separates events: 5 t_R, of the median along the interface, so
/// that no patch sets it [s].
inline double pause_between_events(const Parameters& p) {
  return 5.0 * p.t_R.median();
}

/// The latest event up to some moment.
struct LatestEvent {
  FirstRuptures first = {};  ///< first rupture of each block in it; empty: not known
  double last_rupture = 0;   ///< of any block in it; 0 before the first [s]

  /// Whether it is under way at `t`: none of its ruptures is longer ago than `quiet` [s].
  bool is_under_way(double t, double quiet) const;
  bool operator==(const LatestEvent&) const = default;
};

/// What ends a run before its last step. Breaks and events are counted from the start of the run.
struct EarlyEnd {
  std::optional<std::int64_t> quiet_steps = {};  ///< no junction has broken for this many steps
  bool spanned = false;                          ///< an event has spanned
  /// Then a smaller fraction than this of the junctions at the leading edge must be pinned, too.
  std::optional<double> arrived_below = {};
  std::optional<std::int64_t> rupture_of = {};  ///< this block ruptures
  /// Time that separates events; none: pause_between_events() [s].
  std::optional<double> quiet_time = {};
  std::string condition = {};  ///< this holds (dynamics/condition.hpp); empty: there is none
  double condition_every = 0;  ///< as is looked at so often [s]

  bool may_come() const { return quiet_steps || spanned || rupture_of || !condition.empty(); }
  bool operator==(const EarlyEnd&) const = default;
};

/// What a run has seen since it began. With it, an interrupted run continues and ends as if it had
/// not been.
struct RunSoFar {
  std::string id = {};                 ///< that all files of the run share (docs/schema.md)
  std::int64_t first_step = 0;         ///< step at which the run began
  std::int64_t last_break = 0;         ///< step at which a junction last broke, or first_step
  std::int64_t ruptures = 0;           ///< block ruptures
  bool leading_edge_ruptured = false;  ///< whether the block at the leading edge was among them
  LatestEvent event = {};              ///< which may have begun before the run
  bool spanned = false;                ///< whether an event has spanned since the run began
  EarlyEnd early = {};  ///< by which alone a run that may end early is known to have ended

  bool operator==(const RunSoFar&) const = default;
};

/// A run that begins at this step, after this event.
RunSoFar run_from(const Parameters& p, std::int64_t step, LatestEvent event = {});

/// Time without block ruptures that separates the events of a run [s].
double quiet_time(const Parameters& p, const EarlyEnd& early);

/// Adds the rupture of a block, later than all before it.
void add_rupture(const Parameters& p, const Rupture& rupture, RunSoFar& run);

/// Whether the events span that these ruptures make, by the step of their first rupture. The first
/// is that of `run`, to which they are added, and is there in any case.
std::map<std::int64_t, bool> which_span(const Parameters& p, RunSoFar run,
                                        std::span<const Rupture> ruptures);
/// Whether the event that is under way at a step, of these, spans.
bool is_in_spanning_event(const std::map<std::int64_t, bool>& events, std::int64_t step);

}  // namespace rupture
