// The table of parameters: every error sentence, text that reads back, what makes sense together,
// and quantities that follow.
#include "rupture/model/parameters.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <string>

#include "rupture/model/derived.hpp"
#include "rupture/model/user_text.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

std::string refusal(std::string_view name, std::string_view text) {
  Parameters p;
  const std::string message = message_of<UsageError>([&] { set_parameter(p, name, text); });
  const bool refused = !message.starts_with('(');
  EXPECT_TRUE(!refused || p == Parameters{}) << name << " = " << text << " has changed something";
  return message;
}

std::string refusal(const Parameters& p) {
  return message_of<UsageError>([&] { validate(p); });
}

const std::string kAccepted = "(nothing was thrown)";

bool is_whole(const ParameterInfo& info) {
  return std::holds_alternative<std::int64_t Parameters::*>(info.member);
}

TEST(ParameterTable, names_each_parameter_once_and_completely) {
  std::set<std::string_view> names;
  for (const auto& info : parameter_table()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_NE(info.name.find('.'), std::string_view::npos) << info.name;
    EXPECT_FALSE(info.symbol.empty() || info.unit.empty() || info.help.empty()) << info.name;
  }
}

TEST(ParameterTable, accepts_its_own_defaults) {
  for (const auto& info : parameter_table()) {
    EXPECT_EQ(refusal(info.name, parameter_text(Parameters{}, info)), kAccepted);
  }
  EXPECT_EQ(refusal(Parameters{}), kAccepted);
}

TEST(ParameterTable, sets_the_member_that_the_row_names_and_no_other) {
  const Parameters defaults;
  for (const auto& info : parameter_table()) {
    if (info.name == "slider.load") continue;  // 1 wherever it does not vary
    Parameters changed;
    std::string text = is_whole(info) ? "7" : "0.7";  // valid in every row, and no default
    if (!info.valid.words.empty()) text = info.valid.words.back();
    set_parameter(changed, info.name, text);
    for (const auto& row : parameter_table()) {
      EXPECT_EQ(parameter_text(changed, row) == parameter_text(defaults, row),
                row.name != info.name)
          << row.name;
    }
    EXPECT_NE(changed, defaults);
  }
}

TEST(ParameterText, reads_back_to_the_same_bits) {
  Parameters p;
  p.L = 0.1 + 0.2;
  p.H = std::nextafter(1.0, 2.0);
  p.E = 1e13 / 3.0;
  p.V = -std::numeric_limits<double>::denorm_min();
  p.K = 0.0;
  p.Nx = 65536;
  p.seed = 9000000000000000;
  p.slipping_times = SlippingTimes::exponential;
  p.f_new = NewForce::f_slip;
  p.law = Law::simplified;
  p.v_slow = 1.0 / 3.0;
  p.support = Support::ceiling;
  Parameters back;
  for (const auto& info : parameter_table()) {
    set_parameter(back, info.name, parameter_text(p, info));
  }
  EXPECT_EQ(back, p);
}

TEST(SetParameter, takes_multiples_of_its_unit_and_whole_numbers_in_any_notation) {
  const std::vector<std::array<const char*, 3>> rows = {
      {"numerics.dt", "0.1us", "1e-07"},
      {"slider.L", "150 mm", "0.15"},
      {"slider.L", "+0.15", "0.15"},
      {"slider.M", "80g", "0.08"},
      {"slider.Nx", "1e3", "1000"},
      {"slider.Nx", "57.0", "57"},
      {"slider.Nx", "1.5e2", "150"},
      {"numerics.dt", "3e2  ns", "3e-07"},
      {"numerics.dt", "3E+2ns", "3e-07"},
      {"numerics.dt", "0.3µs", "3e-07"},  // U+00B5
      {"numerics.dt", "0.3μs", "3e-07"},  // U+03BC
      {"slider.E", "3GPa", "3000000000"},
      {"driving.K", "4MN/m", "4000000"},
      {"slider.F_N", "1.92kN", "1920"},
      {"driving.V", "0.4mm/s", "0.0004"},
      {"numerics.seed", "8999999999999999", "8999999999999999"},
      {"numerics.seed", "9e15", "9000000000000000"}};
  for (const auto& [name, text, value] : rows) {
    Parameters p;
    set_parameter(p, name, text);
    EXPECT_EQ(parameter_text(p, find_parameter(name)), value);
  }
  EXPECT_EQ(in_unit("1e-9223372036854775808mm", "m"), "1e-9223372036854775808") << "as good as 0";
}

