#include "run/simulate.hpp"

#include <fmt/core.h>

#include <utility>

#include "cli/interruption.hpp"
#include "cli/text.hpp"
#include "run/plan.hpp"
#include "run/speed.hpp"
#include "run/written_run.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

/// Writes the .sum of each of these files that lacks it, if they are asked for: the part of the run
/// that wrote them was killed, or not asked for them. One that is there is that of its file.
void restore_sums(const std::vector<fs::path>& paths, const OutputOptions& output) {
  if (output.sum == SumFile::omit) return;
  for (const fs::path& path : paths) {
    if (fs::exists(path) && !fs::exists(sum_path(path))) restore_sum(path);
  }
}

/// The command that goes on with the run.
std::string resuming_command(const RunOptions& options) {
  auto arguments = options.arguments;
  if (options.resume == Resume::no) arguments.insert(arguments.begin() + 1, "--resume");
  return shell_line(arguments);
}

void say_where_it_begins(std::FILE* to, const RunPlan& plan) {
  if (plan.is_complete) {
    say_on(to, "{} is complete\n", in_one_line(plan.files.output.string()));
  } else if (plan.is_resumed()) {
    say_on(to, "resuming from {}\n", in_one_line(plan.begin.file.string()));
  } else {
    say_on(to, "nothing to resume from: the run begins anew\n");
  }
}

/// Prints what the run needs.
void print_forecast(const RunPlan& plan, DryRun how) {
  const Forecast needs = forecast(plan.work, measure_speed(plan.work, plan.begin.checkpoint.state));
  say("{}", how == DryRun::json ? json_text(needs) + "\n" : text_of(needs));
}

/// Runs and writes what the plan says.
void carry_out(const RunPlan& plan, const RunOptions& options, const OutputOptions& output) {
  const InterruptionNoted interruption;
  StopRule rule = plan.rule;
  rule.interrupted = [] { return InterruptionNoted::signal() != 0; };
  const auto if_exists = [&](const fs::path& path) {
    return if_checkpoint_exists(plan, options, path);
  };
  Run run(plan.begin, rule, plan.files, if_exists, if_record_exists(options, output),
          plan.work.threads, output);
  if (run.go(rule, plan.checkpoint_steps, options.on_alarm) == Ending::interrupted) {
    const std::string where = run.has_moved()
                                  ? fmt::format(", and saved as {}", run.save_on_the_way().string())
                                  : " at its first step";
    print_if_asked(quantities_of(run.summary()), output);
    throw Interrupted{InterruptionNoted::signal(),
                      fmt::format("interrupted{}; to go on: {}", where, resuming_command(options))};
  }
  run.finish();
  print_if_asked(quantities_of(run.summary()), output);
  if (const int signal = InterruptionNoted::signal()) {
    throw Interrupted{signal, "interrupted when everything was done and written"};
  }
}

}  // namespace

void simulate(Checkpoint start, const StopRule& rule, const RunOptions& options,
              const OutputOptions& output, const fs::path& input) {
  const RunPlan plan = plan_run(std::move(start), rule, options, output, input);
  const bool is_dry = options.dry_run != DryRun::no;
  if (options.resume == Resume::yes && output.verbosity == Verbosity::normal &&
      options.dry_run != DryRun::json && !(is_dry && plan.is_complete)) {
    say_where_it_begins(output.text(), plan);
  }
  if (is_dry) return print_forecast(plan, options.dry_run);
  restore_sums(plan.written_before, output);
  if (!plan.is_complete) return carry_out(plan, options, output);
  print_if_asked(quantities_of(summary_of_complete(read_checkpoint(plan.files.output))), output);
}

}  // namespace rupture::tools
