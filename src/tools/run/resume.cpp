// Finding out where an interrupted run can be taken up.
#include <algorithm>
#include <cstdlib>
#include <set>

#include "run/observers.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

/// True if `checkpoint` lies on the run that begins with `start`.
bool is_of_run(const Checkpoint& checkpoint, const Checkpoint& start) {
  return checkpoint.run && checkpoint.run->id == start.run->id;
}

/// True if a run with this rule would have ended before the checkpoint. When an event spanned is
/// not known, nor, in files of earlier builds, whether one has; then it is true.
bool is_beyond_end(const Checkpoint& checkpoint, const StopRule& rule) {
  const std::int64_t step = checkpoint.state.step;
  const RunSoFar& run = *checkpoint.run;
  const EarlyEnd& early = rule.early;
  if (step > rule.last_step) return true;
  if (!early.may_come()) return false;
  if (run.event.first.empty() || (early.spanned && run.spanned)) return true;
  const bool may_rest = checkpoint.parameters.V == 0.0;
  const bool may_have_ended = early.rupture_of || !early.condition.empty() || may_rest;
  if (may_have_ended && run.early != early) return true;
  if (!early.quiet_steps) return false;
  const std::int64_t quiet_from = run.last_break + *early.quiet_steps;
  return step > (quiet_from + kQuietCheck - 1) / kQuietCheck * kQuietCheck;
}

/// OUT.h5, if it is there, and files OUT-t*.h5, those of the latest times first.
std::vector<fs::path> checkpoints_of(const fs::path& output) {
  const std::string prefix = output.stem().string() + "-t";
  std::vector<std::pair<double, fs::path>> found;
  const fs::path folder = output.has_parent_path() ? output.parent_path() : fs::path(".");
  std::error_code error;
  const fs::directory_iterator entries(folder, error);
  if (error) {
    throw MachineFailure("cannot look for checkpoints of {} in {}: {}", output.string(),
                         folder.string(), error.message());
  }
  for (const auto& entry : entries) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix)) continue;
    const double t = std::strtod(name.c_str() + prefix.size(), nullptr);
    const fs::path path = path_at(output, t);
    if (std::isfinite(t) && path.filename() == name) found.emplace_back(t, path);
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<fs::path> paths;
  std::error_code loop;
  if (fs::exists(output, loop)) paths.push_back(output);
  for (auto& [t, path] : found) paths.push_back(std::move(path));
  return paths;
}

/// Reads a checkpoint of an interrupted run; one that is damaged counts as none.
std::optional<Checkpoint> read_if_intact(const fs::path& path) try {
  return read_checkpoint(path);
} catch (const Failure& damage) {
  say_on(stderr, "not used to resume: {}\n", in_one_line(damage.what()));
  return std::nullopt;
}

/// True if this is a checkpoint, even a damaged one.
bool is_checkpoint(const fs::path& path) try {
  return identify(path) == FileKind::checkpoint;
} catch (const Failure&) {
  return false;
}

/// True if the run that begins with `start` may write this checkpoint when it is resumed: there is
/// nothing, or a checkpoint of this run, or a damaged one.
bool may_write(const fs::path& path, const Checkpoint& start) try {
  return !is_there(path) || is_of_run(read_checkpoint(path), start);
} catch (const Failure&) {
  return is_checkpoint(path);
}

/// The part of the run in `path`, a record or its .part; empty if there is no such file. Throws
/// Failure if it holds anything else, unless that will be replaced.
Content recorded(const fs::path& path, const RunPlan& plan) try {
  if (!is_there(path)) return {};
  if (std::error_code loop; !fs::exists(path, loop)) fail_existing(path);
  RecordFile file = read_record_file(path);
  const Record& record = file.record;
  if (record.run == plan.recorded_run && record.crossing_levels == plan.options.crossings &&
      (record.step.empty() || record.step.back() <= plan.rule.last_step)) {
    return std::move(file.content);
  }
  throw Failure(
      "{} comes from a different run or was recorded with other options; give another --record, or "
      "--force to replace it",
      path.string());
} catch (const Failure&) {
  if (plan.options.output.if_exists == IfExists::refuse) throw;
  return {};
}

