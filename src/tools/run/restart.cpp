// restart: continue a checkpoint, with the same parameters or with changed ones.

#include "run/plan.hpp"

namespace rupture::tools {
namespace {

struct RunEnd {
  bool when_quiet = false;
  std::optional<double> until, duration, quiet;  // [s]
  std::optional<double> arrived_below;           // pinned fraction
};

constexpr double kLongestQuietRun = 10.0;  // [s]

void add_restart_options(po::options_description& options) {
  auto add = options.add_options();
  add("until", seconds(), "run until this time");
  add("for", seconds(), "run for this long");
  add("until-quiet", seconds_or("5 t_R"),
      "stop as soon as no junction has broken for T or an event has spanned the interface");
  add("arrived-below", number("F"),
      "with --until-quiet: after an event has spanned, wait until less than this fraction of the "
      "junctions at the leading edge is pinned; default 0.3, at which a block ruptures");
}

RunEnd run_end(const po::variables_map& values) {
  RunEnd end;
  end.until = optional_non_negative(values, "until");
  end.duration = optional_non_negative(values, "for");
  if (values.count("until-quiet") > 0) {
    end.when_quiet = true;
    const auto quiet = values["until-quiet"].as<boost::optional<double>>();
    if (quiet) end.quiet = non_negative(*quiet, "until-quiet");
  }
  if (values.count("arrived-below") > 0) {
    if (!end.when_quiet) throw UsageError("--arrived-below needs --until-quiet: give both");
    end.arrived_below = fraction(values, "arrived-below");
    if (*end.arrived_below > kRupturedFraction) {
      throw UsageError("--arrived-below must be at most {}, at which a block ruptures (got {})",
                       kRupturedFraction, *end.arrived_below);
    }
  }
  if (end.until && end.duration) {
    throw UsageError("--until and --for cannot be combined: give one of them");
  }
  if (!end.until && !end.duration && !end.when_quiet) {
    throw UsageError("no end of the run was given: give --until T, --for T or --until-quiet");
  }
  return end;
}

StopRule stop_rule(const RunEnd& end, const Checkpoint& checkpoint) {
  const Parameters& p = checkpoint.parameters;
  const std::int64_t now = checkpoint.state.step;
  StopRule rule;
  if (end.until) {
    rule.last_step = step_at(p, checkpoint.state.clock, *end.until);
    if (rule.last_step < now) {
      throw UsageError("--until {:g} is before the checkpoint's time {:.7g} s", *end.until,
                       time(p, checkpoint.state));
    }
  } else {
    if (end.duration.value_or(0.0) > 0.0) interval(p, checkpoint.state.clock, *end.duration, "for");
    rule.last_step = now + steps_in(p, end.duration.value_or(kLongestQuietRun));
  }
  if (end.when_quiet) {
    rule.quiet_steps = steps_in(p, end.quiet.value_or(pause_between_events(p)));
    rule.arrived_below = end.arrived_below;
  }
  return rule;
}

int restart(const Parsed& parsed) {
  const std::string path = single_input(parsed.values, "checkpoint", "a checkpoint to continue");
  const RunEnd end = run_end(parsed.values);
  const RunOptions options = run_options(parsed);

  Checkpoint checkpoint = read_checkpoint(path);
  const Parameters before = checkpoint.parameters;
  apply(parsed.parameters, checkpoint.parameters);
  checkpoint.state = continued(std::move(checkpoint.state), checkpoint.parameters);
  checkpoint.provenance.push_back(
      make_provenance("restart", parsed.arguments, checkpoint.checksum,
                      shell_line(rebuild_command("restart", before, checkpoint.parameters))));
  const StopRule rule = stop_rule(end, checkpoint);
  return simulate(std::move(checkpoint), rule, options, path);
}

}  // namespace

constinit const Command restart_command = {
    "restart CHECKPOINT -o OUT (--until T | --for T | --until-quiet)",
    "checkpoint",
    "continue a checkpoint, also with other parameters",
    "Continues a checkpoint. With unchanged parameters the result is bit for bit that of "
    "the\nuninterrupted run; --set changes parameters from now on, e.g. --set driving.V=0.\n"
    "At the end, prints the energy account: supplied = stored + lost to damping and junctions.",
    {add_restart_options, add_run_options},
    restart,
    run_quantities,
    UsesParameters::yes,
    {"until", "for", "until-quiet"}};

}  // namespace rupture::tools
