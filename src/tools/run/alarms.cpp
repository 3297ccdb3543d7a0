#include "run/alarms.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "cli/option_values.hpp"
#include "cli/text.hpp"
#include "run/progress.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

/// Steps between looks: one look costs a few steps.
constexpr std::int64_t kEvery = 5000;

}  // namespace

void add_alarm_option(po::options_description& options) {
  options.add_options()(
      "on-alarm", one_of("stop|report")->default_value("stop"),
      "what to do when the result becomes meaningless (docs/guard.md): stop with exit code 1, or "
      "report it and go on. Warnings are only reported, and not at all with --quiet");
}

OnAlarm on_alarm(const po::variables_map& values) {
  const auto word = values["on-alarm"].as<std::string>();
  if (word == "stop") return OnAlarm::stop;
  if (word == "report") return OnAlarm::report;
  throw UsageError(fmt::format("--on-alarm {} is unknown: choose stop or report", word));
}

Alarms::Alarms(const Simulation& simulation, std::int64_t last_step, OnAlarm on_alarm,
               const OutputOptions& output, std::string tool)
    : guard_(simulation),
      last_step_(last_step),
      on_alarm_(on_alarm),
      verbosity_(output.verbosity),
      tool_(std::move(tool)),
      next_(simulation.state().step) {}

void Alarms::observe(const Simulation& simulation) {
  const std::int64_t step = simulation.state().step;
  next_ = (step / kEvery + 1) * kEvery;
  if (step < last_step_) next_ = std::min(next_, last_step_);
  for (const Finding& finding : guard_.look(simulation)) {
    const bool alarm = finding.severity == Severity::alarm;
    if (alarm && on_alarm_ == OnAlarm::stop) {
      throw Failure(finding.sentence + "; --on-alarm report goes on nevertheless");
    }
    if (!alarm && verbosity_ == Verbosity::quiet) continue;
    clear_progress_line();
    say_on(stderr, "{}: {}: {}\n", tool_, alarm ? "alarm" : "warning", finding.sentence);
  }
}

}  // namespace rupture::tools