/// The ruptures in rows of the record up to the checkpoint.
std::vector<Rupture> ruptures_in(const Content& rows, const Checkpoint& checkpoint) {
  std::vector<Rupture> ruptures;
  const auto blocks = sampled_steps(rows, "/ruptures/block");
  for (const std::int64_t step : sampled_steps(rows, "/ruptures/step")) {
    const double t = time_at(checkpoint.parameters, checkpoint.state.clock, step);
    ruptures.push_back({step, t, blocks.at(ruptures.size())});
  }
  return ruptures;
}

/// The steps in events at which the run has taken samples when it writes the checkpoint.
std::set<std::int64_t> steps_in_events(const std::vector<Rupture>& ruptures,
                                       const Checkpoint& checkpoint, const RunPlan& plan) {
  if (!plan.in_events) return {};
  const Parameters& p = checkpoint.parameters;
  const Clock& clock = checkpoint.state.clock;
  const double quiet = quiet_time(p, plan.rule.early);
  const std::int64_t step = checkpoint.state.step;
  std::int64_t seen = checkpoint.run->first_step;
  std::set<std::int64_t> steps;
  const auto add = [&](const LatestEvent& event) {
    for (auto at = plan.in_events->after(seen);
         at <= step && event.is_under_way(time_at(p, clock, at), quiet);
         at = plan.in_events->after(at)) {
      steps.insert(seen = at);
    }
  };
  add(plan.start.run->event);
  for (const Rupture& rupture : ruptures) {
    seen = std::max(seen, rupture.step - 1);
    add({{rupture.time}, rupture.time});
  }
  return steps;
}

/// The steps at an interval at which the run has taken samples then, the last one if it has ended.
std::set<std::int64_t> steps_at(const Interval& every, const Checkpoint& checkpoint, bool at_end) {
  const std::int64_t step = checkpoint.state.step, first = checkpoint.run->first_step;
  std::set<std::int64_t> steps = {first};
  for (auto at = every.after(first); at <= step; at = every.after(at)) steps.insert(at);
  if (at_end) steps.insert(step);
  return steps;
}

/// True if these rows have all samples of events that span, and, held, of one that may yet.
bool have_spanning_events(const Content& rows, const Checkpoint& checkpoint, bool at_end,
                          const RunPlan& plan) {
  const Parameters& p = checkpoint.parameters;
  const auto ruptures = ruptures_in(rows, checkpoint);
  RunSoFar run = *plan.start.run;
  run.early = plan.rule.early;
  const double quiet = quiet_time(p, run.early), now = time(p, checkpoint.state);
  const bool may_span = !at_end && checkpoint.run->event.is_under_way(now, quiet);
  const auto events = which_span(p, std::move(run), ruptures);
  std::set<std::int64_t> have, wanted = steps_at(plan.record_every, checkpoint, at_end);
  for (const std::int64_t step : sampled_steps(rows, kSeriesSteps)) {
    if (!wanted.contains(step) && !is_in_spanning_event(events, step)) return false;
    have.insert(step);
  }
  for (const std::int64_t step : sampled_steps(rows, kHeldSteps)) have.insert(step);
  for (const std::int64_t step : steps_in_events(ruptures, checkpoint, plan)) {
    const bool is_of_last = may_span && step >= events.rbegin()->first;
    if (is_of_last || is_in_spanning_event(events, step)) wanted.insert(step);
  }
  return std::ranges::includes(have, wanted);
}

/// True if these rows are all that the record held when the run wrote the checkpoint, which is at
/// its end or on its way.
bool reach(const Content& rows, const Checkpoint& checkpoint, const fs::path& path,
           const RunPlan& plan) {
  const std::int64_t step = checkpoint.state.step;
  const bool at_end = path == plan.options.output.output || step == plan.rule.last_step;
  const bool only_spanning = plan.is_dense_only_if_spanning();
  const auto have_samples = [&](const char* path_of_steps, const Interval& every) {
    std::set<std::int64_t> steps = steps_at(every, checkpoint, at_end);
    if (!only_spanning)
      steps.merge(steps_in_events(ruptures_in(rows, checkpoint), checkpoint, plan));
    return std::ranges::equal(sampled_steps(rows, path_of_steps), steps);
  };
  return (only_spanning ? have_spanning_events(rows, checkpoint, at_end, plan)
                        : have_samples(kSeriesSteps, plan.record_every)) &&
         (!plan.fields_every || have_samples(kFieldsSteps, *plan.fields_every)) &&
         rows.at("/ruptures/step").shape[0] == static_cast<std::uint64_t>(checkpoint.run->ruptures);
}

