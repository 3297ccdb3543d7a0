// analyze stress, phi: what a checkpoint says of the interface.
#include <fmt/core.h>

#include <numeric>

#include "analyze/analyze.hpp"
#include "analyze/inputs.hpp"
#include "cli/option_values.hpp"
#include "rupture/analysis/phi.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::tools {
namespace {

std::optional<double> ratio(double force, double strength) {
  return strength > 0.0 ? std::optional(force / strength) : std::nullopt;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Centroid of the normal forces, measured from the middle of the interface [m].
double centroid(const std::vector<double>& x, const std::vector<double>& p, double L) {
  double moment = 0.0, total = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    moment += p[i] * (x[i] - 0.5 * L);
    total += p[i];
  }
  return total > 0.0 ? moment / total : 0.0;
}

/// Forces along the interface.
struct Stress {
  double time = 0;                ///< [s]
  std::vector<double> x, p, tau;  ///< per block [m], [N], [N]
  double F_T = 0, F_N = 0;        ///< [N]
  double p_centroid = 0;          ///< from the middle of the interface [m]
};

Stress stress_of(const Checkpoint& checkpoint) {
  const Parameters& p = checkpoint.parameters;
  const State& state = checkpoint.state;
  Stress stress = {time(p, state),          block_positions(p),
                   normal_forces(p, state), friction_forces(p, state),
                   driving_force(p, state), p.F_N};
  stress.p_centroid = centroid(stress.x, stress.p, p.L);
  return stress;
}

Quantities quantities_of(const Stress& stress) {
  const TextColumn forces = {11, "{:.4f}"};
  Numbers tau_over_p;
  for (std::size_t i = 0; i < stress.p.size(); ++i) {
    tau_over_p.push_back(ratio(stress.tau[i], stress.p[i]));
  }
  return {
      {"time", "s", "time of the checkpoint", stress.time},
      positions(stress.x),
      {"p", "N", "normal force on each block", stress.p, Csv::yes, forces},
      {"tau", "N", "friction force on each block, > 0 where it pushes towards -x", stress.tau,
       Csv::yes, forces},
      text_only(tau_over_p, {8, "{:.4f}", "tau/p"}),
      {"F_T", "N", "driving force", stress.F_T},
      {"F_N", "N", "normal load", stress.F_N},
      {"p_centroid", "m", "centroid of the normal forces, from the middle of the interface",
       stress.p_centroid},
  };
}

Quantities quantities_of(const std::vector<BlockForces>& blocks, int bins) {
  using B = BlockForces;
  const TextColumn means = {15, "{:.4f}", "mean/f_thres"}, widths = {12, "{:.4f}", "sigma-bar"},
                   fractions = {11, "{:.2f}"};
  const auto relative_mean = [](const B& b) { return ratio(b.mean, b.f_thres); };
  const auto sigma_bar = [](const B& b) { return b.f_thres > 0.0 ? b.sigma_bar() : 0.0; };
  Counts histograms;
  for (const B& b : blocks) {
    histograms.push_back(b.f_thres > 0.0 ? std::optional(histogram(b, bins)) : std::nullopt);
  }
  return {
      positions(each(blocks, &B::x)),
      {"mean", "N", "mean junction force of each block", each(blocks, &B::mean), Csv::yes},
      text_only(each(blocks, relative_mean), means),
      {"sigma", "N", "standard deviation of the junction forces of each block",
       each(blocks, &B::sigma), Csv::yes},
      {"sigma_bar", "1", "sigma/(f_thres - f_slip) of each block", each(blocks, sigma_bar),
       Csv::yes, widths},
      {"slipping", "1", "fraction of slipping junctions of each block", each(blocks, &B::slipping),
       Csv::yes, fractions},
      {"f_thres", "N", "strength of one junction in each block", each(blocks, &B::f_thres),
       Csv::yes},
      {"f_slip", "N", "force in one slipping junction of each block", each(blocks, &B::f_slip)},
      {"histogram", "1", "junctions of each block in each bin from -f_thres to f_thres",
       histograms},
  };
}

}  // namespace

constinit const Command stress_command = {
    "analyze stress CHECKPOINT",
    "checkpoint",
    "normal and friction forces along the interface of a checkpoint",
    "Normal force p and friction force tau on each interface block; tau > 0 where friction\n"
    "pushes the block towards -x.",
    {add_format_options},
    [](const Parsed& parsed) {
      const Stress stress = stress_of(checkpoint_of(parsed));
      const std::string text = fmt::format(
          "t = {:.7g} s, F_T = {:.6g} N, sum p = {:.9g} N, sum tau = {:.6g} N, centroid of p "
          "at {:.4g} mm from the middle\n",
          stress.time, stress.F_T, sum(stress.p), sum(stress.tau), stress.p_centroid * 1e3);
      return print(quantities_of(stress), text, parsed.values);
    },
    [] { return quantities_of(Stress{}); }};

constinit const Command phi_command = {
    "analyze phi CHECKPOINT",
    "checkpoint",
    "distribution of junction forces in a checkpoint",
    "Forces in the junctions of each block: mean, standard deviation, histogram.",
    {[](po::options_description& options) {
       options.add_options()("bins", integer("N")->default_value(40),
                             "number of histogram bins between -f_thres and f_thres");
     },
     add_format_options},
    [](const Parsed& parsed) {
      const Checkpoint checkpoint = checkpoint_of(parsed);
      const int bins = int_between(parsed.values, "bins", 1, 100000);
      refuse_single_springs(checkpoint.parameters);
      const auto blocks = block_forces(checkpoint.parameters, checkpoint.state);
      return print(quantities_of(blocks, bins), "", parsed.values);
    },
    [] { return quantities_of(std::vector<BlockForces>{}, 0); }};

}  // namespace rupture::tools
