// prepare: an interface with a prescribed prestress, at the moment its event is triggered.
#include <fmt/core.h>

#include <algorithm>

#include "cli/profile.hpp"
#include "run/output.hpp"
#include "run/rebuild.hpp"
#include "rupture/analysis/phi.hpp"
#include "rupture/dynamics/equilibrium.hpp"

namespace rupture::tools {
namespace {

void add_prestress_options(po::options_description& options) {
  auto add = options.add_options();
  add("tau-bar", in_rebuild(number_along_x("T")),
      "prestress (tau_0/p - mu_d)/(mu_s - mu_d) beyond the trigger region");
  add("sigma-bar", in_rebuild(number_along_x("S")->default_value("0")),
      "standard deviation of the junction forces over f_thres - f_slip");
  add("shape", in_rebuild(one_of("uniform|bell")->default_value("uniform")),
      "shape of the distribution of junction forces");
  add("x-trigger", in_rebuild(number("X", "m")->default_value(Prestress{}.x_trigger, "0.0225")),
      "blocks below this x are the trigger region");
  add("tau-bar-trigger", in_rebuild(number("T")->default_value(Prestress{}.tau_bar_trigger, "0.3")),
      "prestress of the trigger region");
  add("no-trigger", in_rebuild(), "leave the junctions of the trigger region pinned");
}

Prestress prestress_of(const Profile& profile, const Parameters& p,
                       const po::variables_map& values) {
  Prestress prestress;
  prestress.tau_bar = profile.along_x(p, "tau-bar");
  prestress.sigma_bar = profile.along_x(p, "sigma-bar");
  prestress.shape = shape_named(values["shape"].as<std::string>());
  prestress.x_trigger = non_negative(values, "x-trigger");
  prestress.tau_bar_trigger = values["tau-bar-trigger"].as<double>();
  if (values.count("no-trigger") > 0) prestress.trigger = Trigger::pinned;
  return prestress;
}

/// The parameters of a prepared interface: under a ceiling, with the driving point at rest.
Parameters default_parameters() {
  Parameters p;
  p.support = Support::ceiling;
  p.V = 0.0;
  return p;
}

/// How well the pinned blocks carry what was asked for, and how wide phi could be.
struct Prepared {
  double prestress = 0.0;          ///< tau/p beyond the trigger region
  double error = 0.0;              ///< relative, the largest of all pinned blocks
  double sigma_bar = 0.0;          ///< of the last block
  double largest_sigma_bar = 0.0;  ///< that is possible
  double F_T = 0.0;                ///< [N]
  std::int64_t blocks = 0, depinned = 0;
};

Prepared measured(const Parameters& p, const Prestress& prestress, const State& state) {
  const auto wanted = prescribed_friction(p, prestress);
  const auto blocks = block_forces(p, state);
  Prepared result;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (blocks[i].slipping > 0.0) {
      ++result.depinned;
      continue;
    }
    result.error = std::max(result.error, std::abs(blocks[i].tau() / wanted[i] - 1.0));
  }
  const auto& last = blocks.back();
  result.prestress = last.mean / last.f_thres * p.mu_s[p.Nx - 1];
  result.sigma_bar = last.sigma_bar();
  result.largest_sigma_bar = largest_sigma_bar(p, prestress);
  result.F_T = driving_force(p, state);
  result.blocks = static_cast<std::int64_t>(blocks.size());
  return result;
}

Quantities quantities_of(const Prepared& s) {
  return {
      {"prestress", "1", "tau/p beyond the trigger region", if_finite(s.prestress)},
      {"error", "1", "largest relative error of a pinned block's prestress", if_finite(s.error)},
      {"sigma_bar", "1", "width of phi beyond the trigger region", if_finite(s.sigma_bar)},
      {"largest_sigma_bar", "1", "largest possible width of phi", if_finite(s.largest_sigma_bar)},
      {"F_T", "N", "driving force, which balances the prestress", s.F_T},
      {"blocks", "1", "interface blocks", s.blocks},
      {"depinned", "1", "blocks whose junctions slip", s.depinned},
  };
}

std::string text_of(const Prepared& s, const Prestress& prestress) {
  return fmt::format(
      "tau/p = {:.6f} {}, within {:.1e} of the requested value\n"
      "sigma-bar = {:.6f}; the largest possible is {:.6f}\n"
      "F_T = {:.6f} N balances the prestress; {} of {} blocks are depinned\n",
      s.prestress,
      prestress.tau_bar.varies() ? "at the leading edge"
                                 : fmt::format("beyond x = {:g} m", prestress.x_trigger),
      s.error, s.sigma_bar, s.largest_sigma_bar, s.F_T, s.depinned, s.blocks);
}

int prepare(const Parsed& parsed) {
  Parameters p = default_parameters();
  const Profile profile(parsed);
  profile.apply(p);
  if (p.V != 0.0) {
    throw UsageError(
        "driving.V must be 0 (got {:g} m/s): a prepared interface is at rest; set it in restart",
        p.V);
  }
  validate(p);
  const Prestress prestress = prestress_of(profile, p, parsed.values);
  const OutputOptions output = output_options(parsed.values);
  po::variables_map values = parsed.values;
  values.insert({"tau-bar", {}});
  values.at("tau-bar").value() = along_x_text(prestress.tau_bar);
  values.at("sigma-bar").value() = along_x_text(prestress.sigma_bar);
  const auto command = with_options(rebuild_command("prepare", default_parameters(), p),
                                    add_prestress_options, values);

  check_output(output);
  const Checkpoint prepared = {p,
                               prepared_state(p, prestress),
                               {make_provenance("prepare", parsed.arguments, "", command.text())}};
  const Prepared result = measured(p, prestress, prepared.state);
  return write_and_report(FileKind::checkpoint, checkpoint_content(prepared), quantities_of(result),
                          text_of(result, prestress), output);
}

}  // namespace

constinit const Command prepare_command = {
    "prepare --tau-bar T -o OUT",
    "",
    "make an interface with a prescribed prestress, ready to break",
    "Writes a checkpoint of a slider at rest whose interface carries a prescribed prestress,\n"
    "with its trigger region just depinned; restart then runs the event. The normal force is\n"
    "the same on all interface blocks (slider.support = ceiling), and driving.V is 0.",
    {add_prestress_options, add_profile_option, add_checkpoint_options},
    prepare,
    [] { return with_files(quantities_of(Prepared{})); },
    UsesParameters::yes,
    {"tau-bar", "profile"}};

}  // namespace rupture::tools
