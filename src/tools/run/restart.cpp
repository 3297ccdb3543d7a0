// restart: continue a checkpoint, with the same parameters or with changed ones.

#include "cli/profile.hpp"
#include "run/plan.hpp"
#include "run/rebuild.hpp"

namespace rupture::tools {
namespace {

struct RunEnd {
  std::optional<double> until, duration;  // [s]
};

void add_restart_options(po::options_description& options) {
  auto add = options.add_options();
  add("until", in_rebuild(seconds_or_condition()),
      "run until this time, or until this condition holds, such as \"F_T < 300 or t > 0.5s\"");
  add("for", seconds(), "run for this long");
  add_start_options(options);
}

RunEnd run_end(const po::variables_map& values) {
  const RunEnd end = {until_time(values), optional_non_negative(values, "for")};
  if (end.until && end.duration) {
    throw UsageError("--until and --for cannot be combined: give one of them");
  }
  if (!end.until && !end.duration && !may_end_early(values)) {
    throw UsageError(
        "no end of the run was given: give --until T, --for T, --until-quiet, --until-spanned or "
        "--until-rupture-at X");
  }
  return end;
}

std::int64_t last_step(const RunEnd& end, const Checkpoint& checkpoint) {
  const Parameters& p = checkpoint.parameters;
  const std::int64_t now = checkpoint.state.step;
  if (!end.until) {
    if (end.duration.value_or(0.0) > 0.0) interval(p, checkpoint.state.clock, *end.duration, "for");
    return now + steps_in(p, end.duration.value_or(kLongestRun));
  }
  const std::int64_t last = step_at(p, checkpoint.state.clock, *end.until);
  if (last >= now) return last;
  throw UsageError("--until {:g} is before the checkpoint's time {:.7g} s", *end.until,
                   time(p, checkpoint.state));
}

int restart(const Parsed& parsed) {
  const std::string path = single_input(parsed.values, "checkpoint", "a checkpoint to continue");
  const RunEnd end = run_end(parsed.values);
  const RunOptions options = run_options(parsed);

  Checkpoint checkpoint = read_start(path, parsed.values);
  const Parameters before = checkpoint.parameters;
  Profile(parsed).apply(checkpoint.parameters);
  checkpoint.state = continued(std::move(checkpoint.state), checkpoint.parameters);
  checkpoint.provenance.push_back(
      make_provenance("restart", parsed.arguments, checkpoint.checksum,
                      rebuild_command("restart", before, checkpoint.parameters).text()));
  const StopRule rule = {last_step(end, checkpoint),
                         early_end(parsed.values, checkpoint.parameters)};
  return simulate(std::move(checkpoint), rule, options, path);
}

}  // namespace

constinit const Command restart_command = {
    "restart CHECKPOINT -o OUT (--until T | --for T | --until-quiet | ...)",
    "checkpoint",
    "continue a checkpoint, also with other parameters",
    "Continues a checkpoint. With unchanged parameters the result is bit for bit that of "
    "the\nuninterrupted run; --set changes parameters from now on, e.g. --set driving.V=0.\n"
    "At the end, prints the energy account: supplied = stored + lost to damping and junctions.",
    {add_restart_options, add_early_end_options, add_profile_option, add_run_options},
    restart,
    run_quantities,
    UsesParameters::yes,
    {"until", "for", "until-quiet", "until-spanned", "until-rupture-at"}};

}  // namespace rupture::tools
