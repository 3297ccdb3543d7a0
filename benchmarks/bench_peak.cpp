// The best that this machine could do: + and * on registers, and rewriting memory.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <map>
#include <string_view>
#include <vector>

#include "rupture/forces/kernels.hpp"

namespace rupture::bench {

#if defined(__x86_64__)
extern const std::ptrdiff_t peak_flops_sse2, peak_flops_avx2, peak_flops_avx512;
double peak_sse2(std::ptrdiff_t rounds, double summand, double factor);
double peak_avx2(std::ptrdiff_t rounds, double summand, double factor);
double peak_avx512(std::ptrdiff_t rounds, double summand, double factor);
#else
extern const std::ptrdiff_t peak_flops_baseline;
double peak_baseline(std::ptrdiff_t rounds, double summand, double factor);
#endif

namespace {

struct Loop {
  double (*run)(std::ptrdiff_t rounds, double summand, double factor);
  std::ptrdiff_t flops;
};

/// The loop for the instruction set that the kernels use.
Loop loop() {
#if defined(__x86_64__)
  const std::map<std::string_view, Loop> loops = {{"sse2", {peak_sse2, peak_flops_sse2}},
                                                  {"avx2", {peak_avx2, peak_flops_avx2}},
                                                  {"avx512", {peak_avx512, peak_flops_avx512}}};
  return loops.at(kernels().name);
#else
  return {peak_baseline, peak_flops_baseline};
#endif
}

void sums_and_products(benchmark::State& bench) {
  const Loop peak = loop();
  constexpr std::ptrdiff_t rounds = 10'000;
  double summand = 1e-9, factor = 1.0 + 1e-9;
  benchmark::DoNotOptimize(factor);
  benchmark::DoNotOptimize(summand);
  for (auto _ : bench) benchmark::DoNotOptimize(peak.run(rounds, summand, factor));
  bench.SetItemsProcessed(bench.iterations() * rounds * peak.flops);
}

/// Reads and writes an array far larger than any cache, as a step on a very large slider does.
void rewrite_memory(benchmark::State& bench) {
  std::vector<double> values(std::size_t{1} << 25U, 1.0);  // 256 MiB
  double factor = 1.0 + 1e-9;
  benchmark::DoNotOptimize(factor);
  for (auto _ : bench) {
    for (double& value : values) value *= factor;
    benchmark::ClobberMemory();
  }
  const auto bytes = static_cast<std::int64_t>(2 * sizeof(double) * values.size());
  bench.SetItemsProcessed(bench.iterations() * bytes);
}

BENCHMARK(sums_and_products)->Name("peak/sums_and_products");
BENCHMARK(rewrite_memory)->Name("memory/rewrite");

}  // namespace
}  // namespace rupture::bench
