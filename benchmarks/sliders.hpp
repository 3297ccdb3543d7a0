// The states that the benchmarks measure on.
#pragma once

#include <benchmark/benchmark.h>

#include <chrono>

#include "rupture/dynamics/equilibrium.hpp"
#include "rupture/dynamics/simulation.hpp"

namespace rupture::bench {

/// The reference slider some time after driving at `p.V` started from its equilibrium.
inline State driven(const Parameters& p, std::int64_t steps) {
  static const State equilibrium = normal_load_equilibrium(Parameters{});
  Simulation simulation(p, continued(equilibrium, p));
  simulation.advance(steps);
  return simulation.state();
}

/// Loading at the reference speed: nothing breaks.
inline const State& loading_state() {
  static const State state = driven(Parameters{}, 1000);
  return state;
}

double seconds_for(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace rupture::bench
