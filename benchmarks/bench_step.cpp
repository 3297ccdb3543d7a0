// The time step and its parts at reference size, 57 x 31 blocks and 5,700 junctions.

#include <random>

#include "rupture/model/derived.hpp"
#include "sliders.hpp"

namespace rupture::bench {
namespace {

/// Tells Google Benchmark how many steps an iteration took; run.py shows the time of one.
void count_steps(benchmark::State& bench, std::int64_t steps_per_iteration) {
  bench.SetItemsProcessed(bench.iterations() * steps_per_iteration);
}

// --- whole steps --------------------------------------------------------------------------------

void step_loading(benchmark::State& bench, std::int64_t steps_per_call) {
  Simulation simulation(Parameters{}, loading_state());
  const std::int64_t first_step = simulation.state().step;
  for (auto _ : bench) simulation.advance(steps_per_call);
  count_steps(bench, steps_per_call);
  expect_nothing_broke(bench, simulation, first_step);
}

/// Behind a rupture, all junctions slip, some break and are pinned again.
void step_sliding(benchmark::State& bench) {
  Parameters p;
  p.V = 0.5;  // [m/s]
  static const State sliding = driven(p, 4000);
  std::optional<Simulation> simulation(std::in_place, p, sliding);
  constexpr std::int64_t calls_before_repinning = 40;
  std::int64_t calls = 0;
  for (auto _ : bench) {
    simulation->advance(kSteps);
    if (++calls % calls_before_repinning != 0) continue;
    bench.PauseTiming();
    simulation.emplace(p, sliding);
    bench.ResumeTiming();
  }
  count_steps(bench, kSteps);
}

// --- the bulk alone -----------------------------------------------------------------------------

/// Free blocks somewhat away from their places, as in lammps/bulk.in.
State shaken(const Parameters& p) {
  State state(p);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shift(-1e-4 * block_spacing(p), 1e-4 * block_spacing(p));
  for (Eigen::Index j = 0; j < p.Nz; ++j) {
    for (Eigen::Index i = 0; i < p.Nx; ++i) {
      state.u_x(i, j) = shift(random);
      state.u_z(i, j) = shift(random);
    }
  }
  return state;
}

void bulk_step(benchmark::State& bench) {
  const Parameters p;
  State state = shaken(p);
  Bulk bulk(p);
  const std::vector<double> none(static_cast<std::size_t>(p.Nx));
  const Boundary free = {none.data(), none.data(), none.data(), driving_row(p), 0.0};
  bulk.kick_drift(0, state);
  for (auto _ : bench) {
    for (std::int64_t n = 0; n < kSteps; ++n) {
      bulk.prepare(0, state);
      bulk.finish(0, free, Then::go_on, state);
    }
    benchmark::ClobberMemory();
  }
  count_steps(bench, kSteps);
}

void bulk_springs(benchmark::State& bench) {
  State state = shaken(Parameters{});
  Bulk bulk{Parameters{}};
  for (auto _ : bench) {
    bulk.elastic(state.u_x, state.u_z, state.f_x, state.f_z);
    benchmark::ClobberMemory();
  }
  count_steps(bench, 1);
}

void bulk_damping(benchmark::State& bench) {
  State state = loading_state();
  Bulk bulk{Parameters{}};
  for (auto _ : bench) {
    bulk.damping(state, state.f_x, state.f_z);
    benchmark::ClobberMemory();
  }
  count_steps(bench, 1);
}

// --- the junctions alone ------------------------------------------------------------------------

/// The junction law of all blocks, with the normal forces that it needs, at a state at rest.
void junctions_of(benchmark::State& bench, State state) {
  const Parameters p;
  const auto law = make_law(p, state.junctions);
  const double t = time(p, state);
  std::vector<double> normal(static_cast<std::size_t>(p.Nx)), k_ij(normal), w(normal), tau(normal);
  const ContactView contact = {normal.data(), k_ij.data(), w.data()};
  for (auto _ : bench) {
    kernels().contact(p.Nx, state.u_z.row(0), foundation_stiffness(p), static_cast<double>(p.N_s),
                      p.kappa, contact);
    benchmark::DoNotOptimize(law->update(state.u_x.row(0), state.v_x.row(0), contact, t));
    law->friction(state.u_x.row(0), contact, tau.data());
    benchmark::ClobberMemory();
  }
  count_steps(bench, 1);
}

void junctions_pinned(benchmark::State& bench) {
  junctions_of(bench, loading_state());
}

/// All junctions of all blocks slip for a time without end.
void junctions_slipping(benchmark::State& bench) {
  State state = loading_state();
  constexpr double late = 1e9;  // [s]
  state.junctions.repin_time.setConstant(late);
  junctions_of(bench, std::move(state));
}

BENCHMARK_CAPTURE(step_loading, , kSteps)->Name("step/loading");
BENCHMARK_CAPTURE(step_loading, one_by_one, 1)->Name("step/loading_one_by_one");
BENCHMARK(step_sliding)->Name("step/sliding");
BENCHMARK(bulk_step)->Name("bulk/step");
BENCHMARK(bulk_springs)->Name("bulk/springs");
BENCHMARK(bulk_damping)->Name("bulk/damping");
BENCHMARK(junctions_pinned)->Name("junctions/pinned");
BENCHMARK(junctions_slipping)->Name("junctions/slipping");

}  // namespace
}  // namespace rupture::bench
