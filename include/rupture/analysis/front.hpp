// Rupture fronts: where they were when, how fast, and of which type (Fig. 2). Events are bursts of
// block ruptures separated by quiet times.
#pragma once

#include <cstddef>
#include <span>

#include "rupture/model/rupture.hpp"

namespace rupture {

/// Which times the front's speed is taken from: when the contiguous ruptured region reaches each
/// block, or when each block ruptures, even if alone.
enum class Line { contiguous, raw };

/// Choices behind a front's type, speeds and places; the tools show them as options.
struct FrontCriteria {
  double slow_below = 1.0 / 20.0;      ///< a front is slow where |v_c| < slow_below * c_s
  double skip_below_x = kLoadingZone;  ///< the loading or triggering zone does not count [m]
  std::size_t stencil = 5;             ///< blocks of the moving stencil, odd
  Line line = Line::contiguous;
  double ruptured_below = kRupturedFraction;  ///< pinned fraction by which ruptures were chosen

  std::size_t half_stencil() const { return stencil / 2; }  ///< blocks on either side of its centre
};

/// What the paper calls slow (Discussion): v_c/c_s below this [1].
inline constexpr double kSlowInWords = 1.0 / 10.0;
/// How many stencils of it make a stretch.
inline constexpr std::size_t kStencilsInWords = 3;

/// What a window of time shows of an event, and what it does not. Arrays have a value per interface
/// block; a block that did not rupture has none.
struct RuptureLine {
  std::vector<double> x;      ///< position of the blocks [m]
  FirstRuptures t_rupture;    ///< first rupture in the window, if it is the first in the event [s]
  FirstRuptures before = {};  ///< first rupture before the window begins; empty: none [s]
  bool is_over = true;        ///< whether nothing of the event comes after the window

  std::size_t ruptured_before() const;  ///< how many blocks
};

/// The ruptures of one event, in the window [from, to] [s] and before it.
RuptureLine rupture_line(const Parameters& parameters, std::span<const Rupture> ruptures,
                         double from, double to);

/// When the contiguous ruptured region reaches each block [s]. Its edge is the front. From the
/// block s where it starts, the region grows to both sides:
///
///   t_front(i) = max of t_rupture(j) over the blocks j from s to i that ruptured.
///
/// A block that ruptures alone ahead of the front joins when the front gets there. The front starts
/// at the block for which fewest blocks rupture ahead of it, the first of several: in the loading
/// zone, unless the event begins elsewhere. Blocks that did not rupture are passed over, and have
/// no time.
FirstRuptures front_times(const FirstRuptures& t_rupture);

/// Front speed at each block, the inverse slope between the end points of the stencil around it
/// [m/s]; `times`: when the front is at each block. No value where the stencil reaches beyond an
/// edge, where a block did not rupture, and where the front is at both ends at the same time: there
/// it jumps over blocks that had ruptured before. Negative where it runs towards the driven edge.
std::vector<std::optional<double>> front_speed(const std::vector<double>& x,
                                               const FirstRuptures& times,
                                               const FrontCriteria& criteria);

/// Unknown: the window does not show it.
enum class Answer { no, yes, unknown };

/// Unfinished: the event has not spanned, and the window ends before it is over.
enum class FrontType { none, arrested, slow, fast, unfinished };
std::string_view front_type_name(FrontType type);

/// Whether an event with a front of this type spans.
bool spans(FrontType type);

/// A stretch over which the front is slow and runs forwards: from the centre of the first slow
/// stencil to that of the last one. It goes on over stencils without a value, where the front jumps
/// or a block did not rupture.
///
///   blocks        0  1  2  3  4  5  6  7  8  9 10 11
///   v_c                 f  f  f  s  s  -  s  f  f  f      stencil of 5: from block 2 to block 9
///   slow stretch              |--------|                  first = 5, last = 8
///   before           ..f                      f..         up to first - 3, after: from last + 3
///
/// The stencils within half a stencil of its ends have blocks in the stretch, and count to neither
/// the speed before nor that after it.
struct SlowStretch {
  double x_from = 0, x_to = 0;  ///< first and last block of the stretch [m]
  double t_from = 0, t_to = 0;  ///< when the front is at these two [s]
  double speed = 0;             ///< median of v_c over the slow stencils [m/s]
  double slowest = 0;           ///< smallest v_c of them [m/s]
  std::size_t stencils = 0;     ///< how many of them

