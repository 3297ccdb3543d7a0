#include "rupture/model/parameters.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/laws.hpp"
#include "rupture/model/user_text.hpp"

namespace rupture {
namespace {

using P = Parameters;

using Names = std::vector<std::string_view>;

/// The words for the values of an enumeration, in their order.
template <class Enum>
const Names kNames;
template <>
const Names kNames<SlippingTimes> = {"gaussian", "exponential"};
template <>
const Names kNames<NewForce> = {"zero", "f_slip"};
template <>
const Names kNames<Support> = {"foundation", "ceiling"};
template <>
const Names kNames<StiffnessFrom> = {"current", "initial"};
template <>
const Names kNames<WithoutContact> = {"follow", "break"};
template <>
const Names kNames<Repin> = {"as_is", "exact"};
template <>
const Names kNames<BulkSprings> = {"exact", "linearised"};

ParameterInfo positive(std::string_view name, std::string_view symbol, std::string_view unit,
                       ParameterMember member, double maximum, std::string_view help) {
  return {name, symbol, unit, member, 0.0, maximum, true, help};
}

ParameterInfo at_least(double minimum, std::string_view name, std::string_view symbol,
                       std::string_view unit, ParameterMember member, double maximum,
                       std::string_view help) {
  return {name, symbol, unit, member, minimum, maximum, false, help};
}

ParameterInfo choice(std::string_view name, std::string_view symbol, ParameterMember member,
                     std::string_view help) {
  return {name, symbol, "1", member, 0.0, 0.0, false, help};
}

ParameterInfo only_of(std::vector<Law> laws, ParameterInfo info) {
  info.laws = std::move(laws);
  return info;
}

ParameterInfo since(Since since, ParameterInfo info) {
  info.since = since;
  return info;
}

ParameterInfo kept_by_restart(ParameterInfo info) {
  info.restart = Restart::must_keep;
  return info;
}

template <class Enum>
const Names& names_of() {
  if constexpr (std::is_same_v<Enum, Law>) {
    return law_names();
  } else {
    return kNames<Enum>;
  }
}

template <class Number>
struct Scan {
  Number value;
  std::errc error;  ///< also if there is text behind the number

  bool is_number() const { return error == std::errc{} || is_too_large(); }
  bool is_too_large() const { return error == std::errc::result_out_of_range; }
};

template <class Number>
Scan<Number> scan(std::string_view text) {
  Scan<Number> found{};
  const auto* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, found.value);
  found.error = stop == end ? error : std::errc::invalid_argument;
  return found;
}

/// A whole number in any notation: 1000, 1e3 or 1000.0.
Scan<std::int64_t> scan_whole(std::string_view text) {
  const auto digits = scan<std::int64_t>(text);
  if (digits.is_number()) return digits;
  const auto number = scan<double>(text);
  const bool whole = number.error == std::errc{} && std::trunc(number.value) == number.value;
  if (!whole && !number.is_too_large()) return {0, std::errc::invalid_argument};
  if (!whole || std::abs(number.value) > 0x1p53) return {0, std::errc::result_out_of_range};
  return {static_cast<std::int64_t>(number.value), std::errc{}};
}

template <class Number>
Scan<Number> scan_as(std::string_view text) {
  if constexpr (std::is_integral_v<Number>) {
    return scan_whole(text);
  } else {
    return scan<Number>(text);
  }
}

template <class Number>
Number parse_number(const ParameterInfo& info, std::string_view text) {
  constexpr bool whole = std::is_integral_v<Number>;
  const Scan<Number> found = scan_as<Number>(in_unit(text, info.unit).value_or(""));
  if (!found.is_number()) {
    throw UsageError(fmt::format("{} = '{}' is not {} (unit {})", info.name, text,
                                 whole ? "a whole number" : "a number", units_taken(info.unit)));
  }
  const auto number = static_cast<double>(found.value);
  const bool too_small =
      info.minimum_excluded ? !(number > info.minimum) : !(number >= info.minimum);
  if (found.is_too_large() || too_small || !(number <= info.maximum)) {
    throw UsageError(fmt::format("{} = {} is out of range: give a value {} (unit {})", info.name,
                                 text, range_text(info), info.unit));
  }
  return found.value;
}

template <class Enum>
Enum parse_choice(const ParameterInfo& info, std::string_view text) {
  const auto& names = names_of<Enum>();
  const auto found = std::find(names.begin(), names.end(), text);
  if (found == names.end()) {
    throw UsageError(fmt::format("{} = '{}' is unknown: choose one of {}", info.name, text,
                                 fmt::join(names, ", ")));
  }
  return static_cast<Enum>(found - names.begin());
}

}  // namespace

