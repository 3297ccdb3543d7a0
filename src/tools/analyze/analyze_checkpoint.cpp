// analyze stress, phi, strength: what a checkpoint says of the interface.
#include <fmt/core.h>

#include <numeric>

#include "analyze/analyze.hpp"
#include "rupture/analysis/strength.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::tools {
namespace {

std::optional<double> ratio(double force, double strength) {
  return strength > 0.0 ? std::optional(force / strength) : std::nullopt;
}

Report stress_of(const Checkpoint& checkpoint) {
  const Parameters& parameters = checkpoint.parameters;
  const State& state = checkpoint.state;
  const auto x = block_positions(parameters), p = normal_forces(parameters, state),
             tau = friction_forces(parameters, state);
  const double t = time(parameters, state), F_T = driving_force(parameters, state);
  Numbers tau_over_p;
  for (std::size_t i = 0; i < p.size(); ++i) tau_over_p.push_back(ratio(tau[i], p[i]));
  const TextColumn forces = {11, "{:.4f}"};
  const Quantities rows = {
      {"time", "s", "time of the checkpoint", t},
      positions(x),
      {"p", "N", "normal force on each block", p, Csv::yes, forces},
      {"tau", "N", "friction force on each block, > 0 where it pushes towards -x", tau, Csv::yes,
       forces},
      text_only(tau_over_p, {8, "{:.4f}", "tau/p"}),
      {"F_T", "N", "driving force", F_T},
      {"F_N", "N", "normal load", parameters.F_N},
  };
  const auto sum = [](const auto& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
  };
  return {rows, fmt::format("t = {:.7g} s, F_T = {:.6g} N, sum p = {:.9g} N, sum tau = {:.6g} N\n",
                            t, F_T, sum(p), sum(tau))};
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

/// mu-bar of a shape of phi, and friction with the default mu_s and mu_d.
Report strength_of(const std::string& shape, double sigma_bar) {
  const Parameters p;
  const double mu_s = p.mu_s[0], mu_d = p.mu_d[0];
  const double mu_bar = effective_strength(shape_named(shape), sigma_bar);
  const double mu = mu_d + mu_bar * (mu_s - mu_d);
  const Quantities rows = {
      {"shape", "", "uniform or bell (of a shape)", shape},
      {"sigma_bar", "1", "standard deviation over f_thres - f_slip (of a shape)", sigma_bar,
       Csv::yes},
      {"mu_bar_eff", "1",
       "effective static friction, (tau_max/p - mu_d)/(mu_s - mu_d) (of a shape)", mu_bar,
       Csv::yes},
      {"mu_eff", "1", "tau_max/p at the default mu_s and mu_d (of a shape)", mu, Csv::yes},
  };
  return {rows, fmt::format("{} phi, sigma-bar = {:g}: effective static friction mu-bar = {:.7f}, "
                            "{:.7f} at mu_s = {:g} and mu_d = {:g}\n",
                            shape, sigma_bar, mu_bar, mu, mu_s, mu_d)};
}

Quantities quantities_of(const std::vector<BlockStrength>& blocks) {
  using B = BlockStrength;
  const auto mu_eff = [](const B& b) { return ratio(b.tau_max, b.p); };
  const auto headed = [](const char* heading) { return TextColumn{12, "{:.4g}", heading}; };
  return {
      {"x", "m", "position of each block (of a checkpoint)", each(blocks, &B::x), Csv::yes,
       TextColumn{9, "{:.4f}"}},
      {"slipping", "1", "fraction of slipping junctions of each block (of a checkpoint)",
       each(blocks, &B::slipping), Csv::yes, TextColumn{11, "{:.2f}"}},
      {"sigma_bar", "1", "sigma/(f_thres - f_slip) of each block (of a checkpoint)",
       each(blocks, &B::sigma_bar), Csv::yes, headed("sigma-bar")},
      {"tau_bar_0", "1", "(tau/p - mu_d)/(mu_s - mu_d) of each block (of a checkpoint)",
       each(blocks, &B::tau_bar_0), Csv::yes, headed("tau-bar_0")},
      {"mu_bar_eff", "1", "(tau_max/p - mu_d)/(mu_s - mu_d) of each block (of a checkpoint)",
       each(blocks, &B::mu_bar_eff), Csv::yes, headed("mu-bar")},
      {"mu_eff", "1", "tau_max/p of each block (of a checkpoint)", each(blocks, mu_eff), Csv::yes,
       headed("tau_max/p")},
  };
}

void add_shape_options(po::options_description& options) {
  auto add = options.add_options();
  add("shape", one_of("uniform|bell"), "shape of phi, instead of a checkpoint");
  add("sigma-bar", number("S"), "its standard deviation over f_thres - f_slip");
}

int measure_strength(const Parsed& parsed) {
  const auto& values = parsed.values;
  const bool has_shape = values.count("shape") > 0, has_width = values.count("sigma-bar") > 0;
  if ((has_shape || has_width) && values.count("checkpoint") > 0) {
    throw UsageError("a checkpoint has its own phi: give a checkpoint or --shape, not both");
  }
  if (has_shape != has_width) {
    throw UsageError("--shape and --sigma-bar need each other: give both, or a checkpoint instead");
  }
  if (has_shape) {
    const double sigma_bar = non_negative(values, "sigma-bar");
    return print(strength_of(values["shape"].as<std::string>(), sigma_bar), values);
  }
  const Checkpoint checkpoint = checkpoint_of(parsed, "a checkpoint, or give --shape");
  refuse_single_springs(checkpoint.parameters);
  const auto blocks = block_strengths(checkpoint.parameters, checkpoint.state);
  return print({quantities_of(blocks), ""}, values);
}

}  // namespace

constinit const Command stress_command = {
    "analyze stress CHECKPOINT",
    "checkpoint",
    "normal and friction forces along the interface of a checkpoint",
    "Normal force p and friction force tau on each interface block; tau > 0 where friction\n"
    "pushes the block towards -x.",
    {add_format_options},
    [](const Parsed& parsed) { return print(stress_of(checkpoint_of(parsed)), parsed.values); },
    [] {
      return stress_of({Parameters{}, State(Parameters{}), {}}).rows;
    }};

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
      return print({quantities_of(blocks, bins), ""}, parsed.values);
    },
    [] { return quantities_of(std::vector<BlockForces>{}, 0); }};

constinit const Command strength_command = {
    "analyze strength CHECKPOINT | --shape uniform|bell --sigma-bar S",
    "checkpoint",
    "effective static friction of a shape of phi or of a checkpoint's blocks",
    "Effective static friction, mu-bar = (tau_max/p - mu_d) / (mu_s - mu_d): tau_max is the "
    "largest\nfriction force while the block is moved forwards slowly and no junction is "
    "pinned again.",
    {add_shape_options, add_format_options},
    measure_strength,
    [] {
      return join({strength_of("bell", 0.0).rows, quantities_of(std::vector<BlockStrength>{})});
    }};

}  // namespace rupture::tools
