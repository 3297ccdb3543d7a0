// analyze estimate: slow slip to expect from a checkpoint's parameters.
#include <fmt/core.h>

#include <numeric>

#include "analyze/analyze.hpp"
#include "analyze/inputs.hpp"
#include "cli/option_values.hpp"
#include "rupture/analysis/phi.hpp"
#include "rupture/analysis/slow_slip.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::tools {
namespace {

/// The parameters with the seed of the random numbers that was asked for.
Parameters seeded(Parameters p, const po::variables_map& values) {
  if (values.count("seed") > 0) {
    set_parameter(p, "numerics.seed", values["seed"].as<std::string>());
  }
  return p;
}

/// Slow slip to expect, of the mean and of each block.
struct Estimate {
  double v_slow_slip = 0, p = 0, t_R = 0;  ///< [m/s], mean normal force [N], [s]
  std::optional<RelaxationEnsemble> ensemble;
  std::optional<Relaxation> first;  ///< of the ensemble
  std::vector<double> x, p_i, v_i;  ///< per block [m], [N], [m/s]
};

Estimate estimate_of(const Checkpoint& checkpoint, const po::variables_map& values) {
  const Parameters& p = checkpoint.parameters;
  Estimate estimate;
  estimate.t_R = mean_slipping_time(p);
  estimate.x = block_positions(p);
  estimate.p_i = normal_forces(p, checkpoint.state);
  for (const double p_i : estimate.p_i) estimate.v_i.push_back(slow_slip_estimate(p, p_i));
  estimate.p = std::accumulate(estimate.p_i.begin(), estimate.p_i.end(), 0.0) /
               static_cast<double>(estimate.p_i.size());
  estimate.v_slow_slip = slow_slip_estimate(p, estimate.p);
  const Parameters with_seed = seeded(p, values);
  estimate.ensemble = relax_ensemble(with_seed, int_between(values, "ensemble", 2, 100000));
  estimate.first = relax(with_seed, 0);
  return estimate;
}

/// Mean and standard deviation over the ensemble.
Quantities over_ensemble(const std::string& key, const std::string& help,
                         const std::optional<Mean>& mean) {
  const auto known = [&](double Mean::*member) {
    return mean ? std::optional((*mean).*member) : std::nullopt;
  };
  return {{key, "1", help + ", mean over the ensemble", known(&Mean::value)},
          {key + "_deviation", "1", help + ", standard deviation", known(&Mean::deviation)}};
}

Quantities ensemble_quantities(const std::optional<RelaxationEnsemble>& ensemble) {
  using E = RelaxationEnsemble;
  const auto mean = [&](Mean E::*member) {
    return ensemble ? std::optional((*ensemble).*member) : std::nullopt;
  };
  return join({
      over_ensemble("net_slip_over_f_slip_per_k_ij",
                    "slip until no junction slips any more, in f_slip/k_ij", mean(&E::net_slip)),
      over_ensemble("slip_after_two_t_R_over_f_slip_per_k_ij", "slip after 2 <t_R>, in f_slip/k_ij",
                    mean(&E::slip_after_two)),
      over_ensemble("slip_at_return_over_f_slip_per_k_ij",
                    "slip until each junction has been pinned once, in f_slip/k_ij",
                    mean(&E::slip_at_return)),
      over_ensemble("duration_over_t_R", "time until each junction has been pinned once, in <t_R>",
                    mean(&E::duration)),
      over_ensemble("quiet_after_over_t_R", "time until no junction slips any more, in <t_R>",
                    mean(&E::quiet_time)),
  });
}

Quantity course_of(const std::optional<Relaxation>& relaxation) {
  const auto course = relaxation.value_or(Relaxation{}).course;
  const Quantities rows = {
      {"time_over_t_R", "1", "time at which each junction was pinned, in <t_R>", course.time},
      {"slip_over_f_slip_per_k_ij", "1", "slip at that time, in f_slip/k_ij", course.slip},
  };
  return {"relaxation", "", "", Group{rows, relaxation.has_value()}};
}

Quantities quantities_of(const Estimate& e) {
  const TextColumn forces = {11, "{:.4f}"}, speeds = {11, "{:.4f}", "v [mm/s]", 1e3};
  const Quantities block = {
      positions(e.x),
      {"p", "N", "normal force on each block", e.p_i, Csv::yes, forces},
      {"v_slow_slip", "m/s", "speed of slow slip of each block by Eq. S1", e.v_i, Csv::yes, speeds},
  };
  return join({
      {
          {"v_slow_slip", "m/s", "speed of slow slip by Eq. S1 at the mean normal force",
           e.v_slow_slip},
          {"p", "N", "mean normal force on a block", e.p},
          {"t_R", "s", "mean slipping time <t_R>", e.t_R},
      },
      ensemble_quantities(e.ensemble),
      {course_of(e.first), {"block", "", "", Group{block}}},
  });
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
      const Checkpoint checkpoint = checkpoint_of(parsed);
      refuse_other_laws(checkpoint.parameters);
      const Estimate estimate = estimate_of(checkpoint, parsed.values);
      const std::string text =
          fmt::format("Eq. S1 at the mean normal force {:.5g} N, <t_R> = {:.5g} ms: {:.4f} mm/s\n",
                      estimate.p, estimate.t_R * 1e3, estimate.v_slow_slip * 1e3);
      return print(quantities_of(estimate), text + relaxation_text(estimate.ensemble),
                   parsed.values);
    },
    [] { return quantities_of(Estimate{}); }};

}  // namespace rupture::tools