const std::vector<ParameterInfo>& parameter_table() {
  static const std::vector<ParameterInfo> table = {
      kept_by_restart(positive("slider.L", "L", "m", &P::L, 1e3, "length of the slider along x")),
      kept_by_restart(positive("slider.H", "H", "m", &P::H, 1e3, "height of the slider along z")),
      positive("slider.B", "B", "m", &P::B, 1e3, "width of the slider along y"),
      kept_by_restart(
          at_least(3, "slider.Nx", "N_x", "1", &P::Nx, 65536, "number of blocks along x")),
      kept_by_restart(
          at_least(2, "slider.Nz", "N_z", "1", &P::Nz, 65536, "number of blocks along z")),
      positive("slider.M", "M", "kg", &P::M, 1e6, "mass of the slider"),
      positive("slider.E", "E", "Pa", &P::E, 1e13, "Young's modulus"),
      since(Since::later, choice("slider.springs", "-", &P::springs,
                                 "bulk springs: exact, or linearised for small displacements")),
      at_least(0, "slider.damping", "eta^2/(k m)", "1", &P::damping, 10,
               "bulk damping: eta = sqrt(damping k m) on every bond"),
      positive("slider.F_N", "F_N", "N", &P::F_N, 1e9,
               "normal load on the row opposite the support"),
      positive("slider.foundation", "k_f/k", "1", &P::foundation, 100,
               "modulus of the elastic foundation or ceiling, relative to the bulk springs"),
      since(Since::later,
            at_least(0, "slider.foundation_damping", "eta_f^2/(k_f m)", "1", &P::foundation_damping,
                     10, "dashpots beside it: eta_f = sqrt(foundation_damping k_f m)")),
      since(
          Since::schema_2,
          kept_by_restart(choice(
              "slider.support", "support", &P::support,
              "elastic foundation under the bottom row, or ceiling above the top row (prepare)"))),
      at_least(0, "driving.K", "K", "N/m", &P::K, 1e12, "modulus of the driving spring"),
      at_least(0, "driving.h", "h", "m", &P::h, 1e3, "height at which the driving spring acts"),
      at_least(-10, "driving.V", "V", "m/s", &P::V, 10, "speed of the driving point"),
      since(Since::schema_2,
            choice(
                "junctions.law", "-", &P::law,
                "interface law: reference; simplified (one spring per block, slow slip imposed); "
                "decaying (slipping force falls with time); distance (junctions slip a distance)")),
      kept_by_restart(
          at_least(1, "junctions.N_s", "N_s", "1", &P::N_s, 1e6, "junctions per interface block")),
      positive("junctions.mu_s", "mu_s", "1", &P::mu_s, 100, "threshold coefficient f_thres/f_N"),
      at_least(0, "junctions.mu_d", "mu_d", "1", &P::mu_d, 100, "slipping coefficient f_slip/f_N"),
      positive("junctions.kappa", "kappa", "N/m^2", &P::kappa, 1e20,
               "junction stiffness: k_ij = sqrt(kappa f_N)"),
      since(Since::later, choice("junctions.k_ij_from", "-", &P::k_ij_from,
                                 "normal force in k_ij: current p_i, or initial, F_N/N_x")),
      only_of({Law::reference, Law::simplified, Law::decaying},
              positive("junctions.t_R", "t_R", "s", &P::t_R, 1e3, "mean slipping time")),
      only_of({Law::reference, Law::decaying},
              at_least(0, "junctions.delta_t_R", "delta t_R", "s", &P::delta_t_R, 1e3,
                       "standard deviation of the slipping time (Gaussian only)")),
      only_of({Law::reference, Law::decaying},
              choice("junctions.slipping_times", "T(t_R)", &P::slipping_times,
                     "distribution of slipping times: folded Gaussian or exponential")),
      since(Since::later,
            only_of({Law::distance}, positive("junctions.d_R", "d_R", "m", &P::d_R, 1,
                                              "mean distance that a junction slips"))),
      since(Since::later,
            only_of({Law::distance},
                    at_least(0, "junctions.delta_d_R", "delta d_R", "m", &P::delta_d_R, 1,
                             "standard deviation of that distance"))),
      only_of({Law::reference, Law::distance},
              choice("junctions.f_new", "f_new", &P::f_new,
                     "force of a newly pinned junction; f_slip switches slow slip off")),
      since(Since::later,
            only_of({Law::reference, Law::decaying, Law::distance},
                    choice("junctions.without_contact", "-", &P::without_contact,
                           "pinned junctions of a block without contact follow it, or break"))),
      since(Since::schema_2,
            only_of({Law::decaying}, at_least(0, "junctions.mu_new", "mu_new", "1", &P::mu_new, 100,
                                              "coefficient f_new/f_N at the end of slipping"))),
      since(Since::later,
            only_of({Law::decaying}, choice("junctions.repin", "-", &P::repin,
                                            "junctions are pinned as they are, or at f_new"))),
      since(Since::schema_2,
            only_of({Law::simplified},
                    at_least(0, "junctions.v_slow", "v_slow", "m/s", &P::v_slow, 10,
                             "speed of the imposed slow slip; 0 switches it off"))),
      positive("numerics.dt", "dt", "s", &P::dt, 1.0, "time step"),
      at_least(0, "numerics.seed", "seed", "1", &P::seed, 9e15, "key of the random numbers"),
  };
  return table;
}

