#include "run/run_options.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "cli/option_values.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/rupture.hpp"

namespace rupture::tools {
namespace {

int thread_count(int threads) {
  constexpr int most = 1024;
  if (threads >= 1 && threads <= most) return threads;
  throw UsageError(
      fmt::format("--threads {} makes no sense: give a number from 1 to {}", threads, most));
}

/// Throws UsageError if there is no record for options that say what is recorded.
void refuse_without_record(const po::variables_map& values) {
  if (values.count("record") > 0) return;
  for (const char* option : {"record-every", "crossings", "fields"}) {
    if (values.count(option) == 0 || values[option].defaulted()) continue;
    throw UsageError(fmt::format("--{} needs a record: give --record as well", option));
  }
}

/// The levels of --crossings, ascending, so that equal records come from equal commands.
std::vector<double> crossing_levels(const po::variables_map& values) {
  if (values.count("crossings") == 0) return {};
  auto levels = fractions(values, "crossings");
  if (std::find(levels.begin(), levels.end(), kRupturedFraction) != levels.end()) {
    throw UsageError(
        fmt::format("--crossings {} is recorded always: leave it out", kRupturedFraction));
  }
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

DryRun dry_run(const po::variables_map& values) {
  if (values.count("dry-run") == 0) return DryRun::no;
  return values.count("json") > 0 ? DryRun::json : DryRun::text;
}

/// Throws UsageError if the time that `option` gives is shorter than a step.
Interval interval(const Parameters& p, const Clock& clock, double t, std::string_view option) {
  constexpr double rounding = 1e-9, half = 0.5 - 1e-6;  // a tie is decided once, by `zero`
  steps_in(p, t);                                       // not too long
  const std::int64_t zero = step_at(p, clock, 0.0);
  const double offset = std::clamp(-time_at(p, clock, zero) / p.dt, -half, half);
  if (t >= p.dt * (1.0 - rounding)) return {std::max(t, p.dt), p.dt, zero, offset};
  throw UsageError(fmt::format("--{} is shorter than one time step", option));
}

}  // namespace

void add_run_options(po::options_description& options) {
  auto add = options.add_options();
  add("checkpoint-at", list_of_seconds(), "write checkpoints at these times, named OUT-tT.h5");
  add("checkpoint-every", seconds(), "write a checkpoint each time T has passed");
  add("record", output_file("record"), "record time series of the interface in FILE");
  add("record-every", seconds()->default_value(1e-4, "1e-4"),
      "sampling interval of the record; ruptures are recorded to the step");
  add("crossings", text("F,..."),
      "pinned fractions besides 0.3 whose crossing by a block is recorded, such as 0.2,0.5");
  add("fields", seconds(),
      "sampling interval of the displacement of all blocks, for pictures and movies; part of the "
      "record, 8 bytes per block and sample; default: none");
  add("threads", integer("N"),
      "threads that share the work; default: as many as pay for this size of slider. Results do "
      "not depend on it");
  add_alarm_option(options);
  add("resume",
      "if the same run was interrupted, go on from its newest checkpoint OUT-tT.h5 and with its "
      "record; the result is that of an uninterrupted run");
  add("dry-run",
      "write nothing: check the command and print about how much time, memory and disk it needs. "
      "The time per step is measured now, for half a second, from the checkpoint or, for load, "
      "near the equilibrium, which is not solved for");
}

RunOptions run_options(const Parsed& parsed) {
  const auto& values = parsed.values;
  RunOptions run;
  run.arguments = parsed.arguments;
  if (values.count("checkpoint-at") > 0) {
    run.checkpoint_at = values["checkpoint-at"].as<std::vector<double>>();
    for (const double t : run.checkpoint_at) {
      if (!std::isfinite(t)) non_negative(t, "checkpoint-at");
    }
  }
  run.checkpoint_every = optional_non_negative(values, "checkpoint-every");
  if (values.count("record") > 0) run.record = file_to_write(values, "record");
  run.record_every = non_negative(values, "record-every");
  refuse_without_record(values);
  run.crossings = crossing_levels(values);
  run.fields = optional_non_negative(values, "fields");
  run.on_alarm = on_alarm(values);
  run.resume = values.count("resume") > 0 ? Resume::yes : Resume::no;
  run.dry_run = dry_run(values);
  if (values.count("threads") > 0) run.threads = thread_count(values["threads"].as<int>());
  return run;
}

std::int64_t steps_in(const Parameters& p, double duration) {
  const double steps = std::round(duration / p.dt);
  if (!(std::abs(steps) < 0x1p53)) {
    throw UsageError(
        fmt::format("t = {:g} s is too long a time for steps of {:g} s", duration, p.dt));
  }
  return static_cast<std::int64_t>(steps);
}

std::int64_t step_at(const Parameters& p, const Clock& clock, double t) {
  return clock.origin_step + steps_in(p, t - clock.origin_time);
}

std::vector<std::int64_t> checkpoint_steps(const Parameters& p, const State& first,
                                           std::int64_t last, const RunOptions& run) {
  std::vector<std::int64_t> steps;
  for (const double t : run.checkpoint_at) {
    const std::int64_t step = step_at(p, first.clock, t);
    if (step < first.step || step > last) {
      throw UsageError(fmt::format("--checkpoint-at {:g} is outside the run, {:g} s to {:g} s", t,
                                   time(p, first), time_at(p, first.clock, last)));
    }
    steps.push_back(step);
  }
  if (run.checkpoint_every) {
    const Interval every = interval(p, first.clock, *run.checkpoint_every, "checkpoint-every");
    constexpr std::int64_t most = 1'000'000;
    if (const auto count = every.number_at(last) - every.number_at(first.step); count > most) {
      throw UsageError(
          fmt::format("--checkpoint-every {:g} would write {} checkpoints: give a longer time",
                      *run.checkpoint_every, count));
    }
    for (auto step = every.after(first.step); step <= last; step = every.after(step)) {
      steps.push_back(step);
    }
  }
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return steps;
}

Interval sampling_interval(const Parameters& p, const Clock& clock, const RunOptions& run) {
  return interval(p, clock, run.record_every, "record-every");
}

std::optional<Interval> fields_interval(const Parameters& p, const Clock& clock,
                                        const RunOptions& run) {
  if (!run.fields) return std::nullopt;
  return interval(p, clock, *run.fields, "fields");
}

}  // namespace rupture::tools
