// The guard: every finding from a state made to trigger it, and silence where one might be
// expected. It is silent in all runs of golden/, under each law.
#include "rupture/dynamics/guard.hpp"

#include <gtest/gtest.h>

#include "rupture/dynamics/equilibrium.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

/// All findings of `looks` looks, `interval` steps apart; the first one before any step.
std::vector<Finding> watch(Simulation& simulation, int looks, std::int64_t interval) {
  Guard guard(simulation);
  std::vector<Finding> all = guard.look(simulation);
  for (int n = 0; n < looks; ++n) {
    simulation.advance(interval);
    for (const Finding& finding : guard.look(simulation)) all.push_back(finding);
  }
  return all;
}

std::vector<Finding> findings_at_once(const Parameters& p, const State& state) {
  Simulation simulation(p, state);
  return watch(simulation, 0, 0);
}

/// Demands exactly one finding of this kind, with each part in its sentence.
void expect_one(const std::vector<Finding>& found, Check check, Severity severity,
                std::initializer_list<const char*> parts) {
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].check, check);
  EXPECT_EQ(found[0].severity, severity);
  for (const char* part : parts) {
    EXPECT_NE(found[0].sentence.find(part), std::string::npos)
        << found[0].sentence << "\nlacks " << part;
  }
}

TEST(Guard, says_nothing_at_rest_where_the_energy_account_is_all_rounding) {
  const Parameters p = prepared_slider();
  Prestress prestress = quick_prestress();
  prestress.trigger = Trigger::pinned;
  Simulation simulation(p, prepared_state(p, prestress));
  const Energies before = simulation.energies();
  EXPECT_TRUE(watch(simulation, 20, 5000).empty());
  EXPECT_GT(energy_balance(before, simulation.energies(), simulation.work()).relative_error(), 0.1);
}

TEST(Guard, says_nothing_about_junctions_exactly_at_their_strength) {
  const Parameters p = prepared_slider();
  Prestress prestress = quick_prestress();
  prestress.sigma_bar = largest_sigma_bar(p, prestress);
  EXPECT_TRUE(findings_at_once(p, prepared_state(p, prestress)).empty());
  prestress = {1.0, 0.0, PhiShape::uniform, 0.0};
  EXPECT_TRUE(findings_at_once(p, prepared_state(p, prestress)).empty());
}

TEST(Guard, finds_a_block_pressed_so_hard_that_the_time_step_is_too_long) {
  Parameters p = quick_slider();
  p.kappa = 7e14;  // stable up to about four times the mean normal force
  p.mu_s = 100.0;
  State state = normal_load_equilibrium(p);
  EXPECT_TRUE(findings_at_once(p, state).empty());
  state.u_z(3, 0) *= 6.0;
  const double p_3 = NormalContact(p, 0).normal_force(state.u_z(3, 0));
  EXPECT_LT(stable_time_step(p, p_3), p.dt);
  EXPECT_GT(stable_time_step(p), p.dt);
  expect_one(findings_at_once(p, state), Check::time_step, Severity::alarm,
             {"block 3 carries p = ", "numerics.dt = 2e-07 s", "t = 0 s"});
}

/// Without damping, a driving spring of modulus K [N/m], drawn by 1 um. One of 4e9 N/m would be too
/// stiff for the time step.
Simulation stiffly_driven(double K) {
  Parameters p = quick_slider();
  p.damping = 0.0;
  p.K = K;
  p.V = 0.0;
  State state = normal_load_equilibrium(p);
  state.drive.origin_position += 1e-6;
  state.f_x(0, 1) += p.K * 1e-6;
  return Simulation(p, state);
}

TEST(Guard, says_nothing_about_a_vibration_that_stores_and_dissipates_next_to_nothing) {
  Simulation simulation = stiffly_driven(2e7);
  EXPECT_TRUE(watch(simulation, 40, 5000).empty());
}

TEST(Guard, finds_an_error_since_the_start_that_short_looks_allow) {
  Simulation simulation = stiffly_driven(3.9e9);
  expect_one(watch(simulation, 250, 4), Check::energy, Severity::alarm, {"from t = 0 s to "});
}

