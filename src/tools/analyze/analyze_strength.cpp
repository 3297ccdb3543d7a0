// analyze strength: how much friction a distribution of junction forces can bear.
#include <fmt/core.h>

#include "analyze/analyze.hpp"
#include "cli/option_values.hpp"
#include "rupture/analysis/strength.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

double friction(const Parameters& p, double mu_bar) {
  return p.mu_d + mu_bar * (p.mu_s - p.mu_d);
}

Report report_on_shape(const po::variables_map& values) {
  if (values.count("shape") == 0 || values.count("sigma-bar") == 0) {
    throw UsageError(
        "--shape and --sigma-bar belong together: give both, or name a checkpoint instead");
  }
  const auto shape = values["shape"].as<std::string>();
  const double sigma_bar = non_negative(values, "sigma-bar");
  const double mu_bar = effective_strength(shape_named(shape), sigma_bar);
  const double mu = friction(Parameters{}, mu_bar);
  Report report;
  report.json = {
      {"shape", shape}, {"sigma_bar", sigma_bar}, {"mu_bar_eff", mu_bar}, {"mu_eff", mu}};
  report.series = {{"sigma_bar", {sigma_bar}}, {"mu_bar_eff", {mu_bar}}, {"mu_eff", {mu}}};
  report.text = fmt::format(
      "{} phi, sigma-bar = {:g}: effective static friction mu-bar = {:.7f}, {:.7f} at mu_s = {:g} "
      "and mu_d = {:g}\n",
      shape, sigma_bar, mu_bar, mu, Parameters{}.mu_s, Parameters{}.mu_d);
  return report;
}

Report report_on_blocks(const Checkpoint& checkpoint) {
  const Parameters& p = checkpoint.parameters;
  refuse_single_springs(p);
  std::vector<std::optional<double>> sigma_bar, tau_bar_0, mu_bar, mu;
  std::vector<double> x, slipping;
  Report report;
  report.text = "    x [m]   slipping   sigma-bar   tau-bar_0      mu-bar   tau_max/p\n";
  for (const BlockStrength& block : block_strengths(p, checkpoint.state)) {
    x.push_back(block.x);
    slipping.push_back(block.slipping);
    sigma_bar.push_back(block.sigma_bar);
    tau_bar_0.push_back(block.tau_bar_0);
    mu_bar.push_back(block.mu_bar_eff);
    mu.push_back(block.p > 0.0 ? std::optional(block.tau_max / block.p) : std::nullopt);
    report.text += fmt::format("{:9.4f}{:11.2f}{:>12}{:>12}{:>12}{:>12}\n", block.x, block.slipping,
                               text_of(sigma_bar.back()), text_of(tau_bar_0.back()),
                               text_of(mu_bar.back()), text_of(mu.back()));
  }
  report.json = {{"x", x},
                 {"slipping", slipping},
                 {"sigma_bar", json_of(sigma_bar)},
                 {"tau_bar_0", json_of(tau_bar_0)},
                 {"mu_bar_eff", json_of(mu_bar)},
                 {"mu_eff", json_of(mu)}};
  report.series = {column("x [m]", x),       column("slipping", slipping), {"sigma_bar", sigma_bar},
                   {"tau_bar_0", tau_bar_0}, {"mu_bar_eff", mu_bar},       {"mu_eff", mu}};
  return report;
}

Parsed parse_arguments(int argc, const char* const* argv) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("shape", one_of("uniform|bell"), "shape of phi, instead of a checkpoint");
  add("sigma-bar", number("S"), "its standard deviation over f_thres - f_slip");
  add_format_options(options);
  return parse(
      argc, argv,
      {"analyze strength",
       "analyze strength CHECKPOINT | --shape uniform|bell --sigma-bar S [options]",
       "Effective static friction, mu-bar = (tau_max/p - mu_d) / (mu_s - mu_d): tau_max is the "
       "largest\nfriction force while the block is moved forwards slowly and no junction is pinned "
       "again."},
      options, "checkpoint", UsesParameters::no);
}

}  // namespace

int analyze_strength(int argc, const char* const* argv) {
  const Parsed parsed = parse_arguments(argc, argv);
  const auto& values = parsed.values;
  const bool of_shape = values.count("shape") > 0 || values.count("sigma-bar") > 0;
  if (of_shape && values.count("checkpoint") > 0) {
    throw UsageError("a checkpoint has forces of its own: give it or --shape, not both");
  }
  if (of_shape) {
    print(report_on_shape(values), values);
  } else {
    const auto path = single_input(values, "checkpoint", "a checkpoint, or give --shape");
    print(report_on_blocks(read_checkpoint(path)), values);
  }
  return kDone;
}

}  // namespace rupture::tools