const ParameterInfo& find_parameter(std::string_view name) {
  for (const auto& info : parameter_table()) {
    if (info.name == name) return info;
  }
  std::vector<std::string_view> names;
  for (const auto& info : parameter_table()) names.push_back(info.name);
  throw UsageError(
      fmt::format("unknown parameter '{}': did you mean '{}'?", name, nearest(name, names)));
}

bool is_used(const ParameterInfo& info, Law law) {
  return info.laws.empty() || std::find(info.laws.begin(), info.laws.end(), law) != info.laws.end();
}

std::string used_text(const Parameters& parameters, const ParameterInfo& info) {
  return parameter_text(is_used(info, parameters.law) ? parameters : Parameters{}, info);
}

std::vector<std::string_view> choices(const ParameterInfo& info) {
  return std::visit(
      [](auto member) -> Names {
        using Value = std::remove_reference_t<decltype(std::declval<Parameters>().*member)>;
        if constexpr (std::is_enum_v<Value>) return names_of<Value>();
        return {};
      },
      info.member);
}

std::string range_text(const ParameterInfo& info) {
  return fmt::format("{} {:g} and at most {:g}", info.minimum_excluded ? "above" : "of at least",
                     info.minimum, info.maximum);
}

void set_parameter(Parameters& parameters, std::string_view name, std::string_view text) {
  const ParameterInfo& info = find_parameter(name);
  std::visit(
      [&](auto member) {
        using Value = std::remove_reference_t<decltype(parameters.*member)>;
        if constexpr (std::is_enum_v<Value>) {
          parameters.*member = parse_choice<Value>(info, text);
        } else {
          parameters.*member = parse_number<Value>(info, text);
        }
      },
      info.member);
}

std::string parameter_text(const Parameters& parameters, const ParameterInfo& info) {
  return std::visit(
      [&](auto member) -> std::string {
        const auto value = parameters.*member;
        if constexpr (std::is_enum_v<std::remove_const_t<decltype(value)>>) {
          return std::string(
              names_of<std::remove_const_t<decltype(value)>>()[static_cast<std::size_t>(value)]);
        } else {
          return fmt::format("{}", value);
        }
      },
      info.member);
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

namespace {

void validate_law(const Parameters& p) {
  if (p.mu_d > p.mu_s) {
    throw UsageError(fmt::format(
        "junctions.mu_d = {:g} exceeds junctions.mu_s = {:g}: a junction cannot slip at more than "
        "its strength",
        p.mu_d, p.mu_s));
  }
  const LawInfo& law = law_info(p.law);
  if (is_used(find_parameter("junctions.mu_new"), p.law) && p.mu_new > p.mu_d) {
    throw UsageError(
        fmt::format("junctions.mu_new = {:g} exceeds junctions.mu_d = {:g}: under the {} law the "
                    "slipping force falls",
                    p.mu_new, p.mu_d, law.name));
  }
  const ParameterInfo& f_new = find_parameter("junctions.f_new");
  if (!is_used(f_new, p.law) && p.f_new != NewForce::zero) {
    throw UsageError(
        fmt::format("junctions.f_new = f_slip belongs to the {} law: to switch slow slip off under "
                    "the {} law, set {}",
                    fmt::join(law_names(f_new.laws), " and the "), law.name, law.slow_slip_off));
  }
}

}  // namespace

void validate(const Parameters& p) {
  const double l = block_spacing(p);
  const double l_z = p.H / static_cast<double>(p.Nz - 1);
  if (std::abs(l - l_z) > 1e-9 * l) {
    throw UsageError(fmt::format(
        "the lattice must be square, but L/(Nx-1) = {:g} m and H/(Nz-1) = {:g} m: change slider.L, "
        "slider.H, slider.Nx or slider.Nz (for instance slider.H = {:.9g})",
        l, l_z, l * static_cast<double>(p.Nz - 1)));
  }
  const double row = p.h / l;
  if (!(std::abs(row - std::round(row)) <= 1e-6 && std::round(row) < static_cast<double>(p.Nz))) {
    throw UsageError(fmt::format(
        "driving.h = {:g} m is on no row of blocks: give a multiple of the spacing {:g} m below "
        "slider.H",
        p.h, l));
  }
  validate_law(p);
  if (const double limit = stable_time_step(p); !(p.dt <= limit)) {
    throw UsageError(fmt::format(
        "numerics.dt = {:g} s is unstable: the limit for this lattice is {:.4g} s", p.dt, limit));
  }
}

}  // namespace rupture
