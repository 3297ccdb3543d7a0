// How the cost of a step grows with the size of the slider and falls with the number of threads.
#include <fmt/core.h>

#include <thread>

#include "run/plan.hpp"
#include "rupture/analysis/statistics.hpp"
#include "rupture/model/derived.hpp"
#include "sliders.hpp"

namespace rupture::bench {
namespace {

/// The reference slider `factor` times as long and high, with the same spacing of blocks, load per
/// length, density and driving height: (56 factor + 1) x (30 factor + 1) blocks.
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

/// "size/01", "size/02", ...: so the sizes are in order for --benchmark_filter, too.
[[maybe_unused]] const bool registered = [] {
  for (const std::int64_t factor : {1, 2, 4, 8, 16, 32}) {
    benchmark::RegisterBenchmark(fmt::format("size/{:02}", factor).c_str(), sizes, factor)
        ->UseManualTime()
        ->Iterations(factor < 32 ? 11 : 5);
  }
  return true;
}();

}  // namespace
}  // namespace rupture::bench