struct Refusal {
  std::string name;
  std::vector<std::string> texts;
  std::string sentence;  ///< with "..." for the text
};

TEST(SetParameter, says_what_it_does_not_take) {
  const std::vector<Refusal> all = {
      {"slider.foo", {"1"}, "unknown parameter 'slider.foo'; see rupture parameters"},
      {"slider.mu_s", {"1"}, "unknown parameter 'slider.mu_s': did you mean 'junctions.mu_s'?"},
      {"mu_d", {"1"}, "unknown parameter 'mu_d': did you mean 'junctions.mu_d'?"},
      {"numerics.dt ", {"1"}, "unknown parameter 'numerics.dt ': did you mean 'numerics.dt'?"},
      {"slider.L",
       {"", "abc", "1e", "+-1", "0.14kg", "0.14Mm", " 1", "1 ", "0x10", "1,5"},
       "slider.L = '...' is not a number (unit m, mm, um or nm)"},
      {"slider.L", {"0", "1001", "2e6mm"}, "slider.L must be above 0 and at most 1000 m (got ...)"},
      {"junctions.t_R",
       {"10Ms", "10ks", "10xs", "10 ms ", "10msms", "ms", "ten"},
       "junctions.t_R = '...' is not a number (unit s, ms, us or ns)"},
      {"slider.M",
       {"80kgg", "80t"},
       "slider.M = '...' is not a number (unit kg, g, Gg, Mg, mg, ug or ng)"},
      {"v", {"1"}, "unknown parameter 'v': did you mean 'driving.V'?"},
      {"slider.nx", {"1"}, "unknown parameter 'slider.nx': did you mean 'slider.Nx'?"},
      {"slider.Nx",
       {"57m", "57.5", "1.5", "1e-1", "5e1x", "nan", "ten", ""},
       "slider.Nx = '...' is not a whole number"},
      {"slider.Nx",  // the last one has more than 64 bits
       {"2", "1e9", "-1e3", "1e300", "1e400", "2.0", "9999999999999999999999"},
       "slider.Nx must be from 3 to 65536 (got ...)"},
      {"junctions.slipping_times",
       {"normal"},
       "junctions.slipping_times must be gaussian or exponential (got '...')"},
      {"junctions.f_new", {"Zero"}, "junctions.f_new must be zero or f_slip (got '...')"},
  };
  for (const Refusal& row : all) {
    for (const std::string& text : row.texts) {
      std::string sentence = row.sentence;
      const auto dots = sentence.find("...");
      if (dots != std::string::npos) sentence.replace(dots, 3, text);
      EXPECT_EQ(refusal(row.name, text), sentence);
    }
  }
}

TEST(SetParameter, holds_every_row_to_its_limits_and_refuses_what_is_not_finite) {
  for (const auto& info : parameter_table()) {
    for (const char* text : {"nan", "inf", "-inf", "-1e400", "1e400", "-1e300"}) {
      EXPECT_NE(refusal(info.name, text), kAccepted) << info.name << " = " << text;
    }
    for (const auto word : info.valid.words) EXPECT_EQ(refusal(info.name, word), kAccepted);
    if (!info.valid.words.empty()) continue;
    const auto is_accepted = [&](double value) {
      const auto text =
          is_whole(info) ? std::to_string(static_cast<std::int64_t>(value)) : std::to_string(value);
      return refusal(info.name, text) == kAccepted;
    };
    const auto& [minimum, maximum, minimum_excluded, words] = info.valid;
    EXPECT_EQ(is_accepted(minimum), !minimum_excluded) << info.name;
    EXPECT_FALSE(is_accepted(minimum - 1.0)) << info.name;
    EXPECT_TRUE(is_accepted(maximum)) << info.name;
    EXPECT_FALSE(is_accepted(maximum * 2.0)) << info.name;
  }
}

