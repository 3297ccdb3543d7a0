// prepare: an interface with a prescribed prestress, at the moment its event is triggered.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "cli/command_line.hpp"
#include "cli/option_values.hpp"
#include "cli/text.hpp"
#include "run/files.hpp"
#include "run/summary.hpp"
#include "rupture/analysis/phi.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/dynamics/equilibrium.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"

namespace {

using namespace rupture;
using namespace rupture::tools;

struct Options {
  Parameters parameters;
  Prestress prestress;
  OutputOptions output;
  std::vector<std::string> arguments;
  std::string rebuild;
};

void add_prestress_options(po::options_description& options) {
  auto add = options.add_options();
  add("tau-bar", number("T")->required(),
      "prestress (tau_0/p - mu_d)/(mu_s - mu_d), uniform beyond the trigger region");
  add("sigma-bar", number("S")->default_value(0.0, "0"),
      "standard deviation of the junction forces over f_thres - f_slip");
  add("shape", one_of("uniform|bell")->default_value("uniform"),
      "shape of the distribution of junction forces");
  add("x-trigger", number("X", "m")->default_value(Prestress{}.x_trigger, "0.0225"),
      "blocks below this x are the trigger region");
  add("tau-bar-trigger", number("T")->default_value(Prestress{}.tau_bar_trigger, "0.3"),
      "prestress of the trigger region");
  add("no-trigger", "leave the junctions of the trigger region pinned");
}

Prestress prestress_of(const po::variables_map& values) {
  Prestress prestress;
  prestress.tau_bar = values["tau-bar"].as<double>();
  prestress.sigma_bar = non_negative(values, "sigma-bar");
  prestress.shape = shape_named(values["shape"].as<std::string>());
  prestress.x_trigger = non_negative(values, "x-trigger");
  prestress.tau_bar_trigger = values["tau-bar-trigger"].as<double>();
  if (values.count("no-trigger") > 0) prestress.trigger = Trigger::pinned;
  return prestress;
}

/// The parameters of a prepared interface: under a ceiling, with the driving point at rest.
Parameters default_parameters() {
  Parameters p;
  p.support = Support::ceiling;
  p.V = 0.0;
  return p;
}

Parameters prepared_parameters(const ParameterChanges& changes) {
  Parameters p = default_parameters();
  apply(changes, p);
  if (p.V != 0.0) {
    throw UsageError(fmt::format(
        "driving.V must be 0 (got {:g} m/s): a prepared interface is at rest; set it in restart",
        p.V));
  }
  validate(p);
  return p;
}

Options setup(int argc, char** argv) {
  po::options_description options("Options");
  add_prestress_options(options);
  const po::options_description own = options;
  add_output_options(options, "checkpoint");
  const Parsed parsed = parse(
      argc, argv,
      {"prepare",
       "prepare --tau-bar T -o OUT [options]",
       "Writes a checkpoint of a slider at rest whose interface carries a prescribed prestress,\n"
       "with its trigger region just depinned; restart then runs the event. The normal force is\n"
       "the same on all interface blocks (slider.support = ceiling), and driving.V is 0.",
       {},
       "make an interface with a prescribed prestress, ready to break"},
      options, "", UsesParameters::yes);
  const Parameters parameters = prepared_parameters(parsed.parameters);
  const auto command = rebuild_command("prepare", default_parameters(), parameters);
  return {parameters, prestress_of(parsed.values), output_options(parsed.values), parsed.arguments,
          shell_line(with_options(command, own, parsed.values))};
}

/// How well the pinned blocks carry what was asked for, and how wide phi could be.
PreparedSummary summary_of(const Options& options, const State& state) {
  const Parameters& p = options.parameters;
  const auto wanted = prescribed_friction(p, options.prestress);
  const auto blocks = block_forces(p, state);
  PreparedSummary summary;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (blocks[i].slipping > 0.0) {
      ++summary.depinned;
      continue;
    }
    const double tau = blocks[i].mean * static_cast<double>(springs_per_block(p));
    summary.error = std::max(summary.error, std::abs(tau / wanted[i] - 1.0));
  }
  const auto& last = blocks.back();
  summary.prestress = last.mean / last.f_thres * p.mu_s;
  summary.sigma_bar = last.sigma_bar();
  summary.largest_sigma_bar = largest_sigma_bar(p, options.prestress);
  summary.F_T = driving_force(p, state);
  summary.blocks = static_cast<std::int64_t>(blocks.size());
  return summary;
}

void print(const PreparedSummary& summary, const Prestress& prestress, std::FILE* to) {
  say_on(to, "tau/p = {:.6f} beyond x = {:g} m, within {:.1e} of the requested value\n",
         summary.prestress, prestress.x_trigger, summary.error);
  say_on(to, "sigma-bar = {:.6f}; the largest possible is {:.6f}\n", summary.sigma_bar,
         summary.largest_sigma_bar);
  say_on(to, "F_T = {:.6f} N balances the prestress; {} of {} blocks are depinned\n", summary.F_T,
         summary.depinned, summary.blocks);
  const WrittenFile& file = summary.files.front();
  say_on(to, "{}", wrote_text(file.path, file.checksum));
}

int run(const Options& options) {
  check_output(options.output.output, options.output.if_exists);
  const Checkpoint prepared = {
      options.parameters,
      prepared_state(options.parameters, options.prestress),
      {make_provenance("prepare", options.arguments, "", options.rebuild)}};
  const auto checksum = write_checkpoint(options.output.output, prepared, options.output.if_exists,
                                         options.output.sum);
  PreparedSummary summary = summary_of(options, prepared.state);
  summary.files = {{options.output.output, "checkpoint", checksum}};
  if (options.output.verbosity == Verbosity::normal) {
    print(summary, options.prestress, options.output.text());
  }
  print_if_asked(quantities_of(summary), options.output);
  return kDone;
}

}  // namespace

int main(int argc, char** argv) {
  return run_tool("prepare", [&] { return run(setup(argc, argv)); });
}
