// Benchmarks of rare operations: equilibrium, checkpoints, records; at reference size.

#include "run/observers.hpp"
#include "rupture/analysis/statistics.hpp"
#include "sliders.hpp"
#include "support/files.hpp"

namespace rupture::bench {
namespace {

using testing::Folder;

void equilibrium_solve(benchmark::State& bench) {
  for (auto _ : bench) benchmark::DoNotOptimize(normal_load_equilibrium(Parameters{}));
  bench.SetItemsProcessed(bench.iterations());
}

void checkpoint_write(benchmark::State& bench) {
  const Folder folder;
  const Checkpoint checkpoint = {Parameters{}, loading_state(), {}};
  for (auto _ : bench) write_checkpoint(folder.file("c.h5"), checkpoint, IfExists::replace);
  bench.SetItemsProcessed(bench.iterations());
}

void checkpoint_read(benchmark::State& bench) {
  const Folder folder;
  write_checkpoint(folder.file("c.h5"), {Parameters{}, loading_state(), {}}, IfExists::refuse);
  for (auto _ : bench) benchmark::DoNotOptimize(read_checkpoint(folder.file("c.h5")));
  bench.SetItemsProcessed(bench.iterations());
}

double sum_of_last_two(const std::vector<double>& values) {
  return values.back() + values[values.size() - 2];
}

/// Two equal runs, of which one is recorded every so many steps, in turn, stretch by stretch. A
/// stretch is as long as the record's buffer, so that each holds one flush (of fields, some three).
/// The runs change roles after each stretch: where their arrays lie in memory must not matter.
/// Iterations are stretches.
void record(benchmark::State& bench, Fields fields, std::int64_t every) {
  const std::int64_t stretch = 256 * every;
  const RecordParts parts = {.fields = fields};
  const Parameters p;
  Simulation run_a(p, loading_state()), run_b(p, loading_state());
  const Folder folder;
  RecordWriter writer(folder.file("r.h5"), p, {}, IfExists::refuse, {}, parts);
  const std::int64_t last = run_a.state().step + bench.max_iterations * stretch;
  tools::RunPlan plan;
  plan.rule.last_step = last;
  plan.begin.state = run_a.state();
  plan.record_every = {static_cast<double>(every)};
  if (fields == Fields::record) plan.fields_every = plan.record_every;
  tools::Recorder recorder(writer, plan);

  std::vector<double> without, with, ratio;
  bool record_a = false;
  for (auto _ : bench) {
    const StopRule rule = {run_a.state().step + stretch, {}};
    const std::vector<Observer*> none;
    const std::vector<Observer*> all = {&recorder};
    const double a = seconds_for([&] { run(run_a, rule, record_a ? all : none); });
    const double b = seconds_for([&] { run(run_b, rule, record_a ? none : all); });
    with.push_back(record_a ? a : b);
    without.push_back(record_a ? b : a);
    if (record_a) ratio.push_back(sum_of_last_two(with) / sum_of_last_two(without));
    record_a = !record_a;
    bench.SetIterationTime(with.back());
  }
  const double finish = seconds_for([&] {
    recorder.finish(run_a);
    writer.finish();
  });

  const auto stretches = static_cast<double>(with.size()), steps = static_cast<double>(stretch);
  const double finish_per_stretch = finish / stretches;
  bench.counters["us_without"] = 1e6 / steps * *std::min_element(without.begin(), without.end());
  bench.counters["us_with"] = 1e6 / steps * *std::min_element(with.begin(), with.end());
  bench.counters["cost_running"] = *median(ratio) - 1.0;
  bench.counters["cost"] = *median(ratio) - 1.0 + finish_per_stretch / *median(without);
}

BENCHMARK(equilibrium_solve)->Name("once/equilibrium_solve");
BENCHMARK(checkpoint_write)->Name("once/checkpoint_write")->UseRealTime();
BENCHMARK(checkpoint_read)->Name("once/checkpoint_read")->UseRealTime();
// Every 10 us and 20 us.
BENCHMARK_CAPTURE(record, cost, Fields::omit, 50)->UseManualTime()->Iterations(16);
BENCHMARK_CAPTURE(record, fields, Fields::record, 100)->UseManualTime()->Iterations(16);

}  // namespace
}  // namespace rupture::bench