/// True if the run looks at its condition here, and it holds.
bool condition_holds(const Checkpoint& checkpoint, const RunPlan& plan) {
  const std::int64_t step = checkpoint.state.step;
  if (!plan.looks || plan.looks->last_until(step) != step) return false;
  const Parameters& p = checkpoint.parameters;
  return !Condition(plan.rule.early.condition, p).what_holds({p, checkpoint.state}).empty();
}

/// True if the run that begins with `start` ends at this checkpoint of it. Of a run that may end
/// early that is only known if it was to end by the same rule.
bool is_end(const Checkpoint& checkpoint, const RunPlan& plan) {
  const StopRule& rule = plan.rule;
  const RunSoFar& run = *checkpoint.run;
  return checkpoint.state.step <= rule.last_step &&
         (ending_at(checkpoint.state, run, rule).has_value() ||
          condition_holds(checkpoint, plan)) &&
         (!rule.early.may_come() || run.early == rule.early);
}

/// True if the run goes through this checkpoint, which it wrote at its end or on its way.
bool is_on_the_way(const Checkpoint& checkpoint, const fs::path& path, const RunPlan& plan) {
  if (!is_of_run(checkpoint, plan.start) || !checkpoint.alarm.empty()) return false;
  if (path == plan.options.output.output) return is_end(checkpoint, plan);
  return !is_beyond_end(checkpoint, plan.rule);
}

}  // namespace

void find_run(RunPlan& plan) {
  const fs::path& output = plan.options.output.output;
  const std::optional<fs::path>& record = plan.options.record;
  Content recorded_so_far;
  bool has_part = false;
  if (record) {  // it and its .part must be of the run
    Content finished = recorded(*record, plan), part = recorded(part_path(*record), plan);
    has_part = is_there(part_path(*record));
    recorded_so_far = std::move(part.empty() ? finished : part);
  }
  bool too_new = false;
  for (const fs::path& path : checkpoints_of(output)) {
    auto checkpoint = read_if_intact(path);
    if (!checkpoint || !is_on_the_way(*checkpoint, path, plan)) continue;
    if (path == output) plan.rewrites_output = true;
    Content rows;
    if (!recorded_so_far.empty()) rows = rows_until(recorded_so_far, checkpoint->state.step);
    if (!record || reach(rows, *checkpoint, path, plan)) {
      ProvenanceEntry entry = plan.start.provenance.back();  // of what the run writes from here on
      entry.parent_checksum = checkpoint->checksum;
      entry.rebuild = "restart";
      checkpoint->provenance.push_back(entry);
      plan.begin = std::move(*checkpoint);
      plan.resumed_from = path;
      plan.recorded = std::move(rows);
      plan.is_complete = path == output && !has_part;
      return;
    }
    if (!std::exchange(too_new, true)) {
      say_on(stderr, "not used to resume: {}, because the record ends before it\n",
             in_one_line(path.string()));
    }
  }
}

IfExists if_checkpoint_exists(const RunPlan& plan, const fs::path& path) {
  const bool may_replace = path == plan.options.output.output
                               ? plan.rewrites_output
                               : plan.options.resume && may_write(path, plan.start);
  const IfExists given = plan.options.output.if_exists;
  const bool may_resume =
      path != plan.options.output.output && given == IfExists::refuse && !plan.options.resume;
  std::error_code ignored;
  if (may_resume && fs::exists(path, ignored) && may_write(path, plan.start)) {
    fail_existing(path, kResume);
  }
  return may_replace ? IfExists::replace : given;
}

}  // namespace rupture::tools