// The slider slides and is slowed down by friction from 10 m/s to 0.3 m/s; then its junctions, so
// stiff that the time step cannot follow, are pinned all at once.
TEST(Guard, finds_an_error_since_the_last_look_that_is_small_since_the_start) {
  constexpr double t_stop = 4e-4, v_stop = 0.3;
  Parameters p = quick_slider();
  p.damping = p.K = p.V = 0.0;
  p.kappa = 5e14;
  p.mu_s = 100.0;
  State state = normal_load_equilibrium(p);
  state.v_x.blocks() = v_stop + p.mu_d[0] * p.F_N / p.M * t_stop;
  state.junctions.attachment.colwise() = state.u_x.blocks().row(0).transpose();
  state.junctions.repin_time.setConstant(t_stop);
  Simulation simulation(p, state);
  const Energies before = simulation.energies();
  const auto found = watch(simulation, 3, 1000);
  const auto since_start = energy_balance(before, simulation.energies(), simulation.work());
  EXPECT_LT(since_start.relative_error(), energy_tolerance(3000));
  expect_one(found, Check::energy, Severity::alarm, {"from t = 0.0004 s to 0.0006 s"});
}

TEST(Guard, allows_a_short_account_a_larger_error) {
  EXPECT_DOUBLE_EQ(energy_tolerance(1000), 0.02);
  EXPECT_NEAR(energy_tolerance(6000000), 0.01, 1e-5);
  EXPECT_GT(energy_tolerance(1), 1.0);
}

TEST(Guard, warns_of_slipping_junctions_beyond_the_slipping_force_at_the_start) {
  const Parameters p = quick_slider();
  State state = normal_load_equilibrium(p);
  const double w = friction_stretch(p, 0, NormalContact(p, 0).normal_force(state.u_z(2, 0)));
  state.junctions.attachment(2, 0) = state.u_x(2, 0) + 1.01 * p.mu_d[0] * w;
  EXPECT_TRUE(findings_at_once(p, state).empty()) << "pinned, and below mu_s";
  state.junctions.repin_time(2, 0) = 1.0;
  expect_one(findings_at_once(p, state), Check::strength, Severity::warning,
             {"t = 0 s: 1, the first in block 2"});
}

TEST(Guard, calls_junctions_beyond_their_strength_after_the_start_a_bug) {
  const Parameters p = quick_slider();
  State state = normal_load_equilibrium(p);
  Guard guard(Simulation(p, state));
  state.step = 1;
  state.junctions.attachment(4, 7) -= 1e-4;
  expect_one(guard.look(Simulation(p, state)), Check::strength, Severity::alarm,
             {"t = 2e-07 s: 1, the first in block 4", "bug"});
}

TEST(Guard, warns_of_blocks_without_contact_but_not_of_their_junctions) {
  const Parameters p = quick_slider();
  State state = normal_load_equilibrium(p);
  state.u_z(7, 0) = state.u_z(8, 0) = 1e-7;
  state.junctions.attachment.row(7) -= 1e-4;
  expect_one(findings_at_once(p, state), Check::contact, Severity::warning,
             {"do not touch the foundation at t = 0 s: 2 of 9, the first is block 7"});
}

TEST(Guard, finds_a_slider_that_touches_nothing) {
  for (Parameters p : {quick_slider(), prepared_slider()}) {
    State state(p);
    state.u_z.blocks() = p.support == Support::foundation ? 1e-7 : -1e-7;
    expect_one(findings_at_once(p, state), Check::contact, Severity::alarm,
               {"no block touches the ",
                p.support == Support::foundation ? "foundation" : "ceiling", "1"});
  }
}

TEST(Guard, finds_blocks_that_have_passed_each_other) {
  const Parameters p = quick_slider();
  for (const bool up : {true, false}) {
    State state = normal_load_equilibrium(p);
    (up ? state.u_z : state.u_x)(3, 2) += 1.1 * block_spacing(p);
    expect_one(findings_at_once(p, state), Check::lattice, Severity::alarm,
               {"block (3, 2)", "t = 0 s"});
  }
}

}  // namespace rupture::testing
