// load: the slider under its normal load, then driven from the side.
#include "cli/profile.hpp"
#include "run/plan.hpp"
#include "run/rebuild.hpp"
#include "rupture/dynamics/equilibrium.hpp"

namespace rupture::tools {
namespace {

int load(const Parsed& parsed) {
  Parameters p;
  Profile(parsed).apply(p);
  validate(p);
  const auto until = until_time(parsed.values);
  const bool is_driven = until || may_end_early(parsed.values);
  const EarlyEnd early = early_end(parsed.values, p);
  const RunOptions options = run_options(parsed);

  if (!options.resume && !options.is_dry) check_output(options.output);
  Checkpoint start = {p,
                      options.is_dry ? roughly_loaded(p) : normal_load_equilibrium(p),
                      {make_provenance("load", parsed.arguments, "",
                                       rebuild_command("load", Parameters{}, p).text())}};
  const int code =
      simulate(std::move(start),
               {steps_in(p, until.value_or(is_driven ? kLongestRun : 0.0)), early}, options, {});
  if (!is_driven) {
    options.output.say("no --until T was given: the slider is loaded, but not driven\n");
  }
  return code;
}

}  // namespace

constinit const Command load_command = {
    "load -o OUT [--until T]",
    "",
    "put the slider under its normal load, then drive it from the side",
    "Finds the equilibrium of the slider under its normal load F_N, then moves the driving\n"
    "point at speed V, and writes a checkpoint from which the run can be continued.\n"
    "At the end, prints the energy account: supplied = stored + lost to damping and junctions.",
    {[](po::options_description& options) {
       options.add_options()("until", in_rebuild(seconds_or_condition()->default_value("0")),
                             "stop at this time, or when this condition holds, such as \"F_T > 300 "
                             "or t > 0.5s\"; 0: only find the equilibrium");
     },
     add_early_end_options, add_profile_option, add_run_options},
    load,
    run_quantities,
    UsesParameters::yes};

}  // namespace rupture::tools
