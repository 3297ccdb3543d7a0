#include "run/plan.hpp"

#include <set>

#include "run/rebuild.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/dynamics/condition.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/user_text.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

double arrived_below(const po::variables_map& values) {
  if (values.count("until-quiet") + values.count("until-spanned") == 0) {
    throw UsageError("--arrived-below needs --until-quiet or --until-spanned: give one of them");
  }
  const double limit = fraction(values, "arrived-below");
  if (limit <= kRupturedFraction) return limit;
  throw UsageError("--arrived-below must be at most {}, at which a block ruptures (got {})",
                   kRupturedFraction, limit);
}

bool has_condition(const po::variables_map& values) {
  return values.count("until") > 0 && is_condition(values["until"].as<std::string>());
}

void refuse_without_record(const po::variables_map& values) {
  if (values.count("record") > 0) return;
  for (const char* option : {"record-every", "record-every-in-events",
                             "record-every-in-spanning-events", "crossings", "fields"}) {
    if (values.count(option) == 0 || values[option].defaulted()) continue;
    throw UsageError("--{} needs --record: give both", option);
  }
}

/// The levels of --crossings, ascending, so that equal records come from equal commands.
std::vector<double> crossing_levels(const po::variables_map& values) {
  if (values.count("crossings") == 0) return {};
  const auto given = fractions(values, "crossings");
  const std::set<double> levels(given.begin(), given.end());
  if (levels.contains(kRupturedFraction)) {
    throw UsageError("--crossings {} is always recorded: leave it out", kRupturedFraction);
  }
  return {levels.begin(), levels.end()};
}

/// The checkpoints that the run is to write on its way. Throws UsageError if one is outside.
Checkpoints checkpoints_of(const RunPlan& plan) {
  const Parameters& p = plan.start.parameters;
  const Clock& clock = plan.start.state.clock;
  const std::int64_t first = plan.start.state.step, last = plan.rule.last_step;
  Checkpoints checkpoints;
  const auto add = [&](std::int64_t step) {
    checkpoints[step] = path_at(plan.options.output.output, time_at(p, clock, step));
  };
  for (const double t : plan.options.checkpoint_at) {
    const std::int64_t step = step_at(p, clock, t);
    if (step < first || step > last) {
      throw UsageError("--checkpoint-at {:g} is outside the run, {:g} s to {:g} s", t,
                       time_at(p, clock, first), time_at(p, clock, last));
    }
    add(step);
  }
  if (const auto t = plan.options.checkpoint_every) {
    const Interval every = interval(p, clock, *t, "checkpoint-every");
    constexpr std::int64_t most = 1'000'000;
    if (const auto count = every.number_at(last) - every.number_at(first); count > most) {
      throw UsageError("--checkpoint-every {:g} would write {} checkpoints: give a longer time", *t,
                       count);
    }
    for (auto step = every.after(first); step <= last; step = every.after(step)) add(step);
  }
  return checkpoints;
}

void check_files(const RunPlan& plan, const fs::path& input) {
  std::vector<fs::path> files;
  for (const auto& [step, path] : plan.checkpoints) files.push_back(path);
  files.push_back(plan.options.output.output);
  const std::vector<fs::path> checkpoints = files;
  const auto& record = plan.options.record;
  if (record) files.push_back(*record);
  files.push_back(alarm_path(plan.options.output.output));
  check_distinct(files, plan.options.output, input);
  for (const fs::path& path : checkpoints) check_output(path, if_checkpoint_exists(plan, path));
  if (record) check_record(*record, plan.start.parameters, plan.options.if_record_exists());
}

/// Whether a block that has ruptured will rupture again is not known.
void refuse_ruptured(const EarlyEnd& early, const Checkpoint& start) {
  const Parameters& p = start.parameters;
  const LatestEvent& event = start.run->event;
  const double now = time(p, start.state);
  if (!early.rupture_of || !event.is_under_way(now, quiet_time(p, early))) return;
  const auto& t = event.first[static_cast<std::size_t>(*early.rupture_of)];
  if (!t) return;
  throw UsageError(
      "the block at {:.4g} m has ruptured already, at {:.7g} s, in the event that is under way at "
      "{:.7g} s: give --until-rupture-at a block that has not",
      block_position(p, *early.rupture_of), *t, now);
}

