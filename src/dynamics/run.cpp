#include "rupture/dynamics/run.hpp"

#include <algorithm>

namespace rupture {
namespace {

void show(const Simulation& simulation, const std::vector<Observer*>& observers) {
  for (Observer* observer : observers) {
    if (observer->next_step() <= simulation.state().step) observer->observe(simulation);
  }
}

std::optional<Ending> ending(const Simulation& simulation, const StopRule& rule) {
  const std::int64_t step = simulation.state().step;
  if (step >= rule.last_step) return Ending::last_step;
  if (!rule.quiet_steps || step % kQuietCheck != 0) return std::nullopt;
  if (simulation.leading_edge_ruptured()) return Ending::leading_edge;
  if (step - simulation.last_break() >= *rule.quiet_steps) return Ending::quiet;
  return std::nullopt;
}

}  // namespace

Ending run(Simulation& simulation, const StopRule& rule, const std::vector<Observer*>& observers) {
  show(simulation, observers);
  for (;;) {
    if (const auto end = ending(simulation, rule)) return *end;
    std::int64_t pause = rule.last_step;
    if (rule.quiet_steps) {
      pause = std::min(pause, (simulation.state().step / kQuietCheck + 1) * kQuietCheck);
    }
    for (const Observer* observer : observers) pause = std::min(pause, observer->next_step());
    simulation.advance(std::max<std::int64_t>(pause - simulation.state().step, 1));
    show(simulation, observers);
  }
}

}  // namespace rupture
