#include "run/simulate.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "cli/interruption.hpp"
#include "cli/text.hpp"
#include "run/resume.hpp"
#include "run/speed.hpp"
#include "run/written_run.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

/// What a run begins with: `start`, or where it was interrupted.
Resumption beginning(Checkpoint start, const StopRule& rule, const RunFiles& files, bool resume) {
  auto chain = start.provenance;
  auto found = resume ? find_resumption(start, rule, files) : std::nullopt;
  if (!found) return {std::move(start), {}, {}, std::move(chain)};
  ProvenanceEntry entry = chain.back();
  entry.parent_checksum = found->checkpoint.checksum;
  entry.rebuild = "restart";
  found->checkpoint.provenance.push_back(std::move(entry));
  found->checkpoint.run_id = start.run_id;
  found->record_provenance = std::move(chain);
  return std::move(*found);
}

/// The checkpoints on the way at these steps.
std::vector<fs::path> paths_at(const std::vector<std::int64_t>& steps, const RunFiles& files,
                               const Parameters& p) {
  std::vector<fs::path> paths;
  paths.reserve(steps.size());
  for (const std::int64_t step : steps) {
    paths.push_back(path_at(files.output, static_cast<double>(step) * p.dt));
  }
  return paths;
}

/// Writes the .sum of each of these files that lacks it, if they are asked for: the part of the run
/// that wrote them was killed, or not asked for them. One that is there is that of its file.
void restore_sums(const std::vector<fs::path>& paths, const OutputOptions& output) {
  if (output.sum == SumFile::omit) return;
  for (const fs::path& path : paths) {
    if (fs::exists(path) && !fs::exists(sum_path(path))) restore_sum(path);
  }
}

/// Everything that a run with these checkpoints on the way writes.
std::vector<fs::path> all_paths(std::vector<fs::path> on_the_way, const RunFiles& files) {
  on_the_way.push_back(files.output);
  if (files.record) on_the_way.push_back(*files.record);
  return on_the_way;
}

void check_run_outputs(const std::vector<fs::path>& on_the_way, const RunFiles& files,
                       const Parameters& p, IfExists if_output_exists,
                       const IfCheckpointExists& if_exists, IfExists if_record_exists,
                       const fs::path& input) {
  check_distinct(all_paths(on_the_way, files), input);
  check_output(files.output, if_output_exists);
  for (const fs::path& path : on_the_way) check_output(path, if_exists(path));
  if (files.record) check_record(*files.record, p, if_record_exists);
}

/// The command that goes on with the run.
std::string resuming_command(const RunOptions& options) {
  auto arguments = options.arguments;
  if (!options.resume) arguments.insert(arguments.begin() + 1, "--resume");
  return shell_line(arguments);
}

void say_where_it_begins(const Resumption& begin) {
  if (begin.file.empty()) {
    say("nothing to resume from: the run begins anew\n");
  } else {
    say("resuming from {}\n", begin.file.string());
  }
}

/// Prints what a run needs that does this and takes its steps from `state`.
void print_forecast(const Workload& work, const State& state, DryRun how) {
  const Forecast needs = forecast(work, measure_speed(work, state));
  say("{}", how == DryRun::json ? json_text(json_of(needs)) + "\n" : text_of(needs));
}

}  // namespace

void simulate(Checkpoint start, StopRule rule, const RunOptions& options,
              const OutputOptions& output, const fs::path& input) {
  const Parameters p = start.parameters;
  const bool talk = output.verbosity == Verbosity::normal;
  const RunFiles files = {output.output, options.record,
                          options.record ? sampling_steps(p, options) : 1, output.if_exists};
  auto steps = checkpoint_steps(p, start.state.step, rule.last_step, options);
  start.run = {.first_step = start.state.step, .last_break = start.state.step};
  start.run_id = id_of_run(start);
  const bool dry = options.dry_run != DryRun::no;
  // Nothing is left to do unless it is found below that there is.
  Workload work = {.parameters = p,
                   .start = input.empty() ? Start::equilibrium : Start::checkpoint,
                   .first_step = rule.last_step,
                   .last_step = rule.last_step,
                   .threads = options.threads.value_or(threads_that_pay(p))};
  if (options.resume && is_complete(start, rule, files)) {
    if (dry) return print_forecast(work, start.state, options.dry_run);
    restore_sums(all_paths(paths_at(steps, files, p), files), output);
    if (talk) say("{} is complete\n", output.output.string());
    return;
  }
  const auto if_exists = [&](const fs::path& path) {
    return options.resume && may_write(path, start) ? IfExists::replace : output.if_exists;
  };
  const Resumption begin = beginning(start, rule, files, options.resume);
  if (options.resume && talk && options.dry_run != DryRun::json) say_where_it_begins(begin);
  std::vector<fs::path> written_before;
  if (!begin.file.empty()) {
    const auto later = std::upper_bound(steps.begin(), steps.end(), begin.checkpoint.state.step);
    written_before = paths_at({steps.begin(), later}, files, p);
    written_before.push_back(begin.file);
    steps.erase(steps.begin(), later);
  }
  const IfExists if_record_exists = options.resume ? IfExists::replace : output.if_exists;
  check_run_outputs(paths_at(steps, files, p), files, p, output.if_exists, if_exists,
                    if_record_exists, input);

  if (dry) {
    work.first_step = begin.checkpoint.state.step;
    work.end = rule.quiet_steps ? End::at_the_latest : End::known;
    work.checkpoints = static_cast<std::int64_t>(steps.size()) + 1;
    if (files.record) {
      work.samples = sample_count(start.run->first_step, rule.last_step, files.record_every);
    }
    return print_forecast(work, begin.checkpoint.state, options.dry_run);
  }
  restore_sums(written_before, output);

  const InterruptionNoted noted;
  rule.interrupted = [] { return InterruptionNoted::signal() != 0; };
  Run run(begin, rule.last_step, files, if_exists, if_record_exists, work.threads, output);
  if (run.go(rule, steps, options.on_alarm) == Ending::interrupted) {
    const std::string where = run.has_moved()
                                  ? fmt::format(", and saved as {}", run.save_on_the_way().string())
                                  : " at its first step";
    throw Interrupted{InterruptionNoted::signal(),
                      fmt::format("interrupted{}; to go on: {}", where, resuming_command(options))};
  }
  run.finish();
  if (const int signal = InterruptionNoted::signal()) {
    throw Interrupted{signal, "interrupted when everything was done and written"};
  }
}

}  // namespace rupture::tools
