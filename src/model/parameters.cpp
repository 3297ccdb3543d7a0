#include "rupture/model/parameters.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/laws.hpp"
#include "rupture/model/user_text.hpp"

namespace rupture {
namespace {

using P = Parameters;

Valid above(double minimum, double maximum) {
  return {minimum, maximum, true};
}
Valid at_least(double minimum, double maximum) {
  return {minimum, maximum};
}
Valid one_of(std::vector<std::string_view> words) {
  return {.words = std::move(words)};
}
std::vector<Law> only(std::initializer_list<Law> laws) {
  return laws;
}
constexpr std::initializer_list<Law> all = {};

/// Calls work(info, member) for all rows that may vary along x.
void for_each_along_x(const Parameters& p, const auto& work) {
  for (const ParameterInfo& info : parameter_table()) {
    std::visit(
        [&](auto member) {
          if constexpr (requires { (p.*member).blocks(); }) work(info, member);
        },
        info.member);
  }
}

/// " at x = 0.07 m" for a property that varies.
std::string place_text(const Parameters& p, std::int64_t i, bool varies) {
  return varies ? fmt::format(" at x = {:g} m", block_position(p, i)) : "";
}

void validate_coefficients(const Parameters& p) {
  const LawInfo& law = law_info(p.law);
  const ParameterInfo& f_new = find_parameter("junctions.f_new");
  const bool has_f_new = is_used(f_new, p.law);
  const bool has_mu_new = is_used(find_parameter("junctions.mu_new"), p.law);
  for (std::int64_t i = 0; i < p.Nx; ++i) {
    if (p.mu_d[i] > p.mu_s[i]) {
      throw UsageError(
          "junctions.mu_d = {:g} exceeds junctions.mu_s = {:g}{}: a slipping junction "
          "cannot carry more than its strength",
          p.mu_d[i], p.mu_s[i], place_text(p, i, p.mu_d.varies() || p.mu_s.varies()));
    }
    if (has_mu_new && p.mu_new[i] > p.mu_d[i]) {
      throw UsageError(
          "junctions.mu_new = {:g} exceeds junctions.mu_d = {:g}{}: under the {} law the "
          "slipping force falls",
          p.mu_new[i], p.mu_d[i], place_text(p, i, p.mu_new.varies() || p.mu_d.varies()), law.name);
    }
    if (!has_f_new && p.f_new[i] != NewForce::zero) {
      throw UsageError(
          "junctions.f_new = f_slip is only for the {} law: to switch slow slip off "
          "under the {} law, set {}",
          alternatives(law_names(f_new.laws)), law.name, law.slow_slip_off);
    }
    if (p.load[i] == 0.0 && p.k_ij_from == StiffnessFrom::initial &&
        p.support == Support::foundation) {
      throw UsageError(
          "slider.load is 0{}: with junctions.k_ij_from = initial, its junctions would have no "
          "stiffness; set current",
          place_text(p, i, true));
    }
  }
}

}  // namespace

const std::vector<ParameterInfo>& parameter_table() {
  using enum Law;
  using enum Since;
  using enum Restart;
  static const std::vector<ParameterInfo> table = {
      {"slider.L", "L", "m", &P::L, above(0, 1e3), "length of the slider along x", all, original,
       must_keep},
      {"slider.H", "H", "m", &P::H, above(0, 1e3), "height of the slider along z", all, original,
       must_keep},
      {"slider.B", "B", "m", &P::B, above(0, 1e3), "width of the slider along y"},
      {"slider.Nx", "N_x", "1", &P::Nx, at_least(3, 65536), "number of blocks along x", all,
       original, must_keep},
      {"slider.Nz", "N_z", "1", &P::Nz, at_least(2, 65536), "number of blocks along z", all,
       original, must_keep},
      {"slider.M", "M", "kg", &P::M, above(0, 1e6), "mass of the slider"},
      {"slider.E", "E", "Pa", &P::E, above(0, 1e13), "Young's modulus"},
      {"slider.springs", "-", "1", &P::springs, one_of({"exact", "linearised"}),
       "bulk springs: exact, or linearised for small displacements", all, later},
      {"slider.edge_springs", "-", "1", &P::edge_springs, one_of({"full", "half"}),
       "springs along the faces: as stiff as inner springs, or half as stiff", all, later},
      {"slider.damping", "eta^2/(k m)", "1", &P::damping, at_least(0, 10),
       "bulk damping: eta = sqrt(damping k m) on every bond"},
      {"slider.damping_along", "-", "1", &P::damping_along, one_of({"velocity", "spring"}),
       "bulk dampers resist the relative velocity, or its part along the spring", all, later},
      {"slider.F_N", "F_N", "N", &P::F_N, above(0, 1e9),
       "normal load on the row opposite the support"},
      {"slider.load", "-", "1", &P::load, at_least(0, 1e3),
       "weight of that load on each block, where it varies along x; scaled to 1 on average", all,
       later},
      {"slider.foundation", "k_f/k", "1", &P::foundation, above(0, 100),
       "modulus of the elastic foundation or ceiling, relative to the bulk springs"},
      {"slider.foundation_damping", "eta_f^2/(k_f m)", "1", &P::foundation_damping, at_least(0, 10),
       "damping of the elastic foundation: eta_f = sqrt(foundation_damping k_f m)", all, later},
      {"slider.support", "support", "1", &P::support, one_of({"foundation", "ceiling"}),
       "elastic foundation under the bottom row, or ceiling above the top row (prepare)", all,
       original, must_keep},
      {"driving.K", "K", "N/m", &P::K, at_least(0, 1e12), "modulus of the driving spring"},
      {"driving.h", "h", "m", &P::h, at_least(0, 1e3), "height at which the driving spring acts"},
      {"driving.V", "V", "m/s", &P::V, at_least(-10, 10), "speed of the driving point"},
      {"junctions.law", "-", "1", &P::law, one_of(law_names()),
       "interface law: reference; simplified (one spring per block, slow slip imposed); "
       "decaying (slipping force falls with time); distance (junctions slip a distance)",
       all},
      {"junctions.N_s", "N_s", "1", &P::N_s, at_least(1, 1e6), "junctions per interface block", all,
       original, must_keep},
      {"junctions.mu_s", "mu_s", "1", &P::mu_s, above(0, 100), "threshold coefficient f_thres/f_N"},
      {"junctions.mu_d", "mu_d", "1", &P::mu_d, at_least(0, 100),
       "slipping coefficient f_slip/f_N"},
      {"junctions.kappa", "kappa", "N/m^2", &P::kappa, above(0, 1e20),
       "junction stiffness: k_ij = sqrt(kappa f_N)"},
      {"junctions.k_ij_from", "-", "1", &P::k_ij_from, one_of({"current", "initial"}),
       "normal force in k_ij: current p_i, or initial, F_N/N_x times slider.load", all, later},
      {"junctions.t_R", "t_R", "s", &P::t_R, above(0, 1e3), "mean slipping time",
       only({reference, simplified, decaying})},
      {"junctions.delta_t_R", "delta t_R", "s", &P::delta_t_R, at_least(0, 1e3),
       "standard deviation of the slipping time (Gaussian only)", only({reference, decaying})},
      {"junctions.slipping_times", "T(t_R)", "1", &P::slipping_times,
       one_of({"gaussian", "exponential"}),
       "distribution of slipping times: folded Gaussian or exponential",
       only({reference, decaying})},
      {"junctions.d_R", "d_R", "m", &P::d_R, above(0, 1), "mean distance that a junction slips",
       only({distance}), later},
      {"junctions.delta_d_R", "delta d_R", "m", &P::delta_d_R, at_least(0, 1),
       "standard deviation of the slipping distance", only({distance}), later},
      {"junctions.f_new", "f_new", "1", &P::f_new, one_of({"zero", "f_slip"}),
       "force of a newly pinned junction; f_slip switches slow slip off",
       only({reference, distance})},
      {"junctions.without_contact", "-", "1", &P::without_contact, one_of({"follow", "break"}),
       "whether pinned junctions of a block without contact follow it or break",
       only({reference, decaying, distance}), later},
      {"junctions.mu_new", "mu_new", "1", &P::mu_new, at_least(0, 100),
       "coefficient f_new/f_N at the end of slipping", only({decaying})},
      {"junctions.repin", "-", "1", &P::repin, one_of({"as_is", "exact"}),
       "junctions keep their force when they are pinned, or get f_new", only({decaying}), later},
      {"junctions.v_slow", "v_slow", "m/s", &P::v_slow, at_least(0, 10),
       "speed of the imposed slow slip; 0 switches it off", only({simplified})},
      {"numerics.dt", "dt", "s", &P::dt, above(0, 1.0), "time step"},
      {"numerics.seed", "seed", "1", &P::seed, at_least(0, 9e15), "seed of the random numbers"},
  };
  return table;
}

const ParameterInfo& find_parameter(std::string_view name) {
  const auto found = std::ranges::find(parameter_table(), name, &ParameterInfo::name);
  if (found != parameter_table().end()) return *found;
  std::vector<std::string_view> names;
  for (const auto& info : parameter_table()) names.push_back(info.name);
  throw UsageError(unknown_text("parameter", name, names, "rupture parameters"));
}

bool is_used(const ParameterInfo& info, Law law) {
  return info.laws.empty() || std::ranges::count(info.laws, law) > 0;
}

std::string used_text(const Parameters& parameters, const ParameterInfo& info) {
  return parameter_text(is_used(info, parameters.law) ? parameters : Parameters{}, info);
}

std::string range_text(const ParameterInfo& info) {
  const auto& [minimum, maximum, minimum_excluded, words] = info.valid;
  return minimum_excluded ? fmt::format("above {:g} and at most {:g}", minimum, maximum)
                          : fmt::format("{:g} to {:g}", minimum, maximum);
}

bool may_vary_along_x(const ParameterInfo& info) {
  return std::holds_alternative<AlongX<double> Parameters::*>(info.member) ||
         std::holds_alternative<AlongX<NewForce> Parameters::*>(info.member);
}

Parameters at_block(const Parameters& p, std::int64_t i) {
  Parameters block = p;
  for_each_along_x(p, [&](const ParameterInfo&, auto member) { block.*member = (p.*member)[i]; });
  return block;
}

std::vector<const ParameterInfo*> varying(const Parameters& p) {
  std::vector<const ParameterInfo*> found;
  for_each_along_x(p, [&](const ParameterInfo& info, auto member) {
    if ((p.*member).varies()) found.push_back(&info);
  });
  return found;
}

std::vector<const ParameterInfo*> differing(const Parameters& a, const Parameters& b) {
  std::vector<const ParameterInfo*> found;
  for (const auto& info : parameter_table()) {
    if (std::visit([&](auto member) { return a.*member != b.*member; }, info.member)) {
      found.push_back(&info);
    }
  }
  return found;
}

void validate_lengths(const Parameters& p) {
  for_each_along_x(p, [&](const ParameterInfo& info, auto member) {
    const auto& blocks = (p.*member).blocks();
    if (blocks.empty() || std::ssize(blocks) == p.Nx) return;
    throw UsageError("{} has values for {} blocks, but slider.Nx = {}", info.name, blocks.size(),
                     p.Nx);
  });
}

void validate(const Parameters& p) {
  const double l = block_spacing(p);
  const double l_z = p.H / static_cast<double>(p.Nz - 1);
  if (std::abs(l - l_z) > 1e-9 * l) {
    throw UsageError(
        "the lattice must be square, but L/(Nx-1) = {:g} m and H/(Nz-1) = {:g} m: change slider.L, "
        "slider.H, slider.Nx or slider.Nz (for instance slider.H = {:.9g})",
        l, l_z, l * static_cast<double>(p.Nz - 1));
  }
  const double row = p.h / l;
  if (!(std::abs(row - std::round(row)) <= 1e-6 && std::round(row) < static_cast<double>(p.Nz))) {
    throw UsageError(
        "driving.h = {:g} m is not the height of a row of blocks: give a multiple of "
        "the spacing {:g} m below slider.H",
        p.h, l);
  }
  validate_lengths(p);
  validate_coefficients(p);
  if (const double limit = stable_time_step(p); !(p.dt <= limit)) {
    throw UsageError("numerics.dt = {:g} s is unstable: the limit for this lattice is {:.4g} s",
                     p.dt, limit);
  }
}

}  // namespace rupture
