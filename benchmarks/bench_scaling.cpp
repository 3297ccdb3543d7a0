// How the cost of a step grows with the size of the slider and falls with the number of threads.
#include <benchmark/benchmark.h>
#include <fmt/core.h>
#if defined(__GLIBC__)
#include <malloc.h>
#endif
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <thread>
#include <vector>

#include "sliders.hpp"

namespace rupture::bench {
namespace {

/// Memory that this process occupies now, what was freed not counted [bytes]; 0 where the system
/// does not say.
double resident_bytes() {
#if defined(__GLIBC__)
  ::malloc_trim(0);
#endif
  std::ifstream statm("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  statm >> total >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// 1, 2, 4, ... up to the processors there are.
std::vector<int> thread_counts() {
  std::vector<int> counts;
  const int most = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  for (int threads = 1; threads <= most; threads *= 2) counts.push_back(threads);
  return counts;
}

/// The same run with each number of threads, in turn; iterations are turns.
void scaling(benchmark::State& bench, std::int64_t factor) {
  const Parameters p = enlarged(factor);
  const std::int64_t blocks = p.Nx * p.Nz;
  constexpr std::int64_t blocks_per_turn = 20'000'000;  // some 50 ms
  const std::int64_t steps = std::max(kSteps, blocks_per_turn / blocks);

  const std::vector<int> threads = thread_counts();
  std::vector<std::unique_ptr<Simulation>> simulations;
  const double before = resident_bytes();
  for (const int n : threads) {
    simulations.push_back(std::make_unique<Simulation>(p, evenly_compressed(p), n));
    if (n == 1) bench.counters["resident_bytes"] = resident_bytes() - before;
  }
  for (const auto& simulation : simulations) simulation->advance(kSteps);  // warms up

  std::vector<std::vector<double>> seconds(threads.size()), speedup(threads.size());
  for (auto _ : bench) {
    for (std::size_t n = 0; n < threads.size(); ++n) {
      seconds[n].push_back(seconds_for([&] { simulations[n]->advance(steps); }));
      speedup[n].push_back(seconds[0].back() / seconds[n].back());
    }
    bench.SetIterationTime(seconds[0].back());
  }

  for (std::size_t n = 0; n < threads.size(); ++n) {
    const double best = *std::min_element(seconds[n].begin(), seconds[n].end());
    bench.counters[fmt::format("us_{}", threads[n])] = 1e6 / static_cast<double>(steps) * best;
    bench.counters[fmt::format("speedup_{}", threads[n])] = median(speedup[n]);
  }
  // A step reads and writes u and v; the net force is written in the last one of a call only.
  const State& state = simulations.front()->state();
  constexpr double value_bytes = sizeof(double);
  const double field_bytes = value_bytes * static_cast<double>(state.u_x.stride() * (p.Nz + 2));
  constexpr double junction_bytes = 2 * value_bytes + sizeof(std::uint32_t);
  bench.counters["swept_bytes"] = 4.0 * field_bytes;
  bench.counters["state_bytes"] =
      6.0 * field_bytes + junction_bytes * static_cast<double>(p.Nx * p.N_s);
  bench.counters["Nx"] = static_cast<double>(p.Nx);
  bench.counters["Nz"] = static_cast<double>(p.Nz);
  bench.counters["junctions"] = static_cast<double>(p.Nx * p.N_s);
  for (const auto& simulation : simulations) expect_nothing_broke(bench, *simulation, 0);
}

/// "size/01", "size/02", ...: so the sizes are in order for --benchmark_filter, too.
[[maybe_unused]] const bool registered = [] {
  for (const std::int64_t factor : {1, 2, 4, 8, 16, 32}) {
    benchmark::RegisterBenchmark(fmt::format("size/{:02}", factor).c_str(), scaling, factor)
        ->UseManualTime()
        ->Iterations(factor < 32 ? 11 : 5);
  }
  return true;
}();

}  // namespace
}  // namespace rupture::bench
