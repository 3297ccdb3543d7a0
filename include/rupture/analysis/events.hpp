// Rupture events in a record: bursts of block ruptures separated by quiet times.
#pragma once

#include <span>
#include <vector>

#include "rupture/analysis/front.hpp"

namespace rupture {

struct Event {
  double t_start = 0, t_end = 0;   ///< first and last block rupture [s]
  double x_first = 0, x_last = 0;  ///< first rupture, and furthest position reached [m]
  Front front;
  double F_T_before = 0, F_T_after = 0;  ///< driving force at t_start, and its minimum until the
                                         ///< quiet time after t_end is over [N]
};

/// A time series of the driving force.
struct LoadingCurve {
  std::span<const double> time;  ///< [s]
  std::span<const double> F_T;   ///< [N]
};

/// Splits the ruptures, ordered by time, where none follows for longer than `quiet` [s]: one part
/// per event.
std::vector<std::span<const Rupture>> split_at_pauses(std::span<const Rupture> ruptures,
                                                      double quiet);

/// Splits the ruptures into events: a new one begins when no block has ruptured for `quiet` [s]
/// (default elsewhere: 5 <t_R>).
std::vector<Event> find_events(const Parameters& parameters, std::span<const Rupture> ruptures,
                               const LoadingCurve& loading, double quiet,
                               const FrontCriteria& criteria);

}  // namespace rupture
