#include "sliders.hpp"

#include <algorithm>

#include "rupture/dynamics/equilibrium.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::bench {
namespace {

/// A state some time after driving started from equilibrium.
State driven(const Parameters& p, std::int64_t steps) {
  Simulation simulation(p, equilibrium());
  simulation.advance(steps);
  return simulation.state();
}

}  // namespace

Parameters driven_at(double V) {
  Parameters p;
  p.V = V;
  return p;
}

const State& equilibrium() {
  static const State state = normal_load_equilibrium(Parameters{});
  return state;
}

const State& loading_state() {
  static const State state = driven(Parameters{}, 1000);
  return state;
}

const State& sliding_state() {
  static const State state = driven(driven_at(kSliding), 4000);
  return state;
}

Parameters enlarged(std::int64_t factor) {
  const Parameters reference;
  const auto times = static_cast<double>(factor);
  Parameters p = reference;
  p.L *= times;
  p.H *= times;
  p.Nx = (reference.Nx - 1) * factor + 1;
  p.Nz = (reference.Nz - 1) * factor + 1;
  p.F_N = mean_normal_force(reference) * static_cast<double>(p.Nx);
  p.M = block_mass(reference) * static_cast<double>(p.Nx * p.Nz);
  return p;
}

State evenly_compressed(const Parameters& p) {
  State state(p);
  const double sink = mean_normal_force(p) / foundation_stiffness(p);
  const double strain = p.F_N / (p.L * p.B) / p.E;
  const double middle = 0.5 * block_position(p, p.Nx - 1);
  for (Eigen::Index j = 0; j < p.Nz; ++j) {
    const double z = static_cast<double>(j) * block_spacing(p);
    for (Eigen::Index i = 0; i < p.Nx; ++i) {
      state.u_x(i, j) = kPoissonRatio * strain * (block_position(p, i) - middle);
      state.u_z(i, j) = -sink - strain * z;
    }
  }
  for (Eigen::Index i = 0; i < p.Nx; ++i) state.junctions.attachment.row(i) = state.u_x(i, 0);
  state.drive = {state.step, state.u_x(0, driving_row(p))};
  return state;
}

void expect_nothing_broke(benchmark::State& bench, const Simulation& simulation,
                          std::int64_t first_step) {
  if (simulation.run().last_break != first_step) bench.SkipWithError("a junction broke");
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

}  // namespace rupture::bench