  /// Between the centres of its first and last stencil [s]. Like the mean speed, length over
  /// duration [m/s], none for fewer than kStencilsInWords stencils, which overlap too much.
  std::optional<double> duration() const;
  std::optional<double> mean_speed() const;

  /// Medians of v_c over the stencils before and after it, beyond the loading zone, that run
  /// forwards.
  std::optional<double> fast_before, fast_after;  ///< [m/s]
};

struct Front {
  RuptureLine line;
  FirstRuptures t_front;  ///< when the front is at each block [s]; t_rupture with Line::raw. None
                          ///< where it was before the window
  std::vector<std::optional<double>> v_c;
  std::size_t ahead = 0;  ///< blocks beyond the loading zone that ruptured before it was there
  FrontType type = FrontType::none;
  bool reached_edge = false;  ///< whether the leading edge ruptured, even alone
  /// In the paper's words, see measure_front(). Not known of an unfinished front, and of one whose
  /// speed before the slow stretch is all before the window.
  Answer fast_slow_fast = Answer::no;
  std::size_t backward_stencils = 0;  ///< beyond the loading zone, where v_c < 0
  std::optional<double> x_arrest;     ///< furthest ruptured block if the front did not span: of an
                                      ///< arrested one that reached the leading edge, that [m]
  std::optional<SlowStretch> slow;    ///< the slow stretch that lasted longest
  std::optional<SlowStretch> in_words;  ///< the same below c_s/10
  std::optional<double> speed;          ///< median where it runs forwards beyond skip_below_x [m/s]
  FrontCriteria criteria;               ///< by which it was measured
};

/// Measures the front in one rupture line. None: nothing ruptured; arrested: the event does not
/// span; slow: it does, and |v_c| < slow_below c_s somewhere beyond skip_below_x; fast: the rest.
///
/// Where the front is, and whether the event spans, follows from all its ruptures, those before the
/// window too. Speeds are those of stencils that lie wholly in the window: what happens before it
/// may be another experiment.
///
/// Fast-slow-fast, whatever slow_below is: the event spans; of the stretches with 0 < v_c < c_s/10
/// the one that lasted longest, in_words, has three stencils or more; and the medians of v_c before
/// and after it are at least c_s/10.
Front measure_front(const Parameters& parameters, RuptureLine line, const FrontCriteria& criteria);

struct Event {
  double t_start = 0, t_end = 0;   ///< first and last block rupture in the record [s]
  double x_first = 0, x_last = 0;  ///< first of these, and furthest position reached [m]
  Front front;
  double F_T_before = 0, F_T_after = 0;  ///< driving force at t_start, and its minimum until the
                                         ///< quiet time after t_end is over [N]
  double silence = 0;  ///< from t_end to the next event or the end of the record [s]
};

struct LoadingCurve {
  std::span<const double> time;  ///< [s]
  std::span<const double> F_T;   ///< [N]
};

/// Splits the ruptures, ordered by time, where none follows for longer than `quiet` [s]: one part
/// per event.
std::vector<std::span<const Rupture>> split_at_pauses(std::span<const Rupture> ruptures,
                                                      double quiet);

/// Whether no rupture follows for `quiet` [s]; to the rounding of times.
inline bool is_over(double silence, double quiet) {
  return silence >= quiet * (1.0 - 1e-9);
}

/// Splits the ruptures into events: a new one begins when no block has ruptured for `quiet` [s]
/// (default elsewhere: 5 t_R). The loading curve is the window: an event whose ruptures are all
/// before it does not count, and the last one is over if it goes on for long enough.
std::vector<Event> find_events(const Parameters& parameters, std::span<const Rupture> ruptures,
                               const LoadingCurve& loading, double quiet,
                               const FrontCriteria& criteria);

/// When a window begins that begins with this sample: what ruptured in its step belongs to what was
/// before [s].
double just_after(double time);

}  // namespace rupture
