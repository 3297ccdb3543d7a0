#include "simulate.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "observers.hpp"
#include "rebuild.hpp"
#include "rupture/model/error.hpp"
#include "text.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

/// load.h5 at 0.05 s becomes load-t0.050000000.h5.
fs::path path_at(const fs::path& output, double t) {
  const auto name =
      fmt::format("{}-t{:.9f}{}", output.stem().string(), t, output.extension().string());
  return output.parent_path() / name;
}

std::vector<std::int64_t> checkpoint_steps(const Parameters& p, std::int64_t first,
                                           std::int64_t last, const RunOptions& run) {
  std::vector<std::int64_t> steps;
  for (const double t : run.checkpoint_at) {
    const std::int64_t step = step_at(p, t);
    if (step < first || step > last) {
      throw UsageError(fmt::format("--checkpoint-at {:g} is outside the run, {:g} s to {:g} s", t,
                                   static_cast<double>(first) * p.dt,
                                   static_cast<double>(last) * p.dt));
    }
    steps.push_back(step);
  }
  if (run.checkpoint_every) {
    const std::int64_t every = step_at(p, *run.checkpoint_every);
    if (every < 1) throw UsageError("--checkpoint-every is shorter than one time step");
    for (std::int64_t step = (first / every + 1) * every; step <= last; step += every) {
      steps.push_back(step);
    }
  }
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return steps;
}

/// Steps between samples, if there is a record.
std::optional<std::int64_t> sampling_steps(const Parameters& p, const RunOptions& run) {
  if (!run.record) return std::nullopt;
  const std::int64_t every = step_at(p, run.record_every);
  if (every < 1) throw UsageError("--record-every is shorter than one time step");
  return every;
}

void announce(const OutputOptions& output, const fs::path& path, const std::string& checksum) {
  if (output.verbosity == Verbosity::normal) {
    say("wrote {}  sha256 {}\n", path.string(), checksum);
    std::fflush(stdout);
  }
}

std::string_view reason(Ending ending) {
  switch (ending) {
    case Ending::quiet:
      return "no junction broke any more";
    case Ending::leading_edge:
      return "the front reached the leading edge";
    case Ending::last_step:
      break;
  }
  return "end of the run";
}

void print_invariants(const Simulation& simulation, Ending ending, const EnergyBalance& balance,
                      std::int64_t steps, double seconds) {
  say("t = {:.7g} s ({}), {} steps", simulation.time(), reason(ending), steps);
  if (steps > 0 && seconds > 0.0) {
    say(", {:.0f} steps/s", static_cast<double>(steps) / seconds);
  }
  say("\nenergy [J]: supplied {:.6e} = stored {:.6e} + dissipated {:.6e}, relative error {:.1e}\n",
      balance.supplied, balance.stored, balance.dissipated, balance.relative_error());
}

int thread_count(int threads) {
  constexpr int most = 1024;
  if (threads >= 1 && threads <= most) return threads;
  throw UsageError(
      fmt::format("--threads {} makes no sense: give a number from 1 to {}", threads, most));
}

/// Runs; if that fails, what was sampled so far stays readable in the record's .part.
Ending run_and_keep_record(Simulation& simulation, const StopRule& rule,
                           const std::vector<Observer*>& observers, RecordWriter* writer) {
  try {
    return rupture::run(simulation, rule, observers);
  } catch (...) {
    if (writer != nullptr) writer->flush();
    throw;
  }
}

}  // namespace

void add_run_options(po::options_description& options) {
  auto add = options.add_options();
  add("checkpoint-at", po::value<std::vector<double>>()->multitoken()->value_name("T..."),
      "write checkpoints at these times [s], named OUT-tT.h5");
  add("checkpoint-every", po::value<double>()->value_name("T"),
      "write a checkpoint each time T [s] has passed");
  add("record", po::value<std::string>()->value_name("FILE"),
      "record time series of the interface in FILE");
  add("record-every", po::value<double>()->default_value(1e-4, "1e-4")->value_name("T"),
      "sampling interval of the record [s]; ruptures are recorded to the step");
  add("threads", po::value<int>()->value_name("N"),
      "threads that share the work; default: as many as pay for this size of slider. Results do "
      "not depend on it");
}

RunOptions run_options(const po::variables_map& values) {
  RunOptions run;
  if (values.count("checkpoint-at") > 0) {
    run.checkpoint_at = values["checkpoint-at"].as<std::vector<double>>();
    for (const double t : run.checkpoint_at) {
      if (!std::isfinite(t)) non_negative(t, "checkpoint-at");
    }
  }
  run.checkpoint_every = optional_non_negative(values, "checkpoint-every");
  if (values.count("record") > 0) run.record = values["record"].as<std::string>();
  run.record_every = non_negative(values, "record-every");
  if (values.count("threads") > 0) run.threads = thread_count(values["threads"].as<int>());
  return run;
}

std::int64_t step_at(const Parameters& p, double t) {
  const double step = std::round(t / p.dt);
  if (!(std::abs(step) < 0x1p53)) {
    throw UsageError(fmt::format("t = {:g} s is too long a time for steps of {:g} s", t, p.dt));
  }
  return static_cast<std::int64_t>(step);
}

void simulate(Checkpoint start, const StopRule& rule, const RunOptions& run,
              const OutputOptions& output, const fs::path& input) {
  const Parameters& p = start.parameters;
  const std::int64_t first = start.state.step;
  const auto steps = checkpoint_steps(p, first, rule.last_step, run);
  std::vector<fs::path> outputs = {output.output};
  for (const std::int64_t step : steps) {
    outputs.push_back(path_at(output.output, static_cast<double>(step) * p.dt));
  }
  if (run.record) outputs.push_back(*run.record);
  const auto every = sampling_steps(p, run);
  check_outputs(outputs, output.if_exists, input);

  Simulation simulation(p, std::move(start.state), run.threads.value_or(threads_that_pay(p)));
  const auto save = [&](const fs::path& path) {
    const Checkpoint now = {p, simulation.state(),
                            run_until(start.provenance, p, simulation.state().step)};
    announce(output, path, write_checkpoint(path, now, output.if_exists));
  };
  CheckpointSchedule schedule(steps,
                              [&](const Simulation& s) { save(path_at(output.output, s.time())); });
  std::vector<Observer*> observers = {&schedule};

  std::unique_ptr<RecordWriter> writer;
  std::unique_ptr<Recorder> recorder;
  if (run.record) {
    writer = std::make_unique<RecordWriter>(
        *run.record, p, recorded_until(start.provenance, p, rule.last_step, *every),
        output.if_exists);
    recorder = std::make_unique<Recorder>(*writer, *every, first, rule.last_step);
    observers.push_back(recorder.get());
  }
  Progress progress(simulation, rule.last_step);
  const bool show_progress = on_terminal() && output.verbosity == Verbosity::normal;
  if (show_progress) observers.push_back(&progress);

  const Energies before = simulation.energies();
  const auto clock = std::chrono::steady_clock::now();
  const Ending ending = run_and_keep_record(simulation, rule, observers, writer.get());
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - clock;

  if (show_progress) progress.finish();
  if (recorder) {
    recorder->finish(simulation);
    announce(output, *run.record,
             writer->finish(recorded_until(start.provenance, p, simulation.state().step, *every)));
  }
  if (output.verbosity == Verbosity::normal) {
    print_invariants(simulation, ending,
                     energy_balance(before, simulation.energies(), simulation.work()),
                     simulation.state().step - first, elapsed.count());
  }
  save(output.output);
}

}  // namespace rupture::tools