// --- what makes sense together

struct Combination {
  const char* changes;  ///< NAME=VALUE, with a space between them
  std::string says = kAccepted;
};

TEST(Validate, says_what_does_not_go_together) {
  const std::string row =
      " m is not the height of a row of blocks: give a multiple of the spacing ";
  const std::string no_slow_slip =
      "junctions.f_new = f_slip is only for the reference or distance law: to switch slow slip "
      "off under the ";
  const std::vector<Combination> all = {
      {"slider.H=0.08",
       "the lattice must be square, but L/(Nx-1) = 0.0025 m and H/(Nz-1) = 0.00266667 m: change "
       "slider.L, slider.H, slider.Nx or slider.Nz (for instance slider.H = 0.075)"},
      // The smallest positive number halves to 0: no spacing, and a row beyond all integers.
      {"slider.L=5e-324 slider.H=5e-324 driving.h=0", "driving.h = 0" + row + "0 m below slider.H"},
      {"slider.L=5e-324 slider.H=5e-324 driving.h=0.005",
       "driving.h = 0.005" + row + "0 m below slider.H"},
      {"driving.h=0.006", "driving.h = 0.006" + row + "0.0025 m below slider.H"},
      {"driving.h=0.0775",
       "driving.h = 0.0775" + row + "0.0025 m below slider.H"},  // above the top
      {"driving.h=0"},
      {"driving.h=0.0025"},
      {"driving.h=0.075"},
      {"junctions.mu_d=0.5",
       "junctions.mu_d = 0.5 exceeds junctions.mu_s = 0.4: a slipping junction cannot carry more "
       "than its strength"},
      {"junctions.mu_d=0.4"},
      {"junctions.mu_new=0.2"},  // which the reference law does not look at
      {"junctions.mu_new=0.2 junctions.law=decaying",
       "junctions.mu_new = 0.2 exceeds junctions.mu_d = 0.17: under the decaying law the slipping "
       "force falls"},
      {"junctions.mu_new=0.17 junctions.law=decaying"},
      {"junctions.f_new=f_slip"},
      {"junctions.f_new=f_slip junctions.law=simplified",
       no_slow_slip + "simplified law, set junctions.v_slow to 0"},
      {"junctions.f_new=f_slip junctions.law=decaying",
       no_slow_slip + "decaying law, set junctions.mu_new to junctions.mu_d"},
      // k_i = 100 sqrt(39.2e9 * 4 * 0.33684) = 22.98 MN/m at the corners' pressure,
      // omega^2 = (5 k + k_i)/m = 2.115e12 /s^2, c = 12 eta/m = 2.132e6 /s
      {"numerics.dt=1e-5",
       "numerics.dt = 1e-05 s is unstable: the limit for this lattice is 6.972e-07 s"}};
  for (const auto& [changes, says] : all) {
    Parameters p;
    std::istringstream words(changes);
    for (std::string word; words >> word;) {
      const auto equals = word.find('=');
      set_parameter(p, word.substr(0, equals), word.substr(equals + 1));
    }
    EXPECT_EQ(refusal(p), says) << changes;
  }
}

TEST(Validate, takes_the_largest_stable_time_step) {
  Parameters p;
  p.dt = stable_time_step(p);
  EXPECT_EQ(refusal(p), kAccepted);
}

// --- quantities that follow

