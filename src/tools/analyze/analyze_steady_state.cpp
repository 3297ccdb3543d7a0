// analyze steady-state: friction of a block that slides at constant speed.
#include <fmt/core.h>

#include "analyze/analyze.hpp"
#include "cli/option_values.hpp"
#include "rupture/analysis/steady_sliding.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

constexpr int kMostPoints = 10000;
constexpr int kFewestSteps = 100, kMostSteps = 10000000;

// From slower than any fault creeps to about the speed of sound.
constexpr double kSlowest = 1e-9, kFastest = 1e3;  // [m/s]

double speed(const po::variables_map& values, const std::string& option) {
  const double v = values[option].as<double>();
  if (v >= kSlowest && v <= kFastest) return v;
  throw UsageError(fmt::format("--{} {} makes no sense: give a speed from {:g} to {:g} m/s", option,
                               v, kSlowest, kFastest));
}

std::vector<double> speeds(const po::variables_map& values) {
  const double from = speed(values, "v-from"), to = speed(values, "v-to");
  const int points = values["points"].as<int>();
  if (to < from) throw UsageError("the range of speeds is empty: --v-to is below --v-from");
  if (points < 1 || points > kMostPoints) {
    throw UsageError(fmt::format("--points {} makes no sense: give 1 to {}", points, kMostPoints));
  }
  return speeds_between(from, to, points);
}

SteadyRun steady_run(const po::variables_map& values) {
  SteadyRun run;
  run.steps_per_cycle = values["steps-per-cycle"].as<int>();
  if (run.steps_per_cycle < kFewestSteps || run.steps_per_cycle > kMostSteps) {
    throw UsageError(fmt::format("--steps-per-cycle {} makes no sense: give {} to {}",
                                 run.steps_per_cycle, kFewestSteps, kMostSteps));
  }
  return run;
}

Parsed parse_arguments(int argc, const char* const* argv) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("v-from", number("V", "m/s")->default_value(1e-4, "1e-4"), "lowest speed");
  add("v-to", number("V", "m/s")->default_value(1.0, "1"), "highest speed");
  add("points", integer("N")->default_value(9), "speeds, at equal ratios");
  add("steps-per-cycle", integer("N")->default_value(SteadyRun{}.steps_per_cycle),
      "time steps while a junction is pinned and slips once; it breaks up to a step late");
  add_format_options(options);
  return parse(argc, argv,
               {"analyze steady-state", "analyze steady-state [options]",
                "Friction coefficient of a block under the mean normal force F_N/Nx that slides at "
                "constant\nspeed: as the interface law gives it, with its standard error, and by "
                "renewal theory."},
               options, "", UsesParameters::yes);
}

}  // namespace

int analyze_steady_state(int argc, const char* const* argv) {
  const Parsed parsed = parse_arguments(argc, argv);
  Parameters p;
  apply(parsed.parameters, p);
  validate(p);
  refuse_other_laws(p);
  const SteadySliding block{p, mean_normal_force(p)};
  const auto v = speeds(parsed.values);
  const SteadyRun run = steady_run(parsed.values);
  std::vector<double> mu, error, theory;
  Report report;
  report.text = "     v [m/s]      tau/p   std. error   renewal theory\n";
  for (const double speed : v) {
    const Mean measured = measured_friction(block, speed, run);
    mu.push_back(measured.value);
    error.push_back(measured.standard_error);
    theory.push_back(renewal_friction(block, speed));
    report.text += fmt::format("{:12.4g}{:11.6f}{:13.2g}{:17.6f}\n", speed, mu.back(), error.back(),
                               theory.back());
  }
  report.text += fmt::format(
      "Not in the standard error: events come up to a step late, which is 1/{} of a cycle.\n",
      run.steps_per_cycle);
  report.json = {{"v", v}, {"mu", mu}, {"mu_error", error}, {"mu_theory", theory}, {"p", block.p}};
  report.series = {column("v [m/s]", v), column("mu", mu), column("mu_error", error),
                   column("mu_theory", theory)};
  print(report, parsed.values);
  return kDone;
}

}  // namespace rupture::tools
