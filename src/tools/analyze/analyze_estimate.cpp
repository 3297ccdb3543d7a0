// analyze estimate: slow slip to expect from a checkpoint's parameters.
#include <fmt/core.h>

#include <numeric>

#include "analyze/analyze.hpp"
#include "analyze/checkpoint_command.hpp"
#include "cli/option_values.hpp"
#include "rupture/analysis/phi.hpp"
#include "rupture/analysis/slow_slip.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

constexpr int kMostBlocks = 100000;

/// The parameters with the seed of the random numbers that was asked for.
Parameters seeded(Parameters p, const po::variables_map& values) {
  if (values.count("seed") > 0) {
    set_parameter(p, "numerics.seed", values["seed"].as<std::string>());
  }
  return p;
}

std::optional<RelaxationEnsemble> ensemble(const Parameters& p, const po::variables_map& values) {
  const int blocks = values["ensemble"].as<int>();
  if (blocks < 2 || blocks > kMostBlocks) {
    throw UsageError(
        fmt::format("--ensemble {} makes no sense: give 2 to {}", blocks, kMostBlocks));
  }
  return relax_ensemble(p, blocks);
}

Json course_of(const std::optional<Relaxation>& relaxation) {
  if (!relaxation) return {};
  return {{"time_over_t_R", relaxation->course.time},
          {"slip_over_f_slip_per_k_ij", relaxation->course.slip}};
}

void add_relaxation(Report& report, const std::optional<RelaxationEnsemble>& relaxation) {
  const auto add = [&](const std::string& name, Mean RelaxationEnsemble::*field) {
    report.json[name] = relaxation ? Json(((*relaxation).*field).value) : Json();
    report.json[name + "_deviation"] = relaxation ? Json(((*relaxation).*field).deviation) : Json();
  };
  using E = RelaxationEnsemble;
  add("net_slip_over_f_slip_per_k_ij", &E::net_slip);
  add("slip_after_two_t_R_over_f_slip_per_k_ij", &E::slip_after_two);
  add("slip_at_return_over_f_slip_per_k_ij", &E::slip_at_return);
  add("duration_over_t_R", &E::duration);
  add("quiet_after_over_t_R", &E::quiet_time);
  if (!relaxation) {
    report.text += "relaxation of one block: goes on for ever\n";
    return;
  }
  const auto text = [](const Mean& m) {
    return fmt::format("{:.3f} +- {:.3f}", m.value, m.deviation);
  };
  report.text += fmt::format(
      "relaxation of one block (mean +- standard deviation, slip in f_slip/k_ij):\n"
      "  net slip {}, of which {} in 2 <t_R>: on average {:.2f} f_slip/k_ij per <t_R>\n"
      "  every junction has been pinned once after {} <t_R>, at slip {}\n"
      "  none slips any more after {} <t_R>\n",
      text(relaxation->net_slip), text(relaxation->slip_after_two),
      relaxation->slip_after_two.value / 2.0, text(relaxation->duration),
      text(relaxation->slip_at_return), text(relaxation->quiet_time));
}

}  // namespace

int analyze_estimate(int argc, const char* const* argv) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("ensemble", integer("N")->default_value(100),
      "blocks to relax, each with slipping times of its own");
  add("seed", seed(), "key of their random numbers; default: the checkpoint's");
  const auto [parsed, checkpoint] =
      read_checkpoint_command(argc, argv, "estimate",
                              "Slow slip by Eq. S1, v = 4.2 tau_slip / (k_i <t_R>), of the mean "
                              "and of each block; and the\n"
                              "relaxation of one block from which its coefficient comes.",
                              options);
  const Parameters& p = checkpoint.parameters;
  refuse_other_laws(p);
  const auto normal = normal_forces(p, checkpoint.state);
  std::vector<double> x, v;
  for (const double p_i : normal) {
    x.push_back(block_position(p, static_cast<std::int64_t>(x.size())));
    v.push_back(slow_slip_estimate(p, p_i));
  }
  const double p_mean =
      std::accumulate(normal.begin(), normal.end(), 0.0) / static_cast<double>(normal.size());
  const double v_mean = slow_slip_estimate(p, p_mean);
  Report report;
  report.json = {{"v_slow_slip", v_mean}, {"p", p_mean}, {"t_R", mean_slipping_time(p)}};
  report.text = "    x [m]      p [N]   v [mm/s]\n";
  for (std::size_t i = 0; i < x.size(); ++i) {
    report.text += fmt::format("{:9.4f}{:11.4f}{:11.4f}\n", x[i], normal[i], v[i] * 1e3);
  }
  report.text += fmt::format(
      "Eq. S1 at the mean normal force {:.5g} N, <t_R> = {:.5g} ms: {:.4f} "
      "mm/s\n",
      p_mean, mean_slipping_time(p) * 1e3, v_mean * 1e3);
  const Parameters with_seed = seeded(p, parsed.values);
  add_relaxation(report, ensemble(with_seed, parsed.values));
  report.json["relaxation"] = course_of(relax(with_seed, 0));
  report.json["block"] = {{"x", x}, {"p", normal}, {"v_slow_slip", v}};
  report.series = {column("x [m]", x), column("p [N]", normal), column("v_slow_slip [m/s]", v)};
  print(report, parsed.values);
  return kDone;
}

}  // namespace rupture::tools