/// Such a run would end where it begins.
void refuse_condition(const EarlyEnd& early, const Checkpoint& start) {
  if (early.condition.empty()) return;
  const Simulation simulation(start.parameters, start.state);
  const std::string held = Condition(early.condition, start.parameters).what_holds(simulation);
  if (held.empty()) return;
  throw UsageError("--until \"{}\" is true at the start, {:.7g} s: {}; give what comes later",
                   early.condition, simulation.time(), held);
}

}  // namespace

void add_early_end_options(po::options_description& options) {
  auto add = options.add_options();
  add("until-quiet", seconds_or("5 t_R"),
      "stop as soon as no junction has broken for T or an event has spanned the interface");
  add("until-spanned", "stop as soon as an event has spanned the interface");
  add("until-rupture-at", number("X", "m"),
      "stop at the step at which the block nearest to X ruptures");
  add("until-every", seconds(),
      "how often to look whether the condition of --until holds; default: as --record-every");
  add("quiet-time", in_rebuild(seconds()),
      "time without ruptures that separates events; default 5 t_R");
  add("arrived-below", number("F"),
      "with --until-quiet or --until-spanned: once an event has spanned the interface, wait until "
      "less than this fraction of the junctions at the leading edge is pinned; default: 0.3, at "
      "which a block ruptures");
}

std::optional<double> until_time(const po::variables_map& values) {
  if (values.count("until") == 0 || values["until"].defaulted()) return std::nullopt;
  const auto time = number_in(values["until"].as<std::string>(), "s");
  return time ? std::optional(non_negative(*time, "until")) : std::nullopt;
}

bool may_end_early(const po::variables_map& values) {
  return values.count("until-quiet") + values.count("until-spanned") +
             values.count("until-rupture-at") + (has_condition(values) ? 1 : 0) >
         0;
}

EarlyEnd early_end(const po::variables_map& values, const Parameters& p) {
  EarlyEnd end;
  end.spanned = values.count("until-spanned") > 0;
  end.quiet_time = optional_non_negative(values, "quiet-time");
  if (values.count("until-quiet") > 0) {
    const auto quiet = values["until-quiet"].as<boost::optional<double>>();
    end.quiet_steps = steps_in(p, quiet ? non_negative(*quiet, "until-quiet") : quiet_time(p, end));
    end.spanned = true;
  }
  if (values.count("arrived-below") > 0) end.arrived_below = arrived_below(values);
  if (const auto x = optional_non_negative(values, "until-rupture-at")) {
    end.rupture_of = block_at(p, *x, "until-rupture-at");
  }
  const auto every = optional_non_negative(values, "until-every");
  if (has_condition(values)) {
    end.condition = values["until"].as<std::string>();
    end.condition_every = every.value_or(non_negative(values, "record-every"));
    Condition(end.condition, p);  // which must be one
  } else if (every) {
    throw UsageError("--until-every needs a condition, as in --until \"F_T < 300\": give both");
  }
  return end;
}

void add_run_options(po::options_description& options) {
  auto add = options.add_options();
  add("checkpoint-at", list_of_seconds(), "write checkpoints at these times, named OUT-tT.h5");
  add("checkpoint-every", seconds(), "write a checkpoint every T");
  add("record", output_file("record"), "record time series of the interface in FILE");
  add("record-every", in_rebuild(seconds()->default_value(1e-4, "1e-4")),
      "sampling interval of the record; the times of ruptures are exact to one time step");
  add("record-every-in-events", in_rebuild(seconds()),
      "during an event, also sample at this interval, fields too. An event goes on until no block "
      "has ruptured for --quiet-time");
  add("record-every-in-spanning-events", in_rebuild(seconds()),
      "the same, but only during events that span the interface; fields keep their interval");
  add("crossings", in_rebuild(text("F,...")),
      "also record when a block falls below these pinned fractions, such as 0.2,0.5");
  add("fields", in_rebuild(seconds()),
      "sampling interval of the displacement of all blocks, for pictures and movies; part of the "
      "record, 8 bytes per block and sample; default: none");
  add("threads", integer("N"),
      "number of threads; default: as many as speed up a slider of this size. Results do not "
      "depend on it");
  add("on-alarm", in_rebuild(one_of("stop|report")->default_value("stop")),
      "what to do when the result becomes meaningless (docs/guard.md): stop with exit code 1 and "
      "write the state to OUT.alarm.h5, or report it and continue. Warnings are only reported, and "
      "not at all with --quiet");
  add("resume",
      "continue this run if it was interrupted, from its newest checkpoint OUT-tT.h5; the files "
      "are those of an uninterrupted run");
  add("dry-run",
      "write nothing: check the command, and estimate the time and disk space that it needs. The "
      "time per step is measured for half a second, as processor time: on a busy machine, the run "
      "takes longer. Samples in events are counted as if all of the run was an event");
  add_output_options(options, "checkpoint");
}

