// analyze steady-state: friction of a block that slides at constant speed.
#include <fmt/core.h>

#include "analyze/analyze.hpp"
#include "cli/option_values.hpp"
#include "rupture/analysis/slow_slip.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

// From slower than any fault creeps to about the speed of sound.
constexpr double kSlowest = 1e-9, kFastest = 1e3;  // [m/s]

double speed(const po::variables_map& values, const std::string& option) {
  const double v = values[option].as<double>();
  if (v >= kSlowest && v <= kFastest) return v;
  throw UsageError(fmt::format("--{} must be a speed from {:g} to {:g} m/s (got {})", option,
                               kSlowest, kFastest, v));
}

std::vector<double> speeds(const po::variables_map& values) {
  const double from = speed(values, "v-from"), to = speed(values, "v-to");
  if (to < from) throw UsageError("--v-to must not be below --v-from");
  return speeds_between(from, to, int_between(values, "points", 1, 10000));
}

/// tau/p at one speed.
struct SteadyPoint {
  double v = 0;  ///< [m/s]
  Mean mu;
  double mu_theory = 0;
};

/// `p`: normal force on the block [N].
Quantities quantities_of(const std::vector<SteadyPoint>& points, double p) {
  using P = SteadyPoint;
  const auto mu = [](const P& point) { return point.mu.value; };
  const auto error = [](const P& point) { return point.mu.standard_error; };
  return {
      {"v", "m/s", "each speed", each(points, &P::v), Csv::yes, TextColumn{12, "{:.4g}"}},
      {"mu", "1", "measured mean tau/p at each speed", each(points, mu), Csv::yes,
       TextColumn{11, "{:.6f}", "tau/p"}},
      {"mu_error", "1", "standard error of mu at each speed", each(points, error), Csv::yes,
       TextColumn{13, "{:.2g}", "std. error"}},
      {"mu_theory", "1", "tau/p by renewal theory at each speed", each(points, &P::mu_theory),
       Csv::yes, TextColumn{17, "{:.6f}", "renewal theory"}},
      {"p", "N", "normal force on the block", p},
  };
}

int measure(const Parsed& parsed) {
  Parameters p;
  apply(parsed.parameters, p);
  validate(p);
  refuse_other_laws(p);
  const SteadySliding block{p, mean_normal_force(p)};
  const auto speed_list = speeds(parsed.values);
  SteadyRun run;
  run.steps_per_cycle = int_between(parsed.values, "steps-per-cycle", 100, 10000000);
  std::vector<SteadyPoint> points;
  for (const double v : speed_list) {
    points.push_back({v, measured_friction(block, v, run), renewal_friction(block, v)});
  }
  const std::string text = fmt::format(
      "Not included in the standard error: events are up to one step (1/{} cycle) late.\n",
      run.steps_per_cycle);
  return print(quantities_of(points, block.p), text, parsed.values);
}

void add_steady_options(po::options_description& options) {
  auto add = options.add_options();
  add("v-from", number("V", "m/s")->default_value(1e-4, "1e-4"), "lowest speed");
  add("v-to", number("V", "m/s")->default_value(1.0, "1"), "highest speed");
  add("points", integer("N")->default_value(9), "number of speeds, spaced by equal ratios");
  add("steps-per-cycle", integer("N")->default_value(SteadyRun{}.steps_per_cycle),
      "time steps per cycle of pinning and slipping; a junction breaks up to one step late");
}

}  // namespace

constinit const Command steady_state_command = {
    "analyze steady-state",
    "",
    "friction of a block that slides at constant speed",
    "Friction coefficient of a block that slides at constant speed under the mean normal force\n"
    "F_N/Nx: simulated with the interface law, with its standard error, and by renewal theory.",
    {add_steady_options, add_format_options},
    measure,
    [] { return quantities_of(std::vector<SteadyPoint>{}, 0.0); },
    UsesParameters::yes};

}  // namespace rupture::tools
