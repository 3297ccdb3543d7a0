// Every branch of the interface laws, worked out by hand: what becomes of the junction of
// hand_made_interface.hpp when its block is moved. Each history is followed with both signs.
//
//   == NAME=VALUE ...   parameters of the histories below
//   NAME                a history; NAME* one whose junction breaks at once, at u = 0.21 m, t = 0
//     p= t= u=          f_N [N] and time [s], as before if not given, and where the block goes [m]
//     f= a=             then its friction [N] and the attachment point [m]
//     broken= repinned=           junctions that changed, 0 if not given
//     pinned= draws= left= slow=  number of pinned junctions, and what the junction remembers
//
// 0.2+ and 2e-3- are the next larger and smaller number.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <ostream>
#include <set>
#include <sstream>

#include "hand_made_interface.hpp"

namespace rupture::testing {

using Step = std::map<std::string, double>;

constexpr const char* kLawHistories = R"(
== junctions.law=reference
pulls_back_in_proportion_to_the_stretch
  u=0.05 f=0.1 a=0
  u=0.19 f=0.38 a=0
  u=-0.19 f=-0.38 a=0
  u=0 f=0 a=0
holds_at_f_thres_and_breaks_above_it
  u=0.2
  u=-0.2 pinned=1
  u=0.2+ broken=1 pinned=0 f=0.17
carries_f_slip_of_the_same_sign_once_broken
  u=0.3 broken=1 f=0.17 a=0.215
breaks_when_the_normal_force_falls
  u=0.15
  p=0.25 u=0.15 broken=1 f=0.0425
keeps_its_stretch_when_the_normal_force_rises
  u=0.15
  p=4 u=0.15 f=0.6
trails_the_block_at_f_slip*
  t=1e-4 u=0.25 f=0.17 a=0.165
  u=0.4 f=0.17 a=0.315
  u=2 f=0.17 a=1.915
stays_put_while_a_reversed_force_is_within_f_slip*
  t=1e-4 u=0.2 f=0.15 a=0.125
  u=0.125 f=1e-18 a=0.125
  u=0.05 f=-0.15 a=0.125
  u=0.18 f=0.11 a=0.125
trails_in_the_reversed_direction_and_forwards_again*
  t=1e-4 u=-0.1 f=-0.17 a=-0.015
  t=2e-4 u=0 f=0.03 a=-0.015
  t=3e-4 u=0.2 f=0.17 pinned=0
does_not_break_again_however_far_the_block_jumps*
  t=1e-4 u=-5 f=-0.17 draws=1
follows_f_slip_of_the_current_normal_force*
  p=0.25 t=1e-4 u=0.21 f=0.0425
  p=1 t=2e-4 u=0.21 f=0.085
is_pinned_without_force_after_t_R*
  t=2e-3- u=0.3 f=0.17
  t=2e-3 u=0.31 repinned=1 f=0 a=0.31 pinned=1
  t=3e-3 u=0.36 f=0.1
has_no_friction_without_contact_and_follows
  u=0.1
  p=0 t=1e-4 u=0.1 f=0 a=0.1
  u=5 f=0 a=5
  u=-3 f=0 a=-3 pinned=1
  p=1 t=2e-4 u=-2.95 f=0.1
slipping_times_run_on_without_contact*
  p=0 t=1e-3 u=1 pinned=0
  t=2e-3 u=1 repinned=1 pinned=1
slips_on_when_pressed_again*
  p=0 t=1e-3 u=1
  p=1 t=1.1e-3 u=1.05 f=0.1
  t=1.2e-3 u=1.2 f=0.17
  t=2e-3 u=1.2 repinned=1

== junctions.law=reference junctions.f_new=f_slip
keeps_its_force
  u=0.21 broken=1
  t=2e-3 u=0.31 repinned=1 f=0.17 pinned=1
  t=3e-3 u=0.4249
  u=0.4251 broken=1
is_pinned_inside_its_play*
  t=1e-3 u=0.125
  t=2e-3 u=0.125 repinned=1 f=1e-18 pinned=1

== junctions.law=reference junctions.without_contact=break
breaks_without_contact
  u=0.1
  p=0 t=1e-3 u=0.15 broken=1 f=0
  t=1.1e-3 u=0.2 f=0 a=0.2
  p=1 t=1.5e-3 u=0.5 f=0.17
  t=3e-3 u=0.5 repinned=1
  t=4e-3 u=0.51
breaks_again_once_pinned_in_the_air
  p=0 u=0.1 broken=1
  t=2e-3 u=0.1 repinned=1
  t=2.2e-3 u=0.1 broken=1 draws=2

== junctions.law=decaying junctions.mu_d=0.2 junctions.mu_new=0.12
is_elastic_up_to_f_thres_and_breaks_above_it
  u=0.1 f=0.2
  u=0.2
  u=0.2+ broken=1 f=0.2 pinned=0 draws=1
falls_linearly_under_a_block_at_rest*
  u=0.21 f=0.2 a=0.11
  t=0.5e-3 u=0.21 f=0.18 a=0.12
  t=1e-3 u=0.21 f=0.16 a=0.13
  t=1.5e-3 u=0.21 f=0.14 a=0.14
  t=1.875e-3 u=0.21 f=0.125 a=0.1475 pinned=0
trails_a_moving_block_at_the_force_of_the_time*
  t=0.5e-3 u=0.3 f=0.18
  t=1.5e-3 u=2 f=0.14
stays_put_while_a_reversed_force_is_within_the_limit*
  t=1e-3 u=0.18 f=0.14 a=0.11
  u=0.11 f=1e-18 a=0.11
  u=0.04 f=-0.14 a=0.11
  u=0.02 f=-0.16
  t=1.5e-3 u=0.02 f=-0.14
is_pinned_with_f_new_after_t_R*
  t=2e-3- u=0.3 f=0.12
  t=2e-3 u=0.31 repinned=1 f=0.12 a=0.25 pinned=1
  t=3e-3 u=0.4499 a=0.25
  t=4e-3 u=0.4501 broken=1 f=0.2
  t=5e-3 u=0.5 f=0.16
is_pinned_late_with_f_new*
  t=4e-3 u=0.3 repinned=1 f=0.12
is_pinned_inside_the_play_with_the_force_there_is*
  t=1e-3 u=0.12
  t=2e-3 u=0.12 repinned=1 f=0.02 pinned=1
follows_the_current_normal_force*
  p=0.25 t=1e-3 u=0.21 f=0.04
  t=2e-3 u=0.21 repinned=1 f=0.03
has_no_friction_without_contact_and_its_time_runs_on*
  p=0 t=0.2e-3 u=1 f=0 a=1
  u=-3 f=0 a=-3
  p=1 t=0.5e-3 u=-2.5 f=0.18
  p=0 t=2e-3 u=1 repinned=1
  t=3e-3 u=0.5 a=0.5 pinned=1

== junctions.law=decaying junctions.mu_d=0.2 junctions.mu_new=0.12 junctions.repin=exact
is_pinned_with_exactly_f_new_in_its_play*
  t=2e-3 u=0.12 repinned=1 f=0.12 pinned=1
is_pinned_with_exactly_f_new_backwards*
  t=2e-3 u=0.1 repinned=1 f=-0.12 pinned=1
is_pinned_with_exactly_f_new_while_sliding*
  t=1e-3 u=0.301 f=0.16
  t=2e-3 u=0.302 repinned=1 f=0.12
  t=3e-3 u=0.303 f=0.122
is_pinned_without_force_where_there_is_none_even_if_exact
  u=0.21 broken=1
  p=0 t=1e-3 u=0.3
  p=1 t=2e-3 u=0.3 repinned=1 f=0 pinned=1

== junctions.law=decaying junctions.mu_d=0.2 junctions.mu_new=0
ends_without_force_if_mu_new_is_zero*
  t=1e-3 u=0.21 f=0.1
  t=2e-3 u=0.21 repinned=1 f=0

# Slow slip moves the attachment point by v_slow dt = 1 mm at each step for t_R.
== junctions.law=simplified numerics.dt=1e-4 junctions.v_slow=10
pulls_back_without_slow_slip_before_the_first_break
  t=1e-4 u=0.05 f=0.1 a=0
  u=0.19 f=0.38 a=0
  u=-0.19 f=-0.38 a=0
  u=0 f=0 a=0
breaks_above_the_strength_and_slides_at_mu_d_p_of_the_same_sign
  u=0.2 pinned=1
  u=0.2+ broken=1 pinned=0 f=0.17 slow=2e-3 draws=0
trails_a_block_that_is_faster_than_slow_slip*
  t=1e-4 u=0.25 f=0.17 a=0.165
  u=0.4 f=0.17 a=0.315
  u=2 f=0.17 a=1.915
moves_the_attachment_at_v_slow_while_the_block_is_slower*
  t=1e-4 u=0.210001 a=0.126 pinned=0
  t=2e-4 u=0.210002 a=0.127 pinned=0
  t=3e-4 u=0.210003 a=0.128 pinned=0
stops_slow_slip_t_R_after_the_break_while_slipping*
  t=2e-3- u=0.210001 a=0.126
  t=2e-3 u=0.210002 a=0.126 pinned=0
goes_on_slipping_slowly_when_pinned_until_t_R_after_the_break*
  t=1e-4 u=0.2 repinned=1 a=0.126
  t=2e-4 u=0.2 a=0.127 f=0.146
  t=1.9e-3 u=0.2 a=0.128 f=0.144
  t=2e-3 u=0.2 a=0.128
  t=4e-3 u=0.2 a=0.128 pinned=1
is_pinned_when_the_block_stands_still*
  t=1e-4 u=0.21 repinned=1 pinned=1
moves_slowly_before_it_asks_whether_a_pinned_spring_breaks*
  t=1e-4 u=0.2 repinned=1 a=0.126
  t=2e-4 u=0.3269 a=0.127
  t=3e-4 u=0.3281 broken=1
takes_direction_and_time_of_the_last_break*
  t=1e-4 u=0.2 repinned=1
  t=1.5e-3 u=-0.3 broken=1 f=-0.17 a=-0.215 slow=-3.5e-3
  t=2.5e-3 u=-0.3001 a=-0.216
  t=2.6e-3 u=-0.3 repinned=1
is_pinned_at_once_under_a_block_that_moves_against_its_force
  u=0.19
  p=0.25 t=1e-4 u=0.18 broken=1 f=0.0425
  t=2e-4 u=0.17 repinned=1
has_no_friction_without_contact_and_its_time_runs_on*
  p=0 t=1e-4 u=1 f=0 a=1
  t=2e-4 u=0.9 repinned=1
  t=3e-4 u=5 a=5
  p=1 t=4e-4 u=5 a=5.001 f=-0.002

== junctions.law=simplified numerics.dt=1e-4 junctions.v_slow=0
is_pinned_with_its_force_when_the_block_turns_back*
  t=1e-4 u=0.3 f=0.17
  t=2e-4 u=0.299 repinned=1 pinned=1 f=0.168 a=0.215
  t=3e-4 u=0.414 a=0.215
  t=4e-4 u=0.416 broken=1
follows_the_current_normal_force*
  p=0.25 t=1e-4 u=0.22 f=0.0425
  p=4 t=2e-4 u=0.23 f=0.21

# The spring stands for 50 junctions; slow slip moves its attachment point by 0.1 m at each step.
== junctions.law=simplified junctions.N_s=50 numerics.dt=1e-2 junctions.v_slow=10
has_the_stiffness_and_strength_of_all_junctions_together
  u=0.1 f=10 a=0
  u=0.21 broken=1 f=8.5
pulls_a_sliding_block_forwards_no_harder_than_mu_d_p*
  t=1e-4 u=0.22 a=0.225
  u=0.23 f=-8.5 a=0.315 pinned=0
  u=0.24 f=-8.5 a=0.325 pinned=0

# A junction slides by 0.3 m.
== junctions.law=distance junctions.d_R=0.3 junctions.delta_d_R=0
is_elastic_up_to_f_thres_and_breaks_above_it
  u=0.2 f=0.4 left=0
  u=0.21 broken=1 f=0.17 pinned=0 draws=1 left=0.3
slides_with_f_slip_for_d_R_and_is_then_pinned_without_force*
  t=1e-3 u=0.41 left=0.1 f=0.17
  t=2e-3 u=0.5
  t=3e-3 u=0.52 repinned=1 f=0 a=0.52 left=0 pinned=1
is_never_pinned_under_a_block_at_rest*
  t=1e6 u=0.21 f=0.17 left=0.3
counts_sliding_in_either_direction_but_no_play*
  t=1e-3 u=0.31 left=0.2
  t=2e-3 u=0.140001 left=0.2
  t=3e-3 u=0.04 left=0.1 f=-0.17
  t=4e-3 u=-0.07 repinned=1 f=0
slides_when_the_normal_force_falls*
  p=0.25 t=1e-3 u=0.21 f=0.0425 left=0.2575
does_not_slide_without_contact*
  p=0 t=1e-3 u=1 f=0 a=1
  u=-3 f=0 a=-3 left=0.3
  p=1 t=2e-3 u=-2.815 f=0.17 left=0.2

== junctions.law=distance junctions.d_R=0.3 junctions.delta_d_R=0 junctions.f_new=f_slip
keeps_its_force*
  t=1e-3 u=0.61 repinned=1 f=0.17
)";