RunOptions run_options(const Parsed& parsed) {
  const auto& values = parsed.values;
  RunOptions run = {.output = output_options(values),
                    .checkpoint_every = optional_non_negative(values, "checkpoint-every"),
                    .record_every = non_negative(values, "record-every"),
                    .in_events = optional_non_negative(values, "record-every-in-events"),
                    .in_spanning = optional_non_negative(values, "record-every-in-spanning-events"),
                    .crossings = crossing_levels(values),
                    .fields = optional_non_negative(values, "fields"),
                    .reports_alarms = values["on-alarm"].as<std::string>() == "report",
                    .resume = values.count("resume") > 0,
                    .is_dry = values.count("dry-run") > 0,
                    .arguments = parsed.arguments};
  if (values.count("checkpoint-at") > 0) {
    run.checkpoint_at = values["checkpoint-at"].as<std::vector<double>>();
    for (const double t : run.checkpoint_at) {
      if (!std::isfinite(t)) non_negative(t, "checkpoint-at");
    }
  }
  if (values.count("record") > 0) run.record = file_to_write(values, "record");
  refuse_without_record(values);
  if (run.in_events && run.in_spanning) {
    throw UsageError(
        "--record-every-in-events and --record-every-in-spanning-events cannot be combined: give "
        "one of them");
  }
  if (values.count("threads") > 0) run.threads = int_between(values, "threads", 1, 1024);
  return run;
}

RunPlan plan_run(Checkpoint start, const StopRule& rule, RunOptions options,
                 const fs::path& input) {
  const Parameters& p = start.parameters;
  const Clock& clock = start.state.clock;
  start.run = run_from(p, start.state.step, start.run ? start.run->event : LatestEvent{});
  refuse_ruptured(rule.early, start);
  refuse_condition(rule.early, start);
  start.run->id = id_of_run(start);
  RunPlan plan;
  plan.rule = rule;
  if (options.record) {
    plan.record_every = interval(p, clock, options.record_every, "record-every");
  }
  if (options.in_events) {
    plan.in_events = interval(p, clock, *options.in_events, "record-every-in-events");
  }
  if (options.in_spanning) {
    plan.in_events = interval(p, clock, *options.in_spanning, "record-every-in-spanning-events");
  }
  if (!rule.early.condition.empty()) {
    plan.looks = interval(p, clock, rule.early.condition_every, "until-every");
  }
  if (options.fields) plan.fields_every = interval(p, clock, *options.fields, "fields");
  plan.recorded_run = {start.run->id, plan.record_every.time};
  if (plan.fields_every) plan.recorded_run.fields_every = plan.fields_every->time;
  if (plan.in_events) {
    RecordedRun& run = plan.recorded_run;
    (options.in_spanning ? run.every_in_spanning_events : run.every_in_events) =
        plan.in_events->time;
  }
  if (plan.in_events) plan.recorded_run.quiet_time = rule.early.quiet_time;
  plan.threads = options.threads.value_or(default_thread_count(p));
  plan.options = std::move(options);
  plan.start = std::move(start);
  plan.checkpoints = checkpoints_of(plan);
  if (plan.options.resume) find_run(plan);
  if (!plan.is_resumed()) plan.begin = plan.start;
  plan.begin.run->early = rule.early;
  if (plan.is_resumed()) {
    const auto later = plan.checkpoints.upper_bound(plan.begin.state.step);
    plan.checkpoints.erase(plan.checkpoints.begin(), later);
  }
  if (!plan.is_complete) check_files(plan, input);
  return plan;
}

std::string id_of_run(const Checkpoint& start) {
  const ProvenanceEntry& tool = start.provenance.back();
  const std::string text =
      fmt::format("rupture run 2\n{} {}\n{}\n{}\n", tool.tool, tool.parent_checksum,
                  content_checksum(parameters_content(start.parameters)), start.state.step);
  return sha256(std::as_bytes(std::span(text)));
}

std::filesystem::path alarm_path(const std::filesystem::path& output) {
  return output.parent_path() /
         fmt::format("{}.alarm{}", output.stem().string(), output.extension().string());
}

std::filesystem::path path_at(const std::filesystem::path& output, double t) {
  const auto name =
      fmt::format("{}-t{:.9f}{}", output.stem().string(), t, output.extension().string());
  return output.parent_path() / name;
}

}  // namespace rupture::tools
