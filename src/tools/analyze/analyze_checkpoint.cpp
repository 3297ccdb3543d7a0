// analyze stress, phi: what a checkpoint says of the interface.
#include <fmt/core.h>

#include <numeric>

#include "analyze/analyze.hpp"
#include "analyze/checkpoint_command.hpp"
#include "cli/option_values.hpp"
#include "rupture/analysis/phi.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

/// Centroid of the normal forces, measured from the middle of the interface [m].
double centroid(const std::vector<double>& x, const std::vector<double>& p, double L) {
  double moment = 0.0, total = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    moment += p[i] * (x[i] - 0.5 * L);
    total += p[i];
  }
  return total > 0.0 ? moment / total : 0.0;
}

}  // namespace

int analyze_stress(int argc, const char* const* argv) {
  po::options_description options("Options");
  const auto [parsed, checkpoint] = read_checkpoint_command(
      argc, argv, "stress",
      "Normal force p and friction force tau on each interface block; tau > 0 where friction\n"
      "pushes the block towards -x.",
      options);
  const Parameters& p = checkpoint.parameters;
  const auto normal = normal_forces(p, checkpoint.state);
  const auto friction = friction_forces(p, checkpoint.state);
  std::vector<double> x;
  for (std::size_t i = 0; i < normal.size(); ++i) {
    x.push_back(block_position(p, static_cast<std::int64_t>(i)));
  }
  const double t = time(p, checkpoint.state);
  const double F_T = driving_force(p, checkpoint.state);
  const double x_p = centroid(x, normal, p.L);
  Report report;
  report.json = {{"time", t},  {"x", x},       {"p", normal},      {"tau", friction},
                 {"F_T", F_T}, {"F_N", p.F_N}, {"p_centroid", x_p}};
  report.series = {column("x [m]", x), column("p [N]", normal), column("tau [N]", friction)};
  report.text = "    x [m]      p [N]    tau [N]   tau/p\n";
  for (std::size_t i = 0; i < x.size(); ++i) {
    report.text +=
        fmt::format("{:9.4f}{:11.4f}{:11.4f}{:>8}\n", x[i], normal[i], friction[i],
                    normal[i] > 0.0 ? fmt::format("{:.4f}", friction[i] / normal[i]) : "-");
  }
  report.text += fmt::format(
      "t = {:.7g} s, F_T = {:.6g} N, sum p = {:.9g} N, sum tau = {:.6g} N, centroid of p at {:.4g} "
      "mm from the middle\n",
      t, F_T, std::accumulate(normal.begin(), normal.end(), 0.0),
      std::accumulate(friction.begin(), friction.end(), 0.0), x_p * 1e3);
  print(report, parsed.values);
  return kDone;
}

int analyze_phi(int argc, const char* const* argv) {
  po::options_description options("Options");
  options.add_options()("bins", integer("N")->default_value(40),
                        "bins of the histograms, from -f_thres to f_thres");
  const auto [parsed, checkpoint] = read_checkpoint_command(
      argc, argv, "phi",
      "Forces in the junctions of each block: mean, standard deviation, histogram.", options);
  const int bins = parsed.values["bins"].as<int>();
  constexpr int most_bins = 100000;
  if (bins < 1 || bins > most_bins) {
    throw UsageError(fmt::format("--bins {} makes no sense: give 1 to {}", bins, most_bins));
  }
  refuse_single_springs(checkpoint.parameters);
  const auto blocks = block_forces(checkpoint.parameters, checkpoint.state);
  Report report;
  std::vector<double> x, mean, sigma, sigma_bar, slipping, f_thres, f_slip;
  Json histograms = Json::array();
  report.text = "    x [m]   mean/f_thres   sigma-bar   slipping\n";
  for (const auto& block : blocks) {
    const bool pressed = block.f_thres > 0.0;
    x.push_back(block.x);
    mean.push_back(block.mean);
    sigma.push_back(block.sigma);
    sigma_bar.push_back(pressed ? block.sigma_bar() : 0.0);
    slipping.push_back(block.slipping);
    f_thres.push_back(block.f_thres);
    f_slip.push_back(block.f_slip);
    histograms.push_back(pressed ? Json(histogram(block, bins)) : Json());
    report.text += fmt::format("{:9.4f}{:>15}{:12.4f}{:11.2f}\n", block.x,
                               pressed ? fmt::format("{:.4f}", block.mean / block.f_thres) : "-",
                               sigma_bar.back(), block.slipping);
  }
  report.json = {{"x", x},
                 {"mean", mean},
                 {"sigma", sigma},
                 {"sigma_bar", sigma_bar},
                 {"slipping", slipping},
                 {"f_thres", f_thres},
                 {"f_slip", f_slip},
                 {"histogram", histograms}};
  report.series = {column("x [m]", x),           column("mean [N]", mean),
                   column("sigma [N]", sigma),   column("sigma_bar", sigma_bar),
                   column("slipping", slipping), column("f_thres [N]", f_thres)};
  print(report, parsed.values);
  return kDone;
}

}  // namespace rupture::tools
