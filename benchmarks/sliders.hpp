// The sliders and states that the benchmarks measure on.
#pragma once

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdint>
#include <vector>

#include "rupture/dynamics/simulation.hpp"
#include "rupture/model/state.hpp"

namespace rupture::bench {

/// Time steps in one call of Simulation::advance: the programs, too, take many at once.
inline constexpr std::int64_t kSteps = 100;

/// The reference slider driven at V [m/s].
Parameters driven_at(double V);

/// The reference slider under its normal load; solved once.
const State& equilibrium();

/// Loading at the reference speed: nothing breaks.
const State& loading_state();

/// Sliding at kSliding behind a rupture: all junctions slip, some break and are pinned again.
inline constexpr double kSliding = 0.5;  // [m/s]
const State& sliding_state();

/// The reference slider `factor` times as long and high, with the same spacing of blocks, load per
/// length, density and driving height: (56 factor + 1) x (30 factor + 1) blocks.
Parameters enlarged(std::int64_t factor);

/// A slider compressed evenly by its load and free to widen, its junctions attached where they
/// carry no force. Only its edges are slightly out of balance. Solving for the equilibrium of the
/// largest sliders would take longer than measuring them, and a step costs the same for this state.
State evenly_compressed(const Parameters& parameters);

/// Makes the benchmark fail if a junction has broken since the simulation began: steps in which
/// that happens cost more.
void expect_nothing_broke(benchmark::State& bench, const Simulation& simulation,
                          std::int64_t first_step);

template <class Work>
double seconds_for(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The middle one of an odd number of values, the mean of the middle two of an even one.
double median(std::vector<double> values);

}  // namespace rupture::bench
