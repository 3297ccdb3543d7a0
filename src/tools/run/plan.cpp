#include "run/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/option_values.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

/// Throws UsageError if there is no record for options that say what is recorded.
void refuse_without_record(const po::variables_map& values) {
  if (values.count("record") > 0) return;
  for (const char* option : {"record-every", "crossings", "fields"}) {
    if (values.count(option) == 0 || values[option].defaulted()) continue;
    throw UsageError(fmt::format("--{} needs --record: give both", option));
  }
}

/// The levels of --crossings, ascending, so that equal records come from equal commands.
std::vector<double> crossing_levels(const po::variables_map& values) {
  if (values.count("crossings") == 0) return {};
  auto levels = fractions(values, "crossings");
  if (std::find(levels.begin(), levels.end(), kRupturedFraction) != levels.end()) {
    throw UsageError(
        fmt::format("--crossings {} is always recorded: leave it out", kRupturedFraction));
  }
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

DryRun dry_run(const po::variables_map& values) {
  if (values.count("dry-run") == 0) return DryRun::no;
  return values.count("json") > 0 ? DryRun::json : DryRun::text;
}

/// The steps in a run from `first` to `last` at which checkpoints are wanted, in order. Throws
/// UsageError if one is outside.
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

/// Where the run goes on, if it was interrupted; else its start.
Resumption beginning(const RunPlan& plan, std::optional<Resumption> found) {
  if (!found) return {plan.start, {}, {}};
  ProvenanceEntry entry = plan.start.provenance.back();
  entry.parent_checksum = found->checkpoint.checksum;
  entry.rebuild = "restart";
  found->checkpoint.provenance.push_back(std::move(entry));
  return std::move(*found);
}

/// The checkpoints on the way at these steps.
std::vector<fs::path> paths_at(const std::vector<std::int64_t>& steps, const RunPlan& plan) {
  std::vector<fs::path> paths;
  paths.reserve(steps.size());
  for (const std::int64_t step : steps) {
    const double t = time_at(plan.start.parameters, plan.start.state.clock, step);
    paths.push_back(path_at(plan.files.output, t));
  }
  return paths;
}

/// Of a run that goes on, takes the checkpoints that were written before from those to come.
void leave_out_what_was_written(RunPlan& plan) {
  auto& steps = plan.checkpoint_steps;
  const auto later = std::upper_bound(steps.begin(), steps.end(), plan.begin.checkpoint.state.step);
  plan.written_before = paths_at({steps.begin(), later}, plan);
  plan.written_before.push_back(plan.begin.file);
  steps.erase(steps.begin(), later);
}

void check_files(const RunPlan& plan, const fs::path& input) {
  auto checkpoints = paths_at(plan.checkpoint_steps, plan);
  checkpoints.push_back(plan.files.output);
  auto all = checkpoints;
  if (plan.files.record) all.push_back(*plan.files.record);
  check_distinct(all, input);
  for (const fs::path& path : checkpoints) {
    check_output(path, plan.replaceable.contains(path) ? IfExists::replace : plan.files.if_exists);
  }
  if (plan.files.record) {
    check_record(*plan.files.record, plan.start.parameters, if_record_exists(plan.options));
  }
}

}  // namespace

void add_run_options(po::options_description& options) {
  auto add = options.add_options();
  add("checkpoint-at", list_of_seconds(), "write checkpoints at these times, named OUT-tT.h5");
  add("checkpoint-every", seconds(), "write a checkpoint every T");
  add("record", output_file("record"), "record time series of the interface in FILE");
  add("record-every", seconds()->default_value(1e-4, "1e-4"),
      "sampling interval of the record; the times of ruptures are exact to one time step");
  add("crossings", text("F,..."),
      "pinned fractions besides 0.3 whose crossing by a block is recorded, such as 0.2,0.5");
  add("fields", seconds(),
      "sampling interval of the displacement of all blocks, for pictures and movies; part of the "
      "record, 8 bytes per block and sample; default: none");
  add("threads", integer("N"),
      "number of threads; default: as many as speed up a slider of this size. Results do not "
      "depend on it");
  add("on-alarm", one_of("stop|report")->default_value("stop"),
      "what to do when the result becomes meaningless (docs/guard.md): stop with exit code 1, or "
      "report it and continue. Warnings are only reported, and not at all with --quiet");
  add("resume",
      "if the same run was interrupted, continue from its newest checkpoint OUT-tT.h5 and append "
      "to its record; the result is that of an uninterrupted run");
  add("dry-run",
      "write nothing: check the command and estimate the time, memory and disk space that it "
      "needs. The time per step is measured for half a second, from the checkpoint or, for load, "
      "near the equilibrium, which is not computed");
  add_output_options(options, "checkpoint");
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
  if (values["on-alarm"].as<std::string>() == "report") run.on_alarm = OnAlarm::report;
  run.resume = values.count("resume") > 0 ? Resume::yes : Resume::no;
  run.dry_run = dry_run(values);
  if (values.count("threads") > 0) run.threads = int_between(values, "threads", 1, 1024);
  run.output = output_options(values);
  return run;
}

RunPlan plan_run(Checkpoint start, const StopRule& rule, RunOptions options,
                 const fs::path& input) {
  const Parameters& p = start.parameters;
  start.run = run_from(p, start.state.step);
  start.run->id = id_of_run(start);
  const Clock& clock = start.state.clock;
  RunPlan plan;
  plan.rule = rule;
  plan.files = {options.output.output,    options.record,    {},
                options.output.if_exists, options.crossings, {}};
  if (options.record)
    plan.files.record_every = interval(p, clock, options.record_every, "record-every");
  if (options.fields) plan.files.fields_every = interval(p, clock, *options.fields, "fields");
  plan.checkpoint_steps = checkpoint_steps(p, start.state, rule.last_step, options);
  plan.options = std::move(options);
  plan.start = std::move(start);
  Found found =
      plan.options.resume == Resume::yes ? find_run(plan.start, plan.rule, plan.files) : Found{};
  plan.replaceable = std::move(found.replaceable);
  plan.is_complete = found.is_complete;
  plan.begin = beginning(plan, std::move(found.newest));
  plan.begin.checkpoint.run->quiet_steps = rule.quiet_steps;
  plan.begin.checkpoint.run->arrived_below = rule.arrived_below;
  if (plan.is_resumed()) leave_out_what_was_written(plan);
  if (!plan.is_complete) {
    check_files(plan, input);
  } else if (plan.files.record) {
    plan.written_before.push_back(*plan.files.record);
  }
  plan.finds_equilibrium = input.empty();
  plan.threads = plan.options.threads.value_or(default_thread_count(plan.start.parameters));
  return plan;
}

IfExists if_checkpoint_exists(const RunPlan& plan, const fs::path& path) {
  const bool may_replace = path == plan.files.output
                               ? plan.replaceable.contains(path)
                               : plan.options.resume == Resume::yes && may_write(path, plan.start);
  return may_replace ? IfExists::replace : plan.files.if_exists;
}

IfExists if_record_exists(const RunOptions& options) {
  return options.resume == Resume::yes ? IfExists::replace : options.output.if_exists;
}

}  // namespace rupture::tools
