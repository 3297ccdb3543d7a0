#include "run/forecast.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "cli/report.hpp"
#include "cli/text.hpp"
#include "rupture/dynamics/equilibrium.hpp"
#include "rupture/dynamics/simulation.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::tools {
namespace {

constexpr double kMB = 1e6;  // [bytes]

/// The slider with which the equilibrium's time is compared: of reference size, with 85 x 46
/// blocks.
Parameters reference_slider() {
  Parameters p;
  p.Nx = 85;
  p.Nz = 46;
  p.dt = 1e-7;
  return p;
}

double blocks(const Parameters& p) {
  return static_cast<double>(p.Nx) * static_cast<double>(p.Nz);
}

double junctions(const Parameters& p) {
  return static_cast<double>(p.Nx) * static_cast<double>(springs_per_block(p));
}

/// Blocks times the shorter side of the lattice: what the work of the factorisation follows.
double bandwidth_sum(const Parameters& p) {
  return blocks(p) * static_cast<double>(std::min(p.Nx, p.Nz));
}

/// Six numbers per block, 21 bytes per junction; what the file has besides is nearly always the
/// same.
double checkpoint_size(const Parameters& p) {
  return 0.031 * kMB + 48.0 * blocks(p) + 21.0 * junctions(p);
}

/// Per sample four numbers, and three and a count per interface block; per sample of the fields two
/// numbers, and two of four bytes per block.
double record_size(const Workload& work) {
  if (work.samples == 0) return 0.0;
  const Parameters& p = work.parameters;
  return 0.035 * kMB +
         static_cast<double>(work.samples) * (32.0 + 26.0 * static_cast<double>(p.Nx)) +
         static_cast<double>(work.field_samples) * (16.0 + 8.0 * blocks(p));
}

/// Reading and writing keep several copies of a checkpoint, and of the record when it is completed.
double run_memory(const Parameters& p, double record) {
  return 20.5 * kMB + 6.7 * checkpoint_size(p) + 3.5 * record;
}

bool dissected(const Parameters& p) {
  return p.Nx * p.Nz > kBlocksOfDissection;
}

/// The factorisation fills in the more the wider the lattice is, hardly so with nested dissection.
double equilibrium_memory(const Parameters& p) {
  const double width = std::log2(static_cast<double>(std::min(p.Nx, p.Nz)));
  const double per_block = dissected(p) ? 3500.0 + 200.0 * width : 1300.0 * width;
  return 13.5 * kMB + per_block * blocks(p);
}

double equilibrium_time(const Parameters& p, double reference) {
  if (dissected(p)) {
    const auto side = static_cast<double>(std::min(p.Nx, p.Nz));
    return reference * (0.25 + 0.003 * side) * blocks(p) / blocks(reference_slider());
  }
  return reference * std::pow(bandwidth_sum(p) / bandwidth_sum(reference_slider()), 0.9);
}

// --- words

std::string size_text(double bytes) {
  return bytes < 1000.0 * kMB ? rounded(bytes / kMB) + " MB"
                              : rounded(bytes / (1000.0 * kMB)) + " GB";
}

std::string disk_text(const Forecast& f) {
  std::string text = fmt::format("{}: {} checkpoint{} of {}", size_text(f.disk()),
                                 grouped(static_cast<double>(f.work.checkpoints)),
                                 f.work.checkpoints == 1 ? "" : "s", size_text(f.checkpoint));
  if (f.work.samples > 0) {
    const auto fields = static_cast<double>(f.work.field_samples);
    text += fmt::format("; record of {} samples{}, {}, and 24 bytes for each rupture of a block",
                        grouped(static_cast<double>(f.work.samples)),
                        fields > 0 ? fmt::format(" and {} of all blocks", grouped(fields)) : "",
                        size_text(f.record));
  }
  return text;
}

std::string time_account(const Forecast& f) {
  std::string text =
      fmt::format("{}: {} per step, measured now", time_text(f.time()), time_text(f.time_per_step));
  if (f.work.from == RunsFrom::equilibrium) {
    text += fmt::format("; {} for the equilibrium", time_text(f.equilibrium_time));
  }
  return text;
}

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

double Forecast::simulated_time() const {
  return static_cast<double>(steps()) * work.parameters.dt;
}

double Forecast::disk() const {
  return static_cast<double>(work.checkpoints) * checkpoint + record;
}

double Forecast::time() const {
  return equilibrium_time + static_cast<double>(steps()) * time_per_step;
}

Forecast forecast(const Workload& work, const State& state) {
  const Parameters& p = work.parameters;
  Simulation simulation(p, state, work.threads);
  const double record = record_size(work);
  Forecast f = {.work = work,
                .memory = run_memory(p, record),
                .checkpoint = checkpoint_size(p),
                .record = record,
                .time_per_step = time_per_step(simulation)};
  if (work.from == RunsFrom::equilibrium) {
    const double reference = seconds_of([] { normal_load_equilibrium(reference_slider()); });
    f.memory = std::max(f.memory, equilibrium_memory(p));
    f.equilibrium_time = equilibrium_time(p, reference);
  }
  return f;
}

std::string text_of(const Forecast& f) {
  const Parameters& p = f.work.parameters;
  const bool known = f.work.end == End::known;
  const char* about = known ? "about" : "at most about";
  return fmt::format(
      "steps    {}{}, {:.6g} s simulated{}\n"
      "slider   {} blocks, {} junctions\n"
      "threads  {}\n"
      "memory   {} {}\n"
      "disk     {} {}\n"
      "time     {} {}\n",
      known ? "" : "at most ", grouped(static_cast<double>(f.steps())), f.simulated_time(),
      known ? "" : "; the run ends earlier if it becomes quiet", grouped(blocks(p)),
      grouped(junctions(p)), f.work.threads, about, size_text(f.memory), about, disk_text(f), about,
      time_account(f));
}

std::string json_text(const Forecast& f) {
  const auto whole = [](double value) { return std::llround(value); };
  const Json json = {{"steps", f.steps()},
                     {"simulated_time", f.simulated_time()},
                     {"at_most", f.work.end == End::at_the_latest},
                     {"blocks", whole(blocks(f.work.parameters))},
                     {"junctions", whole(junctions(f.work.parameters))},
                     {"threads", f.work.threads},
                     {"memory", whole(f.memory)},
                     {"disk", whole(f.disk())},
                     {"checkpoints", f.work.checkpoints},
                     {"time", f.time()},
                     {"time_per_step", f.time_per_step}};
  return json_text(json);
}

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

}  // namespace rupture::tools
