// Time, memory and disk of a run, forecast from its plan and how fast this machine is.
//
// The constants come from measurements of lattices from 57 x 31 to 449 x 241 blocks (x86-64, Debian
// 12, gcc 12.2).
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "cli/report.hpp"
#include "run/plan.hpp"
#include "rupture/dynamics/equilibrium.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::tools {
namespace {

constexpr double kMB = 1e6;  // [bytes]

/// The needs of what is left of a run. Ruptures in the record, 24 bytes each, are not counted.
struct Forecast {
  const RunPlan& plan;
  const Parameters& parameters;
  std::int64_t steps = 0;
  std::int64_t checkpoints = 0;    ///< that at the end included
  std::int64_t samples = 0;        ///< of the record; 0 without one
  std::int64_t field_samples = 0;  ///< of its fields; 0 without them
  double memory = 0;               ///< peak of the process [bytes]
  double checkpoint = 0;           ///< size of one checkpoint [bytes]
  double record = 0;               ///< size of the record, 0 without one [bytes]
  double equilibrium_time = 0;     ///< 0 if none is looked for [s]
  double time_per_step = 0;        ///< [s]

  bool at_most() const { return plan.rule.quiet_steps && !plan.is_complete; }
  double simulated_time() const { return static_cast<double>(steps) * parameters.dt; }  ///< [s]
  double disk() const { return static_cast<double>(checkpoints) * checkpoint + record; }
  double time() const { return equilibrium_time + static_cast<double>(steps) * time_per_step; }
};

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
double record_size(const Forecast& f) {
  if (f.samples == 0) return 0.0;
  const Parameters& p = f.parameters;
  return 0.035 * kMB + static_cast<double>(f.samples) * (32.0 + 26.0 * static_cast<double>(p.Nx)) +
         static_cast<double>(f.field_samples) * (16.0 + 8.0 * blocks(p));
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

Forecast forecast_of(const RunPlan& plan) {
  const Parameters& p = plan.start.parameters;
  Forecast f = {plan, p};
  if (!plan.is_complete) {
    const std::int64_t first = plan.start.run->first_step, last = plan.rule.last_step;
    f.steps = last - plan.begin.state.step;
    f.checkpoints = std::ssize(plan.checkpoints) + 1;
    if (plan.options.record) f.samples = plan.record_every.samples(first, last);
    if (plan.fields_every) f.field_samples = plan.fields_every->samples(first, last);
  }
  f.checkpoint = checkpoint_size(p);
  f.record = record_size(f);
  f.memory = run_memory(p, f.record);
  Simulation simulation(p, plan.begin.state, plan.threads);
  f.time_per_step = time_per_step(simulation);
  if (plan.finds_equilibrium) {
    const double reference = seconds_of([] { normal_load_equilibrium(reference_slider()); });
    f.memory = std::max(f.memory, equilibrium_memory(p));
    f.equilibrium_time = equilibrium_time(p, reference);
  }
  return f;
}

// --- words

std::string size_text(double bytes) {
  return bytes < 1000.0 * kMB ? rounded(bytes / kMB) + " MB"
                              : rounded(bytes / (1000.0 * kMB)) + " GB";
}

std::string disk_text(const Forecast& f) {
  std::string text = fmt::format("{}: {} checkpoint{} of {}", size_text(f.disk()),
                                 grouped(static_cast<double>(f.checkpoints)),
                                 f.checkpoints == 1 ? "" : "s", size_text(f.checkpoint));
  if (f.samples > 0) {
    const auto fields = static_cast<double>(f.field_samples);
    text += fmt::format("; record of {} samples{}, {}, and 24 bytes for each rupture of a block",
                        grouped(static_cast<double>(f.samples)),
                        fields > 0 ? fmt::format(" and {} of all blocks", grouped(fields)) : "",
                        size_text(f.record));
  }
  return text;
}

std::string time_account(const Forecast& f) {
  std::string text =
      fmt::format("{}: {} per step, measured now", time_text(f.time()), time_text(f.time_per_step));
  if (f.plan.finds_equilibrium) {
    text += fmt::format("; {} for the equilibrium", time_text(f.equilibrium_time));
  }
  return text;
}

std::string text_of(const Forecast& f) {
  const Parameters& p = f.parameters;
  const char* about = f.at_most() ? "at most about" : "about";
  return fmt::format(
      "steps    {}{}, {:.6g} s simulated{}\n"
      "slider   {} blocks, {} junctions\n"
      "threads  {}\n"
      "memory   {} {}\n"
      "disk     {} {}\n"
      "time     {} {}\n",
      f.at_most() ? "at most " : "", grouped(static_cast<double>(f.steps)), f.simulated_time(),
      f.at_most() ? "; the run ends earlier if it becomes quiet" : "", grouped(blocks(p)),
      grouped(junctions(p)), f.plan.threads, about, size_text(f.memory), about, disk_text(f), about,
      time_account(f));
}

Json json_of(const Forecast& f) {
  const auto whole = [](double value) { return std::llround(value); };
  return {{"steps", f.steps},
          {"simulated_time", f.simulated_time()},
          {"at_most", f.at_most()},
          {"blocks", whole(blocks(f.parameters))},
          {"junctions", whole(junctions(f.parameters))},
          {"threads", f.plan.threads},
          {"memory", whole(f.memory)},
          {"disk", whole(f.disk())},
          {"checkpoints", f.checkpoints},
          {"time", f.time()},
          {"time_per_step", f.time_per_step}};
}

}  // namespace

std::string forecast(const RunPlan& plan) {
  const Forecast needs = forecast_of(plan);
  return plan.options.output.json ? json_text(json_of(needs)) + "\n" : text_of(needs);
}

State roughly_loaded(const Parameters& p) {
  State state = compressed(p);
  const double strain = p.F_N / (p.L * p.B) / p.E;
  for (std::int64_t i = 0; i < p.Nx; ++i) {
    // Also sideways: where nothing at all moves, steps would take another time.
    const double u_x = kPoissonRatio * strain * (block_position(p, i) - 0.5 * p.L);
    state.u_x.blocks().col(i).setConstant(u_x);
    state.junctions.attachment.row(i).setConstant(u_x);
  }
  state.drive.origin_position = state.u_x(0, driving_row(p));
  return state;
}

}  // namespace rupture::tools
