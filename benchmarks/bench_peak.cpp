// The best that this machine could do: + and * on registers, and rewriting memory.
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <cstdint>
#include <vector>

#include "rupture/forces/kernels.hpp"
#include "rupture/version.hpp"

namespace rupture::bench {
namespace {

// Sums, and as many products, that do not wait for one another: with their operands, they fill 16
// registers of `lanes` numbers. All are different, lest the compiler compute one for all.
constexpr int kChains = 7;
#define PEAK_LOOP(isa, lanes, target)                                              \
  target double peak_##isa(std::ptrdiff_t rounds, double summand, double factor) { \
    typedef double Lanes __attribute__((vector_size((lanes) * sizeof(double))));   \
    Lanes sum[kChains] = {}, product[kChains] = {};                                \
    for (int c = 0; c < kChains; ++c) {                                            \
      sum[c] = Lanes{} + (1.0 + c);                                                \
      product[c] = Lanes{} + (1.5 + c);                                            \
    }                                                                              \
    for (std::ptrdiff_t n = 0; n < rounds; ++n) {                                  \
      for (int c = 0; c < kChains; ++c) {                                          \
        sum[c] = sum[c] + summand;                                                 \
        product[c] = product[c] * factor;                                          \
      }                                                                            \
    }                                                                              \
    Lanes all = {};                                                                \
    for (int c = 0; c < kChains; ++c) all = all + (sum[c] + product[c]);           \
    double result = 0.0;                                                           \
    for (int lane = 0; lane < (lanes); ++lane) result += all[lane];                \
    return result;                                                                 \
  }
PEAK_LOOP(baseline, 2, )
#if defined(__x86_64__)
PEAK_LOOP(avx2, 4, __attribute__((target("avx2"))))
PEAK_LOOP(avx512, 8, __attribute__((target("avx512f"))))
#endif

struct Loop {
  double (*run)(std::ptrdiff_t rounds, double summand, double factor);
  std::ptrdiff_t lanes;
};

/// The loop for the instruction set that the kernels use.
Loop loop() {
#if defined(__x86_64__)
  if (kernels().name == "avx2") return {peak_avx2, 4};
  if (kernels().name == "avx512") return {peak_avx512, 8};
#endif
  return {peak_baseline, 2};
}

void sums_and_products(benchmark::State& bench) {
  const Loop peak = loop();
  constexpr std::ptrdiff_t rounds = 10'000;
  double summand = 1e-9, factor = 1.0 + 1e-9;
  benchmark::DoNotOptimize(factor);
  benchmark::DoNotOptimize(summand);
  for (auto _ : bench) benchmark::DoNotOptimize(peak.run(rounds, summand, factor));
  bench.SetItemsProcessed(bench.iterations() * rounds * 2 * kChains * peak.lanes);
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

/// In the JSON.
[[maybe_unused]] const bool said =
    (benchmark::AddCustomContext(
         "build", fmt::format("rupture {}, {}, {}", version, commit, kernels().name)),
     true);

}  // namespace
}  // namespace rupture::bench
