// restart: continue a checkpoint, with the same parameters or with changed ones.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "cli/option_values.hpp"
#include "run/files.hpp"
#include "run/run.hpp"
#include "rupture/dynamics/simulation.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/rupture.hpp"

namespace {

using namespace rupture;
using namespace rupture::tools;

struct Options {
  std::string checkpoint;
  std::optional<double> until, duration, quiet;  // [s]; quiet < 0: five mean slipping times
  std::optional<double> arrived_below;           // pinned fraction
  ParameterChanges parameters;
  RunOptions run;
  OutputOptions output;
};

constexpr double kLongestQuietRun = 10.0;  // [s]

/// Options of which one is needed.
const std::vector<std::string> kWhenToStop = {"until", "for", "until-quiet"};

/// The time that --until-quiet gives; -1, five mean slipping times, if it gives none.
double quiet_time(const po::variables_map& values) {
  const auto given = values["until-quiet"].as<boost::optional<double>>();
  return given ? non_negative(*given, "until-quiet") : -1.0;
}

/// The pinned fraction of --arrived-below.
double arrived_below(const po::variables_map& values) {
  if (values.count("until-quiet") == 0) {
    throw UsageError("--arrived-below needs --until-quiet: give both");
  }
  const double below = fraction(values, "arrived-below");
  if (below <= kRupturedFraction) return below;
  throw UsageError(
      fmt::format("--arrived-below must be at most {}, at which a block ruptures (got {})",
                  kRupturedFraction, below));
}

Options setup(int argc, char** argv) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("until", seconds(), "run until this time");
  add("for", seconds(), "run for this long");
  add("until-quiet", seconds_or("5 t_R"),
      "stop as soon as no junction has broken for T or an event has spanned the interface");
  add("arrived-below", number("F"),
      "with --until-quiet: after an event has spanned, wait until less than this fraction of the "
      "junctions at the leading edge is pinned; default 0.3, at which a block ruptures");
  add_run_options(options);
  add_output_options(options, "checkpoint");
  const Parsed parsed = parse(
      argc, argv,
      {"restart", "restart CHECKPOINT -o OUT (--until T | --for T | --until-quiet) [options]",
       "Continues a checkpoint. With unchanged parameters the result is bit for bit that of "
       "the\nuninterrupted run; --set changes parameters from now on, e.g. --set driving.V=0.\n"
       "It ends with the energy account: supplied = stored + lost to damping and junctions.",
       kWhenToStop, "continue a checkpoint, also with other parameters"},
      options, "checkpoint", UsesParameters::yes);
  const auto& values = parsed.values;
  Options result;
  result.checkpoint = single_input(values, "checkpoint", "a checkpoint to continue");
  result.until = optional_non_negative(values, "until");
  result.duration = optional_non_negative(values, "for");
  if (values.count("until-quiet") > 0) result.quiet = quiet_time(values);
  if (values.count("arrived-below") > 0) result.arrived_below = arrived_below(values);
  if (result.until && result.duration) {
    throw UsageError("--until and --for cannot be combined: give one of them");
  }
  if (std::none_of(kWhenToStop.begin(), kWhenToStop.end(),
                   [&](const auto& option) { return values.count(option) > 0; })) {
    throw UsageError("no end of the run was given: give --until T, --for T or --until-quiet");
  }
  result.parameters = parsed.parameters;
  result.run = run_options(parsed);
  result.output = output_options(values);
  return result;
}

StopRule stop_rule(const Options& options, const Checkpoint& checkpoint) {
  const Parameters& p = checkpoint.parameters;
  const std::int64_t now = checkpoint.state.step;
  StopRule rule;
  if (options.until) {
    rule.last_step = step_at(p, checkpoint.state.clock, *options.until);
    if (rule.last_step < now) {
      throw UsageError(fmt::format("--until {:g} is before the checkpoint's time {:.7g} s",
                                   *options.until, time(p, checkpoint.state)));
    }
  } else {
    rule.last_step = now + steps_in(p, options.duration.value_or(kLongestQuietRun));
  }
  if (options.quiet) {
    rule.quiet_steps = steps_in(p, *options.quiet < 0.0 ? 5.0 * p.t_R : *options.quiet);
    rule.arrived_below = options.arrived_below;
  }
  return rule;
}

int run(const Options& options) {
  Checkpoint checkpoint = read_checkpoint(options.checkpoint);
  const Parameters before = checkpoint.parameters;
  apply(options.parameters, checkpoint.parameters);
  checkpoint.state = continued(std::move(checkpoint.state), checkpoint.parameters);
  checkpoint.provenance.push_back(
      make_provenance("restart", options.run.arguments, checkpoint.checksum,
                      shell_line(rebuild_command("restart", before, checkpoint.parameters))));
  const StopRule rule = stop_rule(options, checkpoint);
  simulate(std::move(checkpoint), rule, options.run, options.output, options.checkpoint);
  return kDone;
}

}  // namespace

int main(int argc, char** argv) {
  return run_tool("restart", [&] { return run(setup(argc, argv)); });
}
