// load: the slider under its normal load, then driven from the side.
#include "cli/option_values.hpp"
#include "run/files.hpp"
#include "run/run.hpp"
#include "rupture/dynamics/equilibrium.hpp"

namespace {

using namespace rupture;
using namespace rupture::tools;

struct Options {
  Parameters parameters;
  double until;  // [s]
  RunOptions run;
  OutputOptions output;
};

Options setup(int argc, char** argv) {
  po::options_description options("Options");
  options.add_options()("until", seconds()->default_value(0.0, "0"),
                        "drive until this time; 0: only the equilibrium");
  add_run_options(options);
  add_output_options(options, "checkpoint");
  const Parsed parsed = parse(
      argc, argv,
      {"load",
       "load -o OUT [--until T] [options]",
       "Finds the equilibrium of the slider under its normal load F_N, then moves the driving\n"
       "point at speed V, and writes a checkpoint from which the run can be continued.\n"
       "It ends with the energy account: supplied = stored + lost to damping and junctions.",
       {},
       "put the slider under its normal load, then drive it from the side"},
      options, "", UsesParameters::yes);
  Parameters parameters;
  apply(parsed.parameters, parameters);
  validate(parameters);
  return {parameters, non_negative(parsed.values, "until"), run_options(parsed),
          output_options(parsed.values)};
}

int run(const Options& options) {
  if (options.run.resume == Resume::no)
    check_output(options.output.output, options.output.if_exists);
  const Parameters& p = options.parameters;
  const bool dry = options.run.dry_run != DryRun::no;
  Checkpoint start = {p,
                      dry ? roughly_loaded(p) : normal_load_equilibrium(p),
                      {make_provenance("load", options.run.arguments, "",
                                       shell_line(rebuild_command("load", Parameters{}, p)))}};
  simulate(std::move(start), {steps_in(p, options.until), {}}, options.run, options.output, {});
  return kDone;
}

}  // namespace

int main(int argc, char** argv) {
  return run_tool("load", [&] { return run(setup(argc, argv)); });
}
