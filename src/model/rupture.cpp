#include "rupture/model/rupture.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "rupture/model/derived.hpp"

namespace rupture {

double pinned_limit(const Parameters& p, double fraction) {
  const auto springs = static_cast<double>(springs_per_block(p));
  const double product = fraction * springs, whole = std::round(product);
  return whole / springs == fraction ? whole : product;
}

bool spans(const Parameters& p, const FirstRuptures& first, double skip_below_x) {
  if (!first.back()) return false;
  std::size_t blocks = 0, ruptured = 0, before_edge = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (block_position(p, static_cast<std::int64_t>(i)) <= skip_below_x) continue;
    ++blocks;
    if (first[i]) ++ruptured;
    if (first[i] && *first[i] < *first.back()) ++before_edge;
  }
  return 2 * ruptured > blocks && before_edge > 0;
}

bool LatestEvent::is_under_way(double t, double quiet) const {
  const bool has_begun = std::ranges::any_of(first, [](const auto& at) { return at.has_value(); });
  return has_begun && t - last_rupture <= quiet;
}

RunSoFar run_from(const Parameters& p, std::int64_t step, LatestEvent event) {
  RunSoFar run;
  run.first_step = run.last_break = step;
  run.event = std::move(event);
  run.event.first.resize(static_cast<std::size_t>(p.Nx));
  return run;
}

double quiet_time(const Parameters& p, const EarlyEnd& early) {
  return early.quiet_time.value_or(pause_between_events(p));
}

void add_rupture(const Parameters& p, const Rupture& rupture, RunSoFar& run) {
  ++run.ruptures;
  run.leading_edge_ruptured |= rupture.block + 1 == p.Nx;
  FirstRuptures& first = run.event.first;
  if (first.empty()) return;
  if (!run.event.is_under_way(rupture.time, quiet_time(p, run.early))) {
    first.assign(first.size(), std::nullopt);
  }
  const bool had_spanned = spans(p, first);
  auto& of_block = first[static_cast<std::size_t>(rupture.block)];
  if (!of_block) of_block = rupture.time;
  run.event.last_rupture = rupture.time;
  run.spanned = run.spanned || (!had_spanned && spans(p, first));
}

std::map<std::int64_t, bool> which_span(const Parameters& p, RunSoFar run,
                                        std::span<const Rupture> ruptures) {
  std::map<std::int64_t, bool> events = {
      {std::numeric_limits<std::int64_t>::min(), spans(p, run.event.first)}};
  for (const Rupture& rupture : ruptures) {
    const bool is_new = !run.event.is_under_way(rupture.time, quiet_time(p, run.early));
    add_rupture(p, rupture, run);
    (is_new ? events[rupture.step] : events.rbegin()->second) = spans(p, run.event.first);
  }
  return events;
}

bool is_in_spanning_event(const std::map<std::int64_t, bool>& events, std::int64_t step) {
  return std::prev(events.upper_bound(step))->second;
}

}  // namespace rupture
