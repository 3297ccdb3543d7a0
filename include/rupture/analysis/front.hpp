// Rupture fronts: where they were when, how fast, and of which type (Fig. 2). Events are bursts of
// block ruptures separated by quiet times.
#pragma once

#include <cstddef>
#include <span>

#include "rupture/model/rupture.hpp"

namespace rupture {

/// Whether the stencils that touch both the slow stretch and its surroundings belong to neither, to
/// the slow stretch, or to its fast surroundings.
enum class StencilsAtEnds { neither, slow, fast };

/// Choices behind a front's type, speeds and places; the tools show them as options.
struct FrontCriteria {
  double slow_below = 1.0 / 20.0;      ///< a front is slow where |v_c| < slow_below * c_s
  double skip_below_x = kLoadingZone;  ///< the loading or triggering zone does not count [m]
  std::size_t stencil = 5;             ///< blocks of the moving stencil, odd
  StencilsAtEnds stencils_at_ends = StencilsAtEnds::neither;
  double ruptured_below = kRupturedFraction;  ///< pinned fraction by which ruptures were chosen

  std::size_t half_stencil() const { return stencil / 2; }  ///< blocks on either side of its centre
};

/// What the paper calls slow (Discussion): v_c/c_s below this [1].
inline constexpr double kSlowInWords = 1.0 / 10.0;

/// Arrays with a value per interface block; a block that did not rupture has none.
struct RuptureLine {
  std::vector<double> x;    ///< position of the blocks [m]
  FirstRuptures t_rupture;  ///< first rupture in the window [s]
};

/// First rupture of every block at times in [from, to] [s].
RuptureLine rupture_line(const Parameters& parameters, std::span<const Rupture> ruptures,
                         double from, double to);

/// Front speed at each block, the inverse slope between the end points of the stencil around it
/// [m/s]. No value where the stencil reaches beyond an edge, where a block did not rupture, and
/// where the stencil's ends ruptured in the same step. Negative where the front runs towards the
/// driven edge.
std::vector<std::optional<double>> front_speed(const RuptureLine& line,
                                               const FrontCriteria& criteria);

enum class FrontType { none, arrested, slow, fast };
std::string_view front_type_name(FrontType type);

/// Whether an event with a front of this type spans.
bool spans(FrontType type);

/// A stretch of consecutive blocks over which the front is slow and runs forwards.
///
/// The centres of slow stencils form a run first..last. With h = half_stencil(), centres up to h
/// blocks from its first or last one, on either side, have stencils that touch both the slow
/// stretch and its surroundings. StencilsAtEnds says where they belong, for places, times and
/// speeds alike:
///
///              fast before       slow                    fast after
///   neither    .. first-h-1      first+h .. last-h       last+h+1 ..
///   slow       .. first-h-1      first-h .. last+h       last+h+1 ..
///   fast       .. first+h-1      first+h .. last-h       last-h+1 ..
///
/// The stretch grows only over stencils that exist, beyond the loading zone, and only while the
/// blocks rupture one after the other.
struct SlowStretch {
  double x_from = 0, x_to = 0;  ///< first and last block of the stretch [m]
  double t_from = 0, t_to = 0;  ///< when these two ruptured [s]
  double t_last_stencil = 0;    ///< when the centre of the last slow stencil ruptured [s]
  double speed = 0;             ///< median of v_c over the stretch [m/s]
  double slowest = 0;           ///< smallest v_c in it [m/s]
  std::size_t stencils = 0;     ///< of the run of slow stencils, wherever those at its ends count

  double duration() const { return t_to - t_from; }  ///< [s]
  /// Length over duration [m/s]; no value for a single block.
  std::optional<double> mean() const;

  /// Medians of v_c over the stencils that belong to the fast sides, lie beyond the loading zone
  /// and run forwards.
  std::optional<double> fast_before, fast_after;  ///< [m/s]
};

struct Front {
  RuptureLine line;
  std::vector<std::optional<double>> v_c;
  FrontType type = FrontType::none;
  bool reached_edge = false;          ///< whether the leading edge ruptured, even alone
  bool fast_slow_fast = false;        ///< in the paper's words, see measure_front()
  std::size_t backward_stencils = 0;  ///< beyond the loading zone, where v_c < 0
  std::optional<double> x_arrest;     ///< furthest ruptured block if the front did not span: of an
                                      ///< arrested one that reached the leading edge, that [m]
  std::optional<SlowStretch> slow;  ///< the slow stretch that lasted longest; none also where slow
                                    ///< stencils exist but no block belongs to any stretch
  std::optional<SlowStretch> in_words;  ///< the same below c_s/10, with the stencils at its ends
  std::optional<double> speed;          ///< median where it runs forwards beyond skip_below_x [m/s]
  FrontCriteria criteria;               ///< by which it was measured
};

/// Measures the front in one rupture line. None: nothing ruptured; arrested: the event does not
/// span; slow: it does, and |v_c| < slow_below c_s somewhere beyond skip_below_x; fast: the rest.
///
/// Fast-slow-fast, whatever slow_below is: the event spans; of the stretches with 0 < v_c < c_s/10
/// the one that lasted longest, in_words, has three stencils or more; and the medians of v_c before
/// and after it are at least c_s/10, without the stencils that touch it.
///
/// Neither depends on stencils_at_ends.
Front measure_front(const Parameters& parameters, RuptureLine line, const FrontCriteria& criteria);

struct Event {
  double t_start = 0, t_end = 0;   ///< first and last block rupture [s]
  double x_first = 0, x_last = 0;  ///< first rupture, and furthest position reached [m]
  Front front;
  double F_T_before = 0, F_T_after = 0;  ///< driving force at t_start, and its minimum until the
                                         ///< quiet time after t_end is over [N]
};

struct LoadingCurve {
  std::span<const double> time;  ///< [s]
  std::span<const double> F_T;   ///< [N]
};

/// Splits the ruptures, ordered by time, where none follows for longer than `quiet` [s]: one part
/// per event.
std::vector<std::span<const Rupture>> split_at_pauses(std::span<const Rupture> ruptures,
                                                      double quiet);

/// Splits the ruptures into events: a new one begins when no block has ruptured for `quiet` [s]
/// (default elsewhere: 5 t_R).
std::vector<Event> find_events(const Parameters& parameters, std::span<const Rupture> ruptures,
                               const LoadingCurve& loading, double quiet,
                               const FrontCriteria& criteria);

}  // namespace rupture
