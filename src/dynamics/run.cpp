// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

#include "rupture/dynamics/run.hpp"

#include <algorithm>

namespace rupture {
namespace {

void show(const Simulation& simulation, const std::vector<Observer*>& observers) {
  for (Observer* observer : observers) {
    if (observer->next_step() <= simulation.state().step) observer->observe(simulation);
  }
}

/// Steps that take about a tenth of a second.
std::int64_t steps_between_questions(const Parameters& p) {
  constexpr std::int64_t blocks_moved = 10'000'000;
  return std::max<std::int64_t>(blocks_moved / (p.Nx * p.Nz), 1);
}

double pinned_at_edge(const Simulation& simulation) {
  return pinned_fraction(simulation.state().junctions, simulation.parameters().Nx - 1);
}

}  // namespace

std::optional<Ending> ending_at(std::int64_t step, const RunSoFar& run, double pinned_at_edge,
                                const StopRule& rule) {
  if (step >= rule.last_step) return Ending::last_step;
  if (!rule.quiet_steps || step % kQuietCheck != 0) return std::nullopt;
  const bool is_pinned = rule.arrived_below && pinned_at_edge >= *rule.arrived_below;
  if (run.leading_edge_ruptured && !is_pinned) return Ending::leading_edge;
  if (step - run.last_break >= *rule.quiet_steps) return Ending::quiet;
  return std::nullopt;
}

Ending run(Simulation& simulation, const StopRule& rule, const std::vector<Observer*>& observers) {
  show(simulation, observers);
  for (;;) {
    const std::int64_t step = simulation.state().step;
    const auto end = ending_at(step, simulation.run(), pinned_at_edge(simulation), rule);
    if (end) return *end;
    std::int64_t pause = rule.last_step;
    if (rule.interrupted) {
      if (rule.interrupted()) return Ending::interrupted;
      pause = std::min(pause, step + steps_between_questions(simulation.parameters()));
    }
    if (rule.quiet_steps) pause = std::min(pause, (step / kQuietCheck + 1) * kQuietCheck);
    for (const Observer* observer : observers) pause = std::min(pause, observer->next_step());
    simulation.advance(std::max<std::int64_t>(pause - step, 1));
    show(simulation, observers);
  }
}

}  // namespace rupture
