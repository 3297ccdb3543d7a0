#include "rupture/model/rupture.hpp"

#include <cmath>

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

RunSoFar run_from(const Parameters& p, std::int64_t step) {
  RunSoFar run;
  run.first_step = run.last_break = step;
  run.event.resize(static_cast<std::size_t>(p.Nx));
  return run;
}

void add_rupture(const Parameters& p, const Rupture& rupture, RunSoFar& run) {
  ++run.ruptures;
  run.leading_edge_ruptured |= rupture.block + 1 == p.Nx;
  if (run.event.empty()) return;
  const bool is_new = rupture.time - run.last_rupture > pause_between_events(p);
  if (is_new) run.event.assign(run.event.size(), std::nullopt);
  auto& first = run.event[static_cast<std::size_t>(rupture.block)];
  if (!first) first = rupture.time;
  run.last_rupture = rupture.time;
  run.spanned = run.spanned || spans(p, run.event);
}

}  // namespace rupture
