#include "run/speed.hpp"

#include <chrono>

#include "rupture/dynamics/equilibrium.hpp"
#include "rupture/dynamics/simulation.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::tools {
namespace {

template <class Work>
double seconds_of(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The mean: stretches that something else has slowed down count, too, as they do in a run.
double time_per_step(Simulation& simulation) {
  constexpr double whole = 0.5, stretch = 0.01;  // [s]
  double sum = 0.0;
  std::int64_t steps = 0;
  for (std::int64_t next = 1; sum < whole;) {
    const double t = seconds_of([&] { simulation.advance(next); });
    sum += t;
    steps += next;
    if (t < stretch) next *= 2;
  }
  return sum / static_cast<double>(steps);
}

}  // namespace

State roughly_loaded(const Parameters& p) {
  State state = compressed(p);
  const double strain = p.F_N / (p.L * p.B) / p.E;
  for (std::int64_t j = 0; j < p.Nz; ++j) {
    for (std::int64_t i = 0; i < p.Nx; ++i) {
      // Also sideways: where nothing at all moves, steps would take another time.
      state.u_x(i, j) = kPoissonRatio * strain * (block_position(p, i) - 0.5 * p.L);
    }
  }
  for (std::int64_t i = 0; i < p.Nx; ++i) {
    state.junctions.attachment.row(i).setConstant(state.u_x(i, 0));
  }
  state.drive.origin_position = state.u_x(0, driving_row(p));
  return state;
}

Speed measure_speed(const Workload& work, const State& state) {
  Simulation simulation(work.parameters, state, work.threads);
  Speed speed = {.time_per_step = time_per_step(simulation)};
  if (work.from == RunsFrom::equilibrium) {
    speed.reference = seconds_of([] { normal_load_equilibrium(reference_slider()); });
  }
  return speed;
}

}  // namespace rupture::tools
