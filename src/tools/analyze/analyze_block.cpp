// analyze estimate, steady-state: slow slip and friction of one block, by theory and simulated.
#include <fmt/core.h>

#include <cmath>
#include <numeric>

#include "analyze/analyze.hpp"
#include "rupture/analysis/phi.hpp"
#include "rupture/analysis/slow_slip.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/laws.hpp"

namespace rupture::tools {
namespace {

/// There is theory for the reference law alone.
void refuse_other_laws(const Parameters& p) {
  if (p.law == Law::reference) return;
  throw UsageError("junctions.law = {} is not supported here: use the {} law", law_info(p.law).name,
                   law_info(Law::reference).name);
}

/// Mean and standard deviation over the ensemble.
Quantities ensemble_quantities(const std::optional<RelaxationEnsemble>& ensemble) {
  using E = RelaxationEnsemble;
  struct Row {
    std::string key, help;
    Mean E::*mean;
  };
  const std::vector<Row> table = {
      {"net_slip_over_f_slip_per_k_ij", "slip until no junction slips any more, in f_slip/k_ij",
       &E::net_slip},
      {"slip_after_two_t_R_over_f_slip_per_k_ij", "slip after 2 <t_R>, in f_slip/k_ij",
       &E::slip_after_two},
      {"slip_at_return_over_f_slip_per_k_ij",
       "slip until each junction has been pinned once, in f_slip/k_ij", &E::slip_at_return},
      {"duration_over_t_R", "time until each junction has been pinned once, in <t_R>",
       &E::duration},
      {"quiet_after_over_t_R", "time until no junction slips any more, in <t_R>", &E::quiet_time},
  };
  Quantities rows;
  for (const Row& row : table) {
    const auto known = [&](double Mean::*member) {
      return ensemble ? std::optional((*ensemble).*row.mean.*member) : std::nullopt;
    };
    rows.push_back({row.key, "1", row.help + ", mean over the ensemble", known(&Mean::value)});
    rows.push_back(
        {row.key + "_deviation", "1", row.help + ", standard deviation", known(&Mean::deviation)});
  }
  return rows;
}

Quantity course_of(const std::optional<Relaxation>& relaxation) {
  const auto course = relaxation.value_or(Relaxation{}).course;
  const Quantities rows = {
      {"time_over_t_R", "1", "time at which each junction was pinned, in <t_R>", course.time},
      {"slip_over_f_slip_per_k_ij", "1", "slip at that time, in f_slip/k_ij", course.slip},
  };
  return {"relaxation", "", "", Group{rows, relaxation.has_value()}};
}

std::string relaxation_text(const std::optional<RelaxationEnsemble>& relaxation) {
  if (!relaxation) return "relaxation of one block: never ends\n";
  const auto text = [](const Mean& m) {
    return fmt::format("{:.3f} +- {:.3f}", m.value, m.deviation);
  };
  return fmt::format(
      "relaxation of one block (mean +- standard deviation, slip in f_slip/k_ij):\n"
      "  net slip {}, of which {} in 2 <t_R>: on average {:.2f} f_slip/k_ij per <t_R>\n"
      "  every junction has been pinned once after {} <t_R>, at slip {}\n"
      "  no junction slips any more after {} <t_R>\n",
      text(relaxation->net_slip), text(relaxation->slip_after_two),
      relaxation->slip_after_two.value / 2.0, text(relaxation->duration),
      text(relaxation->slip_at_return), text(relaxation->quiet_time));
}

/// Slow slip to expect of the block in the middle at the mean normal force, and of each block, and
/// the relaxation of one block in `n` replicas with slipping times of their own.
Report estimate_of(const Checkpoint& checkpoint, int n) {
  const std::int64_t in_middle = checkpoint.parameters.Nx / 2;
  const Parameters parameters = at_block(checkpoint.parameters, in_middle);
  const double t_R = mean_slipping_time(parameters, in_middle);
  const auto p_i = normal_forces(checkpoint.parameters, checkpoint.state);
  std::vector<double> speeds_of_blocks;
  for (const double p : p_i) {
    const auto i = std::ssize(speeds_of_blocks);
    speeds_of_blocks.push_back(slow_slip_estimate(checkpoint.parameters, i, p));
  }
  const double p = std::accumulate(p_i.begin(), p_i.end(), 0.0) / static_cast<double>(p_i.size());
  const double v = slow_slip_estimate(parameters, in_middle, p);
  const auto ensemble = relax_ensemble(parameters, n);
  const TextColumn forces = {11, "{:.4f}"}, speeds = {11, "{:.4f}", "v [mm/s]", 1e3};
  const Quantities block = {
      positions(block_positions(parameters)),
      {"p", "N", "normal force on each block", p_i, Csv::yes, forces},
      {"v_slow_slip", "m/s", "speed of slow slip of each block by Eq. S1", speeds_of_blocks,
       Csv::yes, speeds},
  };
  const Quantities rows = join({
      {
          {"v_slow_slip", "m/s", "speed of slow slip by Eq. S1 at the mean normal force", v},
          {"p", "N", "mean normal force on a block", p},
          {"t_R", "s", "mean slipping time <t_R>", t_R},
      },
      ensemble_quantities(ensemble),
      {course_of(relax(parameters, 0)), {"block", "", "", Group{block}}},
  });
  const std::string answer =
      fmt::format("Eq. S1 at the mean normal force {:.5g} N, <t_R> = {:.5g} ms: {:.4f} mm/s\n{}", p,
                  t_R * 1e3, v * 1e3, relaxation_text(ensemble));
  return {rows, "", answer};
}

// From slower than any fault creeps to about the speed of sound.
constexpr double kSlowest = 1e-9, kFastest = 1e3;  // [m/s]

double speed(const po::variables_map& values, const std::string& option) {
  const double v = values[option].as<double>();
  if (v >= kSlowest && v <= kFastest) return v;
  throw UsageError("--{} must be a speed from {:g} to {:g} m/s (got {})", option, kSlowest,
                   kFastest, v);
}

/// At equal ratios, both ends included [m/s].
std::vector<double> speeds(const po::variables_map& values) {
  const double from = speed(values, "v-from"), to = speed(values, "v-to");
  if (to < from) {
    throw UsageError("--v-from must be at most --v-to, {:g} m/s (got {:g} m/s)", to, from);
  }
  const int points = int_between(values, "points", 1, 10000);
  std::vector<double> v;
  for (int n = 0; n < points; ++n) {
    const double part = points > 1 ? static_cast<double>(n) / (points - 1) : 0.0;
    v.push_back(from * std::pow(to / from, part));
  }
  return v;
}

Report steady_sliding(const Parameters& p, const std::vector<double>& speeds,
                      const SteadyRun& run) {
  const SteadySliding block = {p, mean_normal_force(p)};
  std::vector<Mean> mu;
  mu.reserve(speeds.size());
  for (const double v : speeds) mu.push_back(measured_friction(block, v, run));
  const auto theory = [&](double v) { return renewal_friction(block, v); };
  const Quantities rows = {
      {"v", "m/s", "each speed", speeds, Csv::yes, TextColumn{12, "{:.4g}"}},
      {"mu", "1", "measured mean tau/p at each speed", each(mu, &Mean::value), Csv::yes,
       TextColumn{11, "{:.6f}", "tau/p"}},
      {"mu_error", "1", "standard error of mu at each speed", each(mu, &Mean::standard_error),
       Csv::yes, TextColumn{13, "{:.2g}", "std. error"}},
      {"mu_theory", "1", "tau/p by renewal theory at each speed", each(speeds, theory), Csv::yes,
       TextColumn{17, "{:.6f}", "renewal theory"}},
      {"p", "N", "normal force on the block", block.p},
  };
  return {rows,
          fmt::format(
              "Not included in the standard error: events are up to one step (1/{} cycle) late.\n",
              run.steps_per_cycle)};
}

int measure_steady_state(const Parsed& parsed) {
  Parameters p;
  set_parameters(parsed.parameters, p);
  validate(p);
  refuse_other_laws(p);
  if (const auto rows = varying(p); !rows.empty()) {
    throw UsageError("{} varies along x, but one block slides here: give one value",
                     rows.front()->name);
  }
  const auto v = speeds(parsed.values);
  SteadyRun run;
  run.steps_per_cycle = int_between(parsed.values, "steps-per-cycle", 100, 10000000);
  return print(steady_sliding(p, v, run), parsed.values);
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

constinit const Command estimate_command = {
    "analyze estimate CHECKPOINT",
    "checkpoint",
    "slow slip expected from a checkpoint's parameters",
    R"(Slow slip by Eq. S1, v = 4.2 tau_slip / (k_i <t_R>), at the mean normal force and of
each block, and the relaxation of one block, which gives the coefficient 4.2.)",
    {[](po::options_description& options) {
       auto add = options.add_options();
       add("ensemble", integer("N")->default_value(100),
           "number of blocks to relax, each with its own slipping times");
       add("seed", seed(), "seed of their random numbers; default: the checkpoint's");
     },
     add_format_options},
    [](const Parsed& parsed) {
      Checkpoint checkpoint = checkpoint_of(parsed);
      refuse_other_laws(checkpoint.parameters);
      if (parsed.values.count("seed") > 0) {
        set_parameter(checkpoint.parameters, "numerics.seed",
                      parsed.values["seed"].as<std::string>());
      }
      const int n = int_between(parsed.values, "ensemble", 2, 100000);
      return print(estimate_of(checkpoint, n), parsed.values);
    },
    [] {
      return estimate_of({Parameters{}, State(Parameters{}), {}}, 2).rows;
    }};

constinit const Command steady_state_command = {
    "analyze steady-state",
    "",
    "friction of a block that slides at constant speed",
    "Friction coefficient of a block that slides at constant speed under the mean normal force\n"
    "F_N/Nx: simulated with the interface law, with its standard error, and by renewal theory.",
    {add_steady_options, add_format_options},
    measure_steady_state,
    [] { return steady_sliding({}, {}, {}).rows; },
    UsesParameters::yes};

}  // namespace rupture::tools
