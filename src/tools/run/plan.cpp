#include "run/plan.hpp"

#include <algorithm>

#include "rupture/checkpoint/record.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

/// Where the run goes on, if it was interrupted; else its start.
Resumption beginning(const RunPlan& plan, std::optional<Resumption> found) {
  const auto& chain = plan.start.provenance;
  if (!found) return {plan.start, {}, {}, chain};
  ProvenanceEntry entry = chain.back();
  entry.parent_checksum = found->checkpoint.checksum;
  entry.rebuild = "restart";
  found->checkpoint.provenance.push_back(std::move(entry));
  found->record_provenance = chain;
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

/// Everything that a run with these checkpoints on the way writes.
std::vector<fs::path> all_paths(std::vector<fs::path> on_the_way, const RunFiles& files) {
  on_the_way.push_back(files.output);
  if (files.record) on_the_way.push_back(*files.record);
  return on_the_way;
}

/// Of a run that goes on, takes the checkpoints that were written before from those to come.
void leave_out_what_was_written(RunPlan& plan) {
  auto& steps = plan.checkpoint_steps;
  const auto later = std::upper_bound(steps.begin(), steps.end(), plan.begin.checkpoint.state.step);
  plan.written_before = paths_at({steps.begin(), later}, plan);
  plan.written_before.push_back(plan.begin.file);
  steps.erase(steps.begin(), later);
}

void check_outputs(const RunPlan& plan, const RunOptions& options, const OutputOptions& output,
                   const fs::path& input) {
  auto checkpoints = paths_at(plan.checkpoint_steps, plan);
  check_distinct(all_paths(checkpoints, plan.files), input);
  checkpoints.push_back(plan.files.output);
  for (const fs::path& path : checkpoints) {
    check_output(path, plan.replaceable.contains(path) ? IfExists::replace : output.if_exists);
  }
  if (plan.files.record) {
    check_record(*plan.files.record, plan.start.parameters, if_record_exists(options, output));
  }
}

/// Nothing of it is to be done yet.
Workload nothing_of(const RunPlan& plan, const RunOptions& options, const fs::path& input) {
  const Parameters& p = plan.start.parameters;
  return {.parameters = p,
          .from = input.empty() ? RunsFrom::equilibrium : RunsFrom::checkpoint,
          .first_step = plan.rule.last_step,
          .last_step = plan.rule.last_step,
          .threads = options.threads.value_or(default_thread_count(p))};
}

/// The part that is left to be done.
Workload rest_of(const RunPlan& plan, Workload work) {
  work.first_step = plan.begin.checkpoint.state.step;
  work.end = plan.rule.quiet_steps ? End::at_the_latest : End::known;
  work.checkpoints = static_cast<std::int64_t>(plan.checkpoint_steps.size()) + 1;
  if (plan.files.record) {
    const auto count = [&](const Interval& every) {
      return sample_count(plan.start.run->first_step, plan.rule.last_step, every);
    };
    work.samples = count(plan.files.record_every);
    if (plan.files.fields_every) work.field_samples = count(*plan.files.fields_every);
  }
  return work;
}

}  // namespace

RunPlan plan_run(Checkpoint start, const StopRule& rule, const RunOptions& options,
                 const OutputOptions& output, const fs::path& input) {
  const Parameters& p = start.parameters;
  start.run = run_from(p, start.state.step);
  start.run->id = id_of_run(start);
  const Interval every =
      options.record ? sampling_interval(p, start.state.clock, options) : Interval{};
  RunPlan plan = {.start = {},
                  .begin = {},
                  .rule = rule,
                  .files = {output.output, options.record, every, output.if_exists,
                            options.crossings, fields_interval(p, start.state.clock, options)},
                  .checkpoint_steps = checkpoint_steps(p, start.state, rule.last_step, options),
                  .written_before = {},
                  .replaceable = {},
                  .work = {}};
  plan.start = std::move(start);
  plan.work = nothing_of(plan, options, input);
  Remains remains =
      options.resume == Resume::yes ? find_remains(plan.start, plan.rule, plan.files) : Remains{};
  plan.replaceable = std::move(remains.replaceable);
  plan.is_complete = remains.is_complete;
  plan.begin = beginning(plan, std::move(remains.newest));
  if (plan.is_resumed()) leave_out_what_was_written(plan);
  if (plan.is_complete) {
    if (plan.files.record) plan.written_before.push_back(*plan.files.record);
    return plan;
  }
  check_outputs(plan, options, output, input);
  plan.work = rest_of(plan, plan.work);
  return plan;
}

IfExists if_checkpoint_exists(const RunPlan& plan, const RunOptions& options,
                              const fs::path& path) {
  const bool may_replace = path == plan.files.output
                               ? plan.replaceable.contains(path)
                               : options.resume == Resume::yes && may_write(path, plan.start);
  return may_replace ? IfExists::replace : plan.files.if_exists;
}

IfExists if_record_exists(const RunOptions& options, const OutputOptions& output) {
  return options.resume == Resume::yes ? IfExists::replace : output.if_exists;
}

}  // namespace rupture::tools