TEST(Derived, quantities_of_the_reference_slider_are_those_of_table_S1) {
  const Parameters p;
  const double mean = mean_normal_force(p);
  EXPECT_DOUBLE_EQ(block_spacing(p), 2.5e-3);
  EXPECT_DOUBLE_EQ(block_mass(p), 0.0756 / (57 * 31));
  EXPECT_DOUBLE_EQ(bulk_stiffness(p), 13.5e6);
  EXPECT_DOUBLE_EQ(foundation_stiffness(p), 6.75e6);
  EXPECT_DOUBLE_EQ(damping_coefficient(p), std::sqrt(0.1 * 13.5e6 * 0.0756 / (57 * 31)));
  EXPECT_DOUBLE_EQ(density(p), 1200.0);
  EXPECT_NEAR(shear_wave_speed(p), 968.0, 0.5);  // as docs/tests.md rounds it
  EXPECT_DOUBLE_EQ(mean, 1920.0 / 57);
  EXPECT_EQ(driving_row(p), 2);
  // k_ij = sqrt(kappa f_N) with f_N = 1920 N / (57 * 100)
  EXPECT_DOUBLE_EQ(junction_stiffness(p, 0, mean), std::sqrt(39.2e9 * 1920 / 5700));
  EXPECT_DOUBLE_EQ(junction_stiffness(p, 0, 4.0 * mean), 2.0 * junction_stiffness(p, 0, mean));
  EXPECT_DOUBLE_EQ(friction_stretch(p, 0, mean), std::sqrt(1920 / 5700.0 / 39.2e9));
}

TEST(Derived, stiffness_from_the_initial_force_is_that_of_the_load_on_the_column) {
  Parameters current;
  Parameters initial;
  initial.k_ij_from = StiffnessFrom::initial;
  const double mean = mean_normal_force(current);
  for (const double p_i : {0.01 * mean, mean, 4.0 * mean}) {
    EXPECT_EQ(junction_stiffness(initial, 0, p_i), junction_stiffness(current, 0, mean));
  }
  EXPECT_DOUBLE_EQ(friction_stretch(initial, 0, mean), friction_stretch(current, 0, mean));
  for (const Parameters& p : {current, initial}) {
    EXPECT_EQ(junction_stiffness(p, 0, 0.0), 0.0);
    EXPECT_EQ(friction_stretch(p, 0, 0.0), 0.0);
    for (const double p_i : {0.3, 30.0, 300.0}) {
      EXPECT_DOUBLE_EQ(junction_stiffness(p, 0, p_i) * friction_stretch(p, 0, p_i), p_i / 100.0)
          << "the strength follows the current force";
    }
  }
  set_parameter(initial, "slider.load", "3 from 0 to 70mm");
  set_parameter(current, "slider.load", "3 from 0 to 70mm");
  for (const std::int64_t i : {0, 56}) {  // 29 of 57 blocks bear three times as much as the others
    const double load = current.F_N * (i == 0 ? 3.0 : 1.0) / (3.0 * 29.0 + 28.0);
    EXPECT_DOUBLE_EQ(junction_stiffness(initial, i, mean), junction_stiffness(current, i, load));
  }
  EXPECT_DOUBLE_EQ(stable_time_step(initial), stable_time_step(current, column_load(current, 0)));
}

TEST(Derived, mean_slipping_time_is_that_of_the_folded_gaussian) {
  Parameters p;
  // |t| averaged over the Gaussian
  constexpr int n = 20000;
  double sum = 0.0, weight = 0.0;
  for (int i = 0; i <= n; ++i) {
    const double z = -10.0 + 20.0 * i / n, gauss = std::exp(-0.5 * z * z);
    sum += gauss * std::abs(p.t_R[0] + p.delta_t_R[0] * z);
    weight += gauss;
  }
  EXPECT_NEAR(mean_slipping_time(p, 0), sum / weight, 1e-9 * p.t_R[0]);
  p.slipping_times = SlippingTimes::exponential;
  EXPECT_EQ(mean_slipping_time(p, 0), p.t_R[0]);
  p.slipping_times = SlippingTimes::gaussian;
  p.delta_t_R = 0.0;
  EXPECT_EQ(mean_slipping_time(p, 0), p.t_R[0]);
}

}  // namespace rupture::testing
