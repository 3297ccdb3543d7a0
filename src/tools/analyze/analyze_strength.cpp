// analyze strength: how much friction a distribution of junction forces can bear.
#include <fmt/core.h>

#include "analyze/analyze.hpp"
#include "analyze/inputs.hpp"
#include "cli/option_values.hpp"
#include "rupture/analysis/strength.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

double friction(const Parameters& p, double mu_bar) {
  return p.mu_d + mu_bar * (p.mu_s - p.mu_d);
}

/// mu-bar of a shape of phi, and friction with the default mu_s and mu_d.
struct ShapeStrength {
  std::string shape;
  double sigma_bar = 0, mu_bar_eff = 0, mu_eff = 0;
};

Quantities quantities_of(const ShapeStrength& s) {
  return {
      {"shape", "", "uniform or bell (of a shape)", s.shape},
      {"sigma_bar", "1", "standard deviation over f_thres - f_slip (of a shape)", s.sigma_bar,
       Csv::yes},
      {"mu_bar_eff", "1",
       "effective static friction, (tau_max/p - mu_d)/(mu_s - mu_d) (of a shape)", s.mu_bar_eff,
       Csv::yes},
      {"mu_eff", "1", "tau_max/p at the default mu_s and mu_d (of a shape)", s.mu_eff, Csv::yes},
  };
}

int report_on_shape(const po::variables_map& values) {
  if (values.count("shape") == 0 || values.count("sigma-bar") == 0) {
    throw UsageError("--shape and --sigma-bar need each other: give both, or a checkpoint instead");
  }
  const auto shape = values["shape"].as<std::string>();
  const double sigma_bar = non_negative(values, "sigma-bar");
  const double mu_bar = effective_strength(shape_named(shape), sigma_bar);
  const double mu = friction(Parameters{}, mu_bar);
  const std::string text = fmt::format(
      "{} phi, sigma-bar = {:g}: effective static friction mu-bar = {:.7f}, {:.7f} at mu_s = {:g} "
      "and mu_d = {:g}\n",
      shape, sigma_bar, mu_bar, mu, Parameters{}.mu_s, Parameters{}.mu_d);
  return print(quantities_of(ShapeStrength{shape, sigma_bar, mu_bar, mu}), text, values);
}

Quantities quantities_of(const std::vector<BlockStrength>& blocks) {
  using B = BlockStrength;
  const auto mu_eff = [](const B& b) {
    return b.p > 0.0 ? std::optional(b.tau_max / b.p) : std::nullopt;
  };
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

int report(const Parsed& parsed) {
  const auto& values = parsed.values;
  const bool of_shape = values.count("shape") > 0 || values.count("sigma-bar") > 0;
  if (of_shape && values.count("checkpoint") > 0) {
    throw UsageError("a checkpoint has its own phi: give a checkpoint or --shape, not both");
  }
  if (of_shape) return report_on_shape(values);
  const Checkpoint checkpoint = checkpoint_of(parsed, "a checkpoint, or give --shape");
  refuse_single_springs(checkpoint.parameters);
  const auto blocks = block_strengths(checkpoint.parameters, checkpoint.state);
  return print(quantities_of(blocks), "", values);
}

}  // namespace

constinit const Command strength_command = {
    "analyze strength CHECKPOINT | --shape uniform|bell --sigma-bar S",
    "checkpoint",
    "effective static friction of a shape of phi or of a checkpoint's blocks",
    "Effective static friction, mu-bar = (tau_max/p - mu_d) / (mu_s - mu_d): tau_max is the "
    "largest\nfriction force while the block is moved forwards slowly and no junction is "
    "pinned again.",
    {add_shape_options, add_format_options},
    report,
    [] {
      return join({quantities_of(ShapeStrength{}), quantities_of(std::vector<BlockStrength>{})});
    }};

}  // namespace rupture::tools