struct History {
  std::string name, text;
  Parameters parameters;
  std::vector<Step> steps;
};

std::ostream& operator<<(std::ostream& out, const History& history) {
  return out << history.text;
}

double number(const std::string& text) {
  const double value = std::stod(text);
  if (text.back() == '+') return std::nextafter(value, 10.0);
  return text.back() == '-' ? std::nextafter(value, 0.0) : value;
}

template <class Use>
void each_pair(const std::string& line, const Use& use) {
  std::istringstream words(line);
  for (std::string word; words >> word;) {
    const auto equals = word.find('=');
    if (equals < word.size() - 1) use(word.substr(0, equals), word.substr(equals + 1));
  }
}

std::vector<History> histories() {
  std::vector<History> all;
  Parameters parameters;
  std::istringstream lines(kLawHistories);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (line.starts_with("==")) {
      parameters = hand_made(1);
      each_pair(line.substr(2), [&](const auto& name, const auto& value) {
        set_parameter(parameters, name, value);
      });
    } else if (line[0] != ' ') {
      const bool breaks = line.ends_with('*');
      if (breaks) line.pop_back();
      all.push_back({law_name(parameters.law) + "_" + line, "", parameters, {}});
      if (breaks) all.back().steps.push_back({{"u", 0.21}, {"broken", 1.0}});
    } else {
      all.back().text += "\n" + line;
      Step& step = all.back().steps.emplace_back();
      each_pair(line, [&](const auto& name, const auto& value) { step[name] = number(value); });
    }
  }
  for (std::size_t n = 0; n < all.size(); ++n) all[n].name += "_" + std::to_string(n);
  return all;
}

