// How long a time step and its parts take at reference size, 57 x 31 blocks and 5,700 junctions,
// with the instruction set that RUPTURE_ISA names or the widest one. See README.md.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/dynamics/equilibrium.hpp"
#include "rupture/dynamics/simulation.hpp"
#include "rupture/forces/bulk.hpp"
#include "rupture/forces/reference_law.hpp"
#include "rupture/model/derived.hpp"

namespace {

using namespace rupture;

Parameters driven_at(double V) {
  Parameters p;
  p.V = V;
  return p;
}

/// The slider under its normal load; solved once.
const State& equilibrium() {
  static const State state = normal_load_equilibrium(Parameters{});
  return state;
}

/// A state some time after driving started from equilibrium at speed V.
State driven(const Parameters& p, int steps) {
  Simulation simulation(p, equilibrium());
  for (int n = 0; n < steps; ++n) simulation.advance();
  return simulation.state();
}

/// Loading at the reference speed: nothing breaks.
const State& loading_state() {
  static const State state = driven(Parameters{}, 1000);
  return state;
}

/// Sliding at 0.5 m/s behind a rupture: all junctions slip, some break and are pinned again.
constexpr double kSliding = 0.5;  // [m/s]
const State& sliding_state() {
  static const State state = driven(driven_at(kSliding), 4000);
  return state;
}

/// A state with all junctions of all blocks slipping for a time without end.
State all_slipping() {
  State state = loading_state();
  constexpr double late = 1e9;  // [s]
  state.junctions.repin_time.setConstant(late);
  return state;
}

// --- whole steps --------------------------------------------------------------------------------

void step_between_events(benchmark::State& bench) {
  Simulation simulation(Parameters{}, loading_state());
  for (auto _ : bench) simulation.advance();
}

void step_all_slipping(benchmark::State& bench) {
  const Parameters p = driven_at(kSliding);
  std::optional<Simulation> simulation(std::in_place, p, sliding_state());
  constexpr int before_repinning = 4000;
  int steps = 0;
  for (auto _ : bench) {
    simulation->advance();
    if (++steps % before_repinning != 0) continue;
    bench.PauseTiming();
    simulation.emplace(p, sliding_state());
    bench.ResumeTiming();
  }
}

// --- parts of a step ----------------------------------------------------------------------------

void kick_and_drift(benchmark::State& bench) {
  State state = loading_state();
  Parameters p;
  p.dt = 1e-200;  // nothing moves
  const Bulk bulk{p};
  for (auto _ : bench) {
    bulk.kick_drift(0, state);
    benchmark::ClobberMemory();
  }
}

void springs(benchmark::State& bench) {
  State state = loading_state();
  Bulk bulk{Parameters{}};
  for (auto _ : bench) {
    bulk.elastic(state.u_x, state.u_z, state.f_x, state.f_z);
    benchmark::ClobberMemory();
  }
}

void damping(benchmark::State& bench) {
  State state = loading_state();
  Bulk bulk{Parameters{}};
  for (auto _ : bench) {
    bulk.damping(state.v_x, state.v_z, state.f_x, state.f_z);
    benchmark::ClobberMemory();
  }
}

void springs_damping_and_half_kick(benchmark::State& bench) {
  Parameters p;
  p.dt = 1e-200;  // nothing moves
  State state = loading_state();
  Bulk bulk(p);
  const std::vector<double> none(static_cast<std::size_t>(p.Nx));
  const Boundary boundary = {none.data(), none.data(), 0.0, driving_row(p), 0.0};
  for (auto _ : bench) {
    bulk.prepare(0, state);
    bulk.finish(0, boundary, Then::stop, state);
    benchmark::ClobberMemory();
  }
}

/// The junction law of all blocks, with the normal forces that it needs, at a state at rest.
void junctions_of(benchmark::State& bench, State state) {
  const Parameters p;
  ReferenceLaw law(p, state.junctions);
  const double t = time(p, state);
  std::vector<double> normal(static_cast<std::size_t>(p.Nx)), k_ij(normal), w(normal), tau(normal);
  const ContactView contact = {normal.data(), k_ij.data(), w.data()};
  for (auto _ : bench) {
    kernels().contact(p.Nx, state.u_z.row(0), foundation_stiffness(p), static_cast<double>(p.N_s),
                      p.kappa, contact);
    benchmark::DoNotOptimize(law.update(state.u_x.row(0), contact, t));
    law.friction(state.u_x.row(0), contact, tau.data());
    benchmark::ClobberMemory();
  }
}
void junctions_all_pinned(benchmark::State& bench) {
  junctions_of(bench, loading_state());
}
void junctions_all_slipping(benchmark::State& bench) {
  junctions_of(bench, all_slipping());
}

// --- what happens once in a while ---------------------------------------------------------------

void equilibrium_solve(benchmark::State& bench) {
  for (auto _ : bench) benchmark::DoNotOptimize(normal_load_equilibrium(Parameters{}));
}

/// A folder for the files of one benchmark, removed with them.
class Folder {
 public:
  Folder() {
    std::string name = std::filesystem::temp_directory_path() / "rupture-bench-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::filesystem::path file(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

void checkpoint_write(benchmark::State& bench) {
  const Folder folder;
  const Checkpoint checkpoint = {Parameters{}, loading_state(), {}};
  for (auto _ : bench) write_checkpoint(folder.file("c.h5"), checkpoint, IfExists::replace);
}

void checkpoint_read(benchmark::State& bench) {
  const Folder folder;
  write_checkpoint(folder.file("c.h5"), {Parameters{}, loading_state(), {}}, IfExists::refuse);
  for (auto _ : bench) benchmark::DoNotOptimize(read_checkpoint(folder.file("c.h5")));
}

Sample sample_of(const Simulation& simulation) {
  const State& state = simulation.state();
  Sample sample = {simulation.time(),
                   state.step,
                   simulation.F_T(),
                   simulation.x_drive(),
                   {},
                   {simulation.p().begin(), simulation.p().end()},
                   {},
                   {}};
  for (const auto n : simulation.pinned()) sample.pinned.push_back(static_cast<std::uint16_t>(n));
  sample.tau.assign(simulation.tau().begin(), simulation.tau().end());
  sample.u_x.assign(state.u_x.row(0), state.u_x.row(0) + state.u_x.Nx());
  return sample;
}

void record_sample(benchmark::State& bench) {
  const Folder folder;
  const Simulation simulation(Parameters{}, loading_state());
  RecordWriter writer(folder.file("r.h5"), Parameters{}, {}, IfExists::refuse);
  for (auto _ : bench) writer.append(sample_of(simulation));
}

BENCHMARK(step_between_events)->Unit(benchmark::kMicrosecond);
BENCHMARK(step_all_slipping)->Unit(benchmark::kMicrosecond);
BENCHMARK(kick_and_drift)->Unit(benchmark::kMicrosecond);
BENCHMARK(springs)->Unit(benchmark::kMicrosecond);
BENCHMARK(damping)->Unit(benchmark::kMicrosecond);
BENCHMARK(springs_damping_and_half_kick)->Unit(benchmark::kMicrosecond);
BENCHMARK(junctions_all_pinned)->Unit(benchmark::kMicrosecond);
BENCHMARK(junctions_all_slipping)->Unit(benchmark::kMicrosecond);
BENCHMARK(equilibrium_solve)->Unit(benchmark::kMicrosecond);
BENCHMARK(checkpoint_write)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK(checkpoint_read)->Unit(benchmark::kMicrosecond)->UseRealTime();
BENCHMARK(record_sample)->Unit(benchmark::kMicrosecond)->UseRealTime();

}  // namespace

int main(int argc, char** argv) {
  try {
    benchmark::AddCustomContext("instruction set", std::string(kernels().name));
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "bench_step: " << error.what() << '\n';
    return 1;
  }
}
