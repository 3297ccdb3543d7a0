#include "rupture/dynamics/run.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rupture/model/derived.hpp"

namespace rupture {
namespace {

void show(const Simulation& simulation, const std::vector<Observer*>& observers) {
  for (Observer* observer : observers) {
    if (observer->next_step() <= simulation.state().step) observer->observe(simulation);
  }
}

/// Steps that take about a tenth of a second while all junctions move.
std::int64_t steps_between_questions(const Parameters& p) {
  constexpr std::int64_t moved = 10'000'000;  // blocks and junctions
  return std::max<std::int64_t>(moved / (p.Nx * (p.Nz + springs_per_block(p))), 1);
}

/// Whether the block has ruptured since the run began.
bool has_ruptured(std::int64_t block, const State& state, const RunSoFar& run) {
  if (run.event.first.empty()) return false;
  const auto& t = run.event.first[static_cast<std::size_t>(block)];
  return t && *t > time_at(state.made_with, state.clock, run.first_step);
}

/// Whether nothing will rupture any more: the drive stands still, no junction waits to be pinned or
/// creeps, and none has broken for longer than events are apart and for ten periods of the slider
/// on its driving spring, 2 pi sqrt(M/K), so that its waves have died down.
bool is_at_rest(const State& state, const RunSoFar& run) {
  const Parameters& p = state.made_with;
  if (p.V != 0.0) return false;
  const double periods = 10.0 * 2.0 * std::numbers::pi * std::sqrt(p.M / p.K);
  const double quiet = std::max(quiet_time(p, run.early), periods);
  if (static_cast<double>(state.step - run.last_break) * p.dt < quiet) return false;
  const auto waits = [](double at) { return is_slipping(at) && at != Junctions::unknown; };
  return !state.junctions.repin_time.unaryExpr(waits).any() &&
         (state.junctions.slow_until.abs() <= time(p, state)).all();
}

}  // namespace

std::optional<Ending> ending_at(const State& state, const RunSoFar& run, const StopRule& rule) {
  const std::int64_t step = state.step;
  const EarlyEnd& early = rule.early;
  if (early.rupture_of && has_ruptured(*early.rupture_of, state, run)) return Ending::ruptured;
  if (step >= rule.last_step) return Ending::last_step;
  if (step % kQuietCheck != 0) return std::nullopt;
  const Eigen::Index edge = state.junctions.repin_time.rows() - 1;  // the leading one
  const bool waits =
      early.arrived_below && pinned_fraction(state.junctions, edge) >= *early.arrived_below;
  if (early.spanned && run.spanned && !waits) return Ending::spanned;
  if (early.quiet_steps && step - run.last_break >= *early.quiet_steps) return Ending::quiet;
  const bool ends_at_rest = early.may_come() && early.condition.empty();
  if (ends_at_rest && is_at_rest(state, run)) return Ending::at_rest;
  return std::nullopt;
}

Ending run(Simulation& simulation, const StopRule& rule, const std::vector<Observer*>& observers) {
  show(simulation, observers);
  simulation.stop_at_rupture_of(rule.early.rupture_of);
  for (;;) {
    const std::int64_t step = simulation.state().step;
    if (rule.condition_holds && rule.condition_holds()) return Ending::condition;
    if (const auto end = ending_at(simulation.state(), simulation.run(), rule)) return *end;
    std::int64_t pause = rule.last_step;
    if (rule.interrupted) {
      if (rule.interrupted()) return Ending::interrupted;
      pause = std::min(pause, step + steps_between_questions(simulation.parameters()));
    }
    if (rule.early.may_come()) pause = std::min(pause, (step / kQuietCheck + 1) * kQuietCheck);
    for (const Observer* observer : observers) pause = std::min(pause, observer->next_step());
    simulation.advance(std::max<std::int64_t>(pause - step, 1));
    show(simulation, observers);
  }
}

}  // namespace rupture
