// The parameter table: every error sentence, text that reads back, and what makes sense together.
#include "rupture/model/parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "rupture/model/derived.hpp"
#include "support/sliders.hpp"

namespace rupture {
namespace {

using testing::message_of;

std::string refusal(std::string_view name, std::string_view text) {
  return message_of<UsageError>([&] {
    Parameters p;
    set_parameter(p, name, text);
  });
}

std::string refusal(const Parameters& p) {
  return message_of<UsageError>([&] { validate(p); });
}

const std::string kAccepted = "(nothing was thrown)";

TEST(ParameterTable, names_each_parameter_once_and_completely) {
  std::set<std::string_view> names;
  for (const auto& info : parameter_table()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_NE(info.name.find('.'), std::string_view::npos) << info.name;
    EXPECT_FALSE(info.symbol.empty()) << info.name;
    EXPECT_FALSE(info.unit.empty()) << info.name;
    EXPECT_FALSE(info.help.empty()) << info.name;
  }
  EXPECT_EQ(names.size(), 34U);  // members of Parameters
}

TEST(ParameterTable, accepts_its_own_defaults) {
  const Parameters defaults;
  for (const auto& info : parameter_table()) {
    EXPECT_EQ(refusal(info.name, parameter_text(defaults, info)), kAccepted);
  }
  EXPECT_EQ(refusal(defaults), kAccepted);
}

TEST(ParameterTable, sets_the_member_that_the_row_names_and_no_other) {
  const Parameters defaults;
  for (const auto& info : parameter_table()) {
    Parameters changed;
    const bool whole = std::holds_alternative<std::int64_t Parameters::*>(info.member);
    std::string text = whole ? "7" : "0.7";  // valid in every row, and no default
    if (!choices(info).empty()) text = choices(info).back();
    set_parameter(changed, info.name, text);
    int different = 0;
    for (const auto& row : parameter_table()) {
      const bool same = parameter_text(changed, row) == parameter_text(defaults, row);
      different += same ? 0 : 1;
      EXPECT_EQ(same, row.name != info.name) << row.name;
    }
    EXPECT_EQ(different, 1) << info.name;
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

TEST(SetParameter, suggests_the_nearest_name) {
  EXPECT_EQ(refusal("slider.Length", "1"),
            "unknown parameter 'slider.Length': did you mean 'slider.L'?");
  EXPECT_EQ(refusal("junctions.mu_S", "1"),
            "unknown parameter 'junctions.mu_S': did you mean 'junctions.mu_s'?");
  EXPECT_EQ(refusal("mu_d", "1"), "unknown parameter 'mu_d': did you mean 'junctions.mu_d'?");
  EXPECT_EQ(refusal("drving.V", "1"), "unknown parameter 'drving.V': did you mean 'driving.V'?");
  EXPECT_EQ(refusal("numerics.dt ", "1"),
            "unknown parameter 'numerics.dt ': did you mean 'numerics.dt'?");
}

TEST(SetParameter, refuses_text_that_is_no_number) {
  for (const std::string text : {"", "abc", "1e", "0.14kg", "0.14Mm", " 1", "1 ", "0x10", "1,5"}) {
    EXPECT_EQ(refusal("slider.L", text),
              "slider.L = '" + text + "' is not a number (unit m, mm, um or nm)");
  }
}

TEST(SetParameter, takes_numbers_in_multiples_of_its_unit) {
  Parameters p;
  set_parameter(p, "numerics.dt", "0.1us");
  EXPECT_EQ(p.dt, 1e-7);
  set_parameter(p, "slider.L", "150 mm");
  EXPECT_EQ(p.L, 0.15);
  set_parameter(p, "slider.M", "80g");
  EXPECT_EQ(p.M, 0.08);
  EXPECT_EQ(refusal("slider.Nx", "57m"), "slider.Nx = '57m' is not a whole number (unit 1)");
  EXPECT_EQ(refusal("slider.L", "2e6mm"),
            "slider.L = 2e6mm is out of range: give a value above 0 and at most 1000 (unit m)");
}

TEST(SetParameter, refuses_what_is_no_whole_number) {
  for (const std::string text : {"57.5", "1.5", "1e-1", "5e1x", "nan", "ten", ""}) {
    EXPECT_EQ(refusal("slider.Nx", text),
              "slider.Nx = '" + text + "' is not a whole number (unit 1)");
  }
}

TEST(SetParameter, takes_whole_numbers_in_other_notations) {
  Parameters p;
  for (const auto& [text, number] :
       std::map<std::string, std::int64_t>{{"1e3", 1000}, {"57.0", 57}, {"1.5e2", 150}}) {
    set_parameter(p, "slider.Nx", text);
    EXPECT_EQ(p.Nx, number) << text;
  }
  set_parameter(p, "numerics.seed", "8999999999999999");
  EXPECT_EQ(p.seed, 8999999999999999);
  set_parameter(p, "numerics.seed", "9e15");
  EXPECT_EQ(p.seed, 9000000000000000);
}

TEST(SetParameter, refuses_whole_numbers_in_other_notations_out_of_range) {
  for (const std::string text : {"1e9", "-1e3", "1e300", "1e400", "2.0"}) {
    EXPECT_EQ(refusal("slider.Nx", text),
              "slider.Nx = " + text +
                  " is out of range: give a value of at least 3 and at most 65536 (unit 1)");
  }
}

TEST(SetParameter, refuses_numbers_out_of_range) {
  EXPECT_EQ(refusal("slider.L", "0"),
            "slider.L = 0 is out of range: give a value above 0 and at most 1000 (unit m)");
  EXPECT_EQ(refusal("slider.L", "1001"),
            "slider.L = 1001 is out of range: give a value above 0 and at most 1000 (unit m)");
  EXPECT_EQ(refusal("driving.V", "-11"),
            "driving.V = -11 is out of range: give a value of at least -10 and at most 10 (unit "
            "m/s)");
  EXPECT_EQ(refusal("slider.Nx", "2"),
            "slider.Nx = 2 is out of range: give a value of at least 3 and at most 65536 (unit 1)");
  EXPECT_EQ(refusal("slider.Nx", "9999999999999999999999"),  // more than 64 bits
            "slider.Nx = 9999999999999999999999 is out of range: give a value of at least 3 and at "
            "most 65536 (unit 1)");
  EXPECT_EQ(refusal("numerics.seed", "-1"),
            "numerics.seed = -1 is out of range: give a value of at least 0 and at most 9e+15 "
            "(unit 1)");
}

TEST(ParameterTable, says_which_laws_use_a_parameter) {
  const ParameterInfo& v_slow = find_parameter("junctions.v_slow");
  EXPECT_TRUE(is_used(v_slow, Law::simplified));
  EXPECT_FALSE(is_used(v_slow, Law::reference));
  EXPECT_TRUE(is_used(find_parameter("junctions.mu_s"), Law::simplified));
  Parameters p;
  p.v_slow = 1.0;
  EXPECT_EQ(used_text(p, v_slow), "0.0015");
  p.law = Law::simplified;
  EXPECT_EQ(used_text(p, v_slow), "1");
}

TEST(SetParameter, refuses_what_is_not_finite_in_every_row) {
  for (const auto& info : parameter_table()) {
    for (const char* text : {"nan", "inf", "-inf", "-1e400", "1e400"}) {
      EXPECT_NE(refusal(info.name, text), kAccepted) << info.name << " = " << text;
    }
  }
}

TEST(SetParameter, holds_every_row_to_its_limits) {
  for (const auto& info : parameter_table()) {
    if (!choices(info).empty()) continue;
    const bool whole = std::holds_alternative<std::int64_t Parameters::*>(info.member);
    const auto text = [&](double value) {
      return whole ? std::to_string(static_cast<std::int64_t>(value)) : std::to_string(value);
    };
    EXPECT_EQ(refusal(info.name, text(info.minimum)) == kAccepted, !info.minimum_excluded)
        << info.name;
    EXPECT_NE(refusal(info.name, text(info.minimum - 1.0)), kAccepted) << info.name;
    EXPECT_EQ(refusal(info.name, text(info.maximum)), kAccepted) << info.name;
    EXPECT_NE(refusal(info.name, text(info.maximum * 2.0)), kAccepted) << info.name;
  }
}

TEST(SetParameter, refuses_unknown_words) {
  EXPECT_EQ(refusal("junctions.slipping_times", "normal"),
            "junctions.slipping_times = 'normal' is unknown: choose one of gaussian, exponential");
  EXPECT_EQ(refusal("junctions.law", "simple"),
            "junctions.law = 'simple' is unknown: choose one of reference, simplified, decaying, "
            "distance");
  EXPECT_EQ(refusal("junctions.f_new", "Zero"),
            "junctions.f_new = 'Zero' is unknown: choose one of zero, f_slip");
  EXPECT_EQ(refusal("slider.support", "floor"),
            "slider.support = 'floor' is unknown: choose one of foundation, ceiling");
}

TEST(SetParameter, leaves_everything_as_it_was_when_it_refuses) {
  Parameters p;
  EXPECT_THROW(set_parameter(p, "slider.L", "-1"), UsageError);
  EXPECT_EQ(p, Parameters{});
}

TEST(Validate, wants_a_square_lattice) {
  Parameters p;
  p.H = 0.08;
  EXPECT_EQ(refusal(p),
            "the lattice must be square, but L/(Nx-1) = 0.0025 m and H/(Nz-1) = 0.00266667 m: "
            "change slider.L, slider.H, slider.Nx or slider.Nz (for instance slider.H = 0.075)");
}

// The smallest positive number halves to 0: no spacing, and a row of blocks beyond all integers.
TEST(Validate, wants_a_spacing_above_zero) {
  Parameters p;
  p.L = std::numeric_limits<double>::denorm_min();
  p.H = std::numeric_limits<double>::denorm_min();
  for (const double h : {0.0, 0.005}) {
    p.h = h;
    EXPECT_TRUE(refusal(p).ends_with(
        " is on no row of blocks: give a multiple of the spacing 0 m below slider.H"))
        << refusal(p);
  }
}

TEST(Validate, wants_the_driving_height_on_a_row) {
  Parameters p;
  const std::string end =
      " m is on no row of blocks: give a multiple of the spacing 0.0025 m below slider.H";
  p.h = 0.006;
  EXPECT_EQ(refusal(p), "driving.h = 0.006" + end);
  p.h = 0.0775;  // one row above the top
  EXPECT_EQ(refusal(p), "driving.h = 0.0775" + end);
  for (const double h : {0.0, 0.0025, 0.075}) {
    p.h = h;
    EXPECT_EQ(refusal(p), kAccepted) << h;
  }
}

TEST(Validate, wants_mu_d_at_most_mu_s) {
  Parameters p;
  p.mu_d = 0.5;
  EXPECT_EQ(refusal(p),
            "junctions.mu_d = 0.5 exceeds junctions.mu_s = 0.4: a junction cannot slip at more "
            "than its strength");
  p.mu_d = p.mu_s;
  EXPECT_EQ(refusal(p), kAccepted);
}

TEST(Validate, wants_mu_new_at_most_mu_d_under_the_decaying_law) {
  Parameters p;
  p.mu_new = 0.2;
  EXPECT_EQ(refusal(p), kAccepted) << "which the reference law does not look at";
  p.law = Law::decaying;
  EXPECT_EQ(refusal(p),
            "junctions.mu_new = 0.2 exceeds junctions.mu_d = 0.17: under the decaying law the "
            "slipping force falls");
  p.mu_new = p.mu_d;
  EXPECT_EQ(refusal(p), kAccepted);
}

TEST(Validate, says_how_each_law_is_told_to_do_without_slow_slip) {
  Parameters p;
  p.f_new = NewForce::f_slip;
  EXPECT_EQ(refusal(p), kAccepted);
  p.law = Law::simplified;
  EXPECT_EQ(refusal(p),
            "junctions.f_new = f_slip belongs to the reference and the distance law: to switch "
            "slow slip off under the simplified law, set junctions.v_slow to 0");
  p.law = Law::decaying;
  EXPECT_EQ(refusal(p),
            "junctions.f_new = f_slip belongs to the reference and the distance law: to switch "
            "slow slip off under the decaying law, set junctions.mu_new to junctions.mu_d");
}

TEST(Validate, wants_a_stable_time_step) {
  Parameters p;
  p.dt = stable_time_step(p);
  EXPECT_EQ(refusal(p), kAccepted);
  p.dt = 1e-5;
  // k_i = 100 sqrt(39.2e9 * 4 * 0.33684) = 22.98 MN/m at the corners' pressure, omega^2 = (5 k +
  // k_i)/m = 2.115e12 /s^2, c = 12 eta/m = 2.132e6 /s
  EXPECT_EQ(refusal(p),
            "numerics.dt = 1e-05 s is unstable: the limit for this lattice is 6.972e-07 s");
}

TEST(Derived, quantities_of_the_reference_slider_are_those_of_table_S1) {
  const Parameters p;
  EXPECT_DOUBLE_EQ(block_spacing(p), 2.5e-3);
  EXPECT_DOUBLE_EQ(block_mass(p), 0.0756 / (57 * 31));
  EXPECT_DOUBLE_EQ(bulk_stiffness(p), 13.5e6);
  EXPECT_DOUBLE_EQ(foundation_stiffness(p), 6.75e6);
  EXPECT_DOUBLE_EQ(damping_coefficient(p), std::sqrt(0.1 * 13.5e6 * 0.0756 / (57 * 31)));
  EXPECT_DOUBLE_EQ(density(p), 1200.0);
  EXPECT_NEAR(shear_wave_speed(p), 968.0, 0.5);  // as physics.md rounds it
  EXPECT_DOUBLE_EQ(mean_normal_force(p), 1920.0 / 57);
  EXPECT_EQ(driving_row(p), 2);
  // k_ij = sqrt(kappa f_N) with f_N = 1920 N / (57 * 100)
  EXPECT_DOUBLE_EQ(junction_stiffness(p, mean_normal_force(p)), std::sqrt(39.2e9 * 1920 / 5700));
  EXPECT_DOUBLE_EQ(friction_stretch(p, mean_normal_force(p)), std::sqrt(1920 / 5700.0 / 39.2e9));
  EXPECT_EQ(friction_stretch(p, 0.0), 0.0);
}

TEST(Derived, mean_slipping_time_is_that_of_the_folded_gaussian) {
  Parameters p;
  // |t| averaged over the Gaussian
  constexpr int n = 20000;
  double sum = 0.0, weight = 0.0;
  for (int i = 0; i <= n; ++i) {
    const double z = -10.0 + 20.0 * i / n, gauss = std::exp(-0.5 * z * z);
    sum += gauss * std::abs(p.t_R + p.delta_t_R * z);
    weight += gauss;
  }
  EXPECT_NEAR(mean_slipping_time(p), sum / weight, 1e-9 * p.t_R);
  p.slipping_times = SlippingTimes::exponential;
  EXPECT_EQ(mean_slipping_time(p), p.t_R);
  p.slipping_times = SlippingTimes::gaussian;
  p.delta_t_R = 0.0;
  EXPECT_EQ(mean_slipping_time(p), p.t_R);
}

}  // namespace
}  // namespace rupture