const std::set<std::string> kWords = {"p",        "t",      "u",     "f",    "a",   "broken",
                                      "repinned", "pinned", "draws", "left", "slow"};

class ByHand : public ::testing::TestWithParam<History> {
 protected:
  void expect(const Step& step, const char* name, double value) const {
    const auto found = step.find(name);
    if (found == step.end()) return;
    if (found->second == 0.0) {
      EXPECT_EQ(value, 0.0) << name;
    } else {
      EXPECT_NEAR(value, found->second, 2 * kRounding * std::max(1.0, std::abs(value))) << name;
    }
  }
};

TEST_P(ByHand, goes_as_worked_out_by_hand) {
  for (const double sign : {1.0, -1.0}) {
    Interface block(GetParam().parameters);
    double t = 0.0;
    int n = 0;
    for (Step step : GetParam().steps) {
      SCOPED_TRACE("step " + std::to_string(++n) + ", sign " + std::to_string(sign));
      if (step.contains("p")) block.press(step["p"]);
      if (step.contains("t")) t = step["t"];
      for (const auto& [name, value] : step) EXPECT_TRUE(kWords.contains(name)) << name;
      const auto changes = block.move(sign * step["u"], t);
      const Junctions& junctions = block.junctions();
      EXPECT_EQ(changes.broken, step["broken"]);
      EXPECT_EQ(changes.repinned, step["repinned"]);
      expect(step, "f", sign * block.friction());
      expect(step, "a", sign * block.attachment());
      expect(step, "pinned", block.pinned());
      expect(step, "draws", junctions.draws(0, 0));
      if (GetParam().parameters.law == Law::distance) {
        EXPECT_EQ(junctions.repin_time(0, 0),
                  block.pinned() == 1 ? Junctions::never : Junctions::unknown);
      }
      if (step.contains("left")) expect(step, "left", junctions.slip_left(0, 0));
      if (step.contains("slow")) expect(step, "slow", sign * junctions.slow_until(0, 0));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, ByHand, ::testing::ValuesIn(histories()),
                         [](const auto& history) { return history.param.name; });

}  // namespace rupture::testing
