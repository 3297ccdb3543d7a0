// The time step and its parts at reference size, 57 x 31 blocks and 5,700 junctions; and how its
// cost grows with the size of the slider and falls with the number of threads.
#include <algorithm>
#include <thread>

#include "run/plan.hpp"
#include "rupture/analysis/statistics.hpp"
#include "rupture/forces/kernels.hpp"
#include "rupture/version.hpp"
#include "sliders.hpp"
#include "support/sliders.hpp"

namespace rupture::bench {
namespace {

/// Time steps in one call of Simulation::advance: the programs, too, take many at once. An item of
/// Google Benchmark is a step.
constexpr std::int64_t kSteps = 100;

/// Makes the benchmark fail if a junction has broken since the simulation began: steps in which
/// that happens cost more.
void expect_nothing_broke(benchmark::State& bench, const Simulation& simulation,
                          std::int64_t first_step) {
  if (simulation.run().last_break != first_step) bench.SkipWithError("a junction broke");
}

// --- whole steps --------------------------------------------------------------------------------

void step_loading(benchmark::State& bench, std::int64_t steps_per_call) {
  Simulation simulation(Parameters{}, loading_state());
  const std::int64_t first_step = simulation.state().step;
  for (auto _ : bench) simulation.advance(steps_per_call);
  bench.SetItemsProcessed(bench.iterations() * steps_per_call);
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
  bench.SetItemsProcessed(bench.iterations() * kSteps);
}

// --- the bulk alone -----------------------------------------------------------------------------

/// Free blocks somewhat away from their places, as in lammps/bulk.in.
State shaken(const Parameters& p) {
  State state(p);
  testing::Noise shift(1e-4 * block_spacing(p));
  shift.fill(state.u_x);
  shift.fill(state.u_z);
  return state;
}

void bulk_step(benchmark::State& bench) {
  const Parameters p;
  State state = shaken(p);
  Bulk bulk(p);
  const std::vector<double> none(static_cast<std::size_t>(p.Nx));
  const Boundary free = {none.data(), none.data(), none.data(), driving_row(p), 0.0};
  bulk.half_kick_and_drift(0, state);
  for (auto _ : bench) {
    for (std::int64_t n = 0; n < kSteps; ++n) {
      bulk.keep_neighbouring_rows(0, state);
      bulk.add_forces_and_half_kick(0, free, Then::go_on, state);
    }
    benchmark::ClobberMemory();
  }
  bench.SetItemsProcessed(bench.iterations() * kSteps);
}

void bulk_force(benchmark::State& bench, void (*compute)(Bulk&, State&)) {
  State state = loading_state();
  Bulk bulk{Parameters{}};
  for (auto _ : bench) {
    compute(bulk, state);
    benchmark::ClobberMemory();
  }
  bench.SetItemsProcessed(bench.iterations());
}

// --- the junctions alone ------------------------------------------------------------------------

/// The junction law of all blocks, with the normal forces that it needs, where all junctions are
/// pinned, or slip until a time that does not come.
void junctions(benchmark::State& bench, double repin_time) {
  const Parameters p;
  State state = loading_state();
  state.junctions.repin_time.setConstant(repin_time);
  const auto law = make_law(p, state.junctions);
  const double t = time(p, state);
  std::vector<double> normal(static_cast<std::size_t>(p.Nx)), k_ij(normal), w(normal), tau(normal),
      kappa(normal.size(), p.kappa[0]);
  const ContactView contact = {normal.data(), k_ij.data(), w.data()};
  for (auto _ : bench) {
    kernels().contact(p.Nx, state.u_z.row(0), foundation_stiffness(p), static_cast<double>(p.N_s),
                      kappa.data(), contact);
    benchmark::DoNotOptimize(law->update(state.u_x.row(0), state.v_x.row(0), contact, t));
    law->friction(state.u_x.row(0), contact, tau.data());
    benchmark::ClobberMemory();
  }
  bench.SetItemsProcessed(bench.iterations());
}

// --- other sizes --------------------------------------------------------------------------------

/// The reference slider `factor` times as long and high, with the same spacing of blocks, load per
/// length, density and driving height: (56 factor + 1) x (30 factor + 1) blocks.
Parameters enlarged(std::int64_t factor) {
  const Parameters p;
  Parameters larger = testing::small_slider((p.Nx - 1) * factor + 1, (p.Nz - 1) * factor + 1);
  larger.h = p.h;
  return larger;
}

/// The same run with 1, 2, 4, ... threads, in turn; iterations are turns.
void sizes(benchmark::State& bench, std::int64_t factor) {
  struct Run {
    unsigned threads;
    std::unique_ptr<Simulation> simulation;
    std::vector<double> seconds = {}, speedup = {};
  };
  const Parameters p = enlarged(factor);
  constexpr std::int64_t blocks_per_turn = 20'000'000;  // some 50 ms
  const std::int64_t steps = std::max(kSteps, blocks_per_turn / (p.Nx * p.Nz));
  std::vector<Run> runs;
  for (unsigned n = 1; n <= std::max(1U, std::thread::hardware_concurrency()); n *= 2) {
    // The equilibrium of the largest would take longer to solve than to measure.
    const State state = tools::roughly_loaded(p);
    runs.push_back({n, std::make_unique<Simulation>(p, state, static_cast<int>(n))});
    runs.back().simulation->advance(kSteps);  // warms up
  }
  for (auto _ : bench) {
    for (Run& run : runs) {
      run.seconds.push_back(seconds_for([&] { run.simulation->advance(steps); }));
      run.speedup.push_back(runs.front().seconds.back() / run.seconds.back());
    }
    bench.SetIterationTime(runs.front().seconds.back());
  }
  for (const Run& run : runs) {
    const double best = *std::min_element(run.seconds.begin(), run.seconds.end());
    bench.counters[fmt::format("us_{}", run.threads)] = 1e6 / static_cast<double>(steps) * best;
    bench.counters[fmt::format("paired_{}", run.threads)] = *median(run.speedup);
    expect_nothing_broke(bench, *run.simulation, 0);
  }
  bench.counters["Nx"] = static_cast<double>(p.Nx);
  bench.counters["Nz"] = static_cast<double>(p.Nz);
}

BENCHMARK_CAPTURE(step_loading, , kSteps)->Name("step/loading");
BENCHMARK_CAPTURE(step_loading, one_by_one, 1)->Name("step/loading_one_by_one");
BENCHMARK(step_sliding)->Name("step/sliding");
BENCHMARK(bulk_step)->Name("bulk/step");
BENCHMARK_CAPTURE(bulk_force, , [](Bulk& bulk, State& s) {
  bulk.elastic(s.u_x, s.u_z, s.f_x, s.f_z);
})->Name("bulk/springs");
BENCHMARK_CAPTURE(bulk_force, , [](Bulk& bulk, State& s) {
  bulk.damping(s, s.f_x, s.f_z);
})->Name("bulk/damping");
BENCHMARK_CAPTURE(junctions, pinned, Junctions::never)->Name("junctions/pinned");
BENCHMARK_CAPTURE(junctions, slipping, 1e9)->Name("junctions/slipping");

/// "size/01", "size/02", ...: so the sizes are in order for --benchmark_filter, too.
[[maybe_unused]] const bool registered = [] {
  const std::string build = fmt::format("rupture {}, {}, {}", version, commit, kernels().name);
  benchmark::AddCustomContext("build", build);  // in the JSON
  for (const std::int64_t factor : {1, 2, 4, 8, 16, 32}) {
    benchmark::RegisterBenchmark(fmt::format("size/{:02}", factor).c_str(), sizes, factor)
        ->UseManualTime()
        ->Iterations(factor < 32 ? 11 : 5);
  }
  return true;
}();

}  // namespace
}  // namespace rupture::bench
