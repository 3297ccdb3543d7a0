#include "rupture/analysis/events.hpp"

#include <algorithm>

#include "rupture/model/derived.hpp"

namespace rupture {
namespace {

/// Driving force at the last sample not after t; the first sample if all are later.
double force_at(const LoadingCurve& loading, double t) {
  const auto after = std::upper_bound(loading.time.begin(), loading.time.end(), t);
  const auto index = std::max<std::ptrdiff_t>(after - loading.time.begin() - 1, 0);
  return loading.F_T[static_cast<std::size_t>(index)];
}

double smallest_force(const LoadingCurve& loading, double from, double to) {
  double smallest = force_at(loading, from);
  for (std::size_t n = 0; n < loading.time.size(); ++n) {
    if (loading.time[n] >= from && loading.time[n] <= to) {
      smallest = std::min(smallest, loading.F_T[n]);
    }
  }
  return smallest;
}

Event describe(const Parameters& p, std::span<const Rupture> ruptures, const LoadingCurve& loading,
               double quiet, const FrontCriteria& criteria) {
  const auto furthest =
      std::max_element(ruptures.begin(), ruptures.end(),
                       [](const Rupture& a, const Rupture& b) { return a.block < b.block; });
  Event event;
  event.t_start = ruptures.front().time;
  event.t_end = ruptures.back().time;
  event.x_first = block_position(p, ruptures.front().block);
  event.x_last = block_position(p, furthest->block);
  event.front = measure_front(p, rupture_line(p, ruptures, event.t_start, event.t_end), criteria);
  event.F_T_before = force_at(loading, event.t_start);
  event.F_T_after = smallest_force(loading, event.t_start, event.t_end + quiet);
  return event;
}

}  // namespace

std::vector<std::span<const Rupture>> split_at_pauses(std::span<const Rupture> ruptures,
                                                      double quiet) {
  std::vector<std::span<const Rupture>> parts;
  std::size_t first = 0;
  for (std::size_t n = 1; n <= ruptures.size(); ++n) {
    if (n < ruptures.size() && ruptures[n].time - ruptures[n - 1].time <= quiet) continue;
    parts.push_back(ruptures.subspan(first, n - first));
    first = n;
  }
  return parts;
}

std::vector<Event> find_events(const Parameters& p, std::span<const Rupture> ruptures,
                               const LoadingCurve& loading, double quiet,
                               const FrontCriteria& criteria) {
  std::vector<Event> events;
  for (const auto part : split_at_pauses(ruptures, quiet)) {
    events.push_back(describe(p, part, loading, quiet, criteria));
  }
  return events;
}

}  // namespace rupture
