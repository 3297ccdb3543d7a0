// Energy account of a run: work of driving and load = energy gained + what damping took + work
// against the junctions.
//
// Work is summed by the trapezoidal rule, which is exact for the scheme up to second order in the
// time step, so the error shrinks fourfold when the step is halved: with and without damping, with
// and without driving, and through the rupture of the whole interface.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <tuple>

#include "rupture/dynamics/equilibrium.hpp"
#include "support/sliders.hpp"

namespace rupture {
namespace {

constexpr double kTimeStep = 1e-7;  // [s]

Parameters soon_pinned_slider(Law law = Law::reference) {
  Parameters p = testing::quick_slider();  // ruptures after 0.3 ms
  p.law = law;
  p.t_R = 0.3e-3;  // short slipping times, so that junctions are pinned again
  p.delta_t_R = 0.1e-3;
  return p;
}

Parameters stopped(Parameters p) {
  p.V = 0.0;
  return p;
}

/// A run, with the damping of the reference slider or without any.
struct Case {
  const char* name;
  Parameters p;
  double duration;      ///< [s]
  double pull;          ///< by which the driving spring is drawn at first [m]
  double tolerance;     ///< of the relative error at kTimeStep
  std::int64_t broken;  ///< as often, at least, do junctions break; 0: none does
  double taken = 0.5;   ///< least part of the supplied energy that is taken
};

/// Smooth driving leaves 1e-7 with damping and 7e-7 without; a sudden pull shakes the fastest
/// modes, whose energy velocity Verlet itself gets wrong by (omega dt)^2, and leaves 2e-4. Under
/// the simplified law the friction on a whole block drops at once, which shakes them as well: 6e-6
/// without damping. Under the distance law junctions are pinned while their block is fast, which
/// shakes them less: 1.2e-6. Depinning at once shakes them like a sudden pull.
constexpr double kDriven = 1e-6, kPulled = 3e-4;
constexpr std::int64_t kAll = 9 * 100;  // junctions; draws are not counted of single springs
const Case kCases[] = {
    {"driven_sticking", soon_pinned_slider(), 0.2e-3, 0.0, kDriven, 0, 0.0},
    {"driven_through_rupture_and_sliding", soon_pinned_slider(), 1e-3, 0.0, kDriven, 2 * kAll},
    {"driven_simplified", soon_pinned_slider(Law::simplified), 1e-3, 0.0, 2e-5, 0},
    {"driven_decaying", soon_pinned_slider(Law::decaying), 1e-3, 0.0, kDriven, kAll},
    {"driven_distance", soon_pinned_slider(Law::distance), 1e-3, 0.0, 3e-6, kAll},
    {"driven_other_bulk", testing::with_other_bulk(soon_pinned_slider()), 1e-3, 0.0, kDriven, kAll},
    // 160 N on a slider that bears 121 N, and 8 N
    {"pulled_through_rupture", stopped(soon_pinned_slider()), 0.3e-3, 40e-6, kPulled, kAll, 0.0},
    {"pulled_sticking", stopped(soon_pinned_slider()), 0.3e-3, 2e-6, kPulled, 0, 0.0},
    // no point moves and the load's work is small: what the event dissipates comes from the springs
    {"event_on_a_prepared_interface", testing::prepared_slider(), 0.3e-3, 0.0, kPulled, kAll, 0.0},
};

State at_start(const Parameters& p, double pull) {
  if (p.support == Support::ceiling) return prepared_state(p, testing::quick_prestress());
  State state = normal_load_equilibrium(p);
  state.drive.origin_position += pull;
  state.f_x(0, driving_row(p)) += p.K * pull;  // which its block must feel from the start
  return state;
}

class EnergyBalanceOf : public ::testing::TestWithParam<std::tuple<Case, double>> {};

TEST_P(EnergyBalanceOf, a_run_holds_and_its_error_falls_fourfold_with_half_the_step) {
  const auto& [run, damping] = GetParam();
  std::array<double, 2> errors = {};
  for (const std::size_t n : {0U, 1U}) {
    Parameters p = run.p;
    p.damping = damping;
    p.dt = n == 0 ? kTimeStep : kTimeStep / 2.0;
    Simulation simulation(p, at_start(p, run.pull));
    const Energies before = simulation.energies();
    testing::advance(simulation, std::llround(run.duration / p.dt));
    const EnergyBalance balance = energy_balance(before, simulation.energies(), simulation.work());
    errors[n] = balance.relative_error();
    EXPECT_LT(errors[n], run.tolerance);
    EXPECT_TRUE(p.V > 0.0 ? balance.supplied > 0.0 : balance.supplied != 0.0);
    EXPECT_TRUE(run.taken == 0.0 || balance.taken() > run.taken * balance.supplied);
    const auto broken = static_cast<std::int64_t>(simulation.state().junctions.draws.sum());
    EXPECT_GE(broken, run.broken);
    EXPECT_TRUE(broken == 0 || run.broken > 0) << broken;
  }
  // give or take the few junctions that break a step earlier or later
  EXPECT_GT(errors[0], 3.0 * errors[1]);
}

INSTANTIATE_TEST_SUITE_P(Run, EnergyBalanceOf,
                         ::testing::Combine(::testing::ValuesIn(kCases),
                                            ::testing::Values(0.1, 0.0)),
                         [](const auto& run) {
                           return std::string(std::get<0>(run.param).name) +
                                  (std::get<1>(run.param) > 0.0 ? "_damped" : "_undamped");
                         });

// The account of this short stretch is off by 6e-6 without a restart and 1e-5 with it: the damping
// power at the restart is taken at the full-step velocity. Without that first term it would be
// 3e-3.
TEST(EnergyBalance, of_a_run_that_was_restarted_during_the_rupture) {
  Parameters p = soon_pinned_slider();
  p.dt = kTimeStep;
  Simulation first(p, normal_load_equilibrium(p));
  while (first.ruptures().empty()) first.advance();
  Simulation second(p, first.state());
  const Energies before = second.energies();
  testing::advance(second, 200);
  EXPECT_LT(energy_balance(before, second.energies(), second.work()).relative_error(), 2e-5);
}

TEST(EnergyBalance, compares_the_error_with_the_largest_term) {
  Energies before, after;
  before.load = 5.0;
  after = {1.0, 2.0, 3.0, 4.0, 2.0};  // kinetic, bulk, contact, driving, load
  const Work work = {10.0, 1.5, 0.5};
  const EnergyBalance balance = energy_balance(before, after, work);
  EXPECT_DOUBLE_EQ(balance.supplied, 13.0);  // 10 J of driving and 3 J of the load
  EXPECT_DOUBLE_EQ(balance.stored, 10.0);
  EXPECT_DOUBLE_EQ(balance.damping, 1.5);
  EXPECT_DOUBLE_EQ(balance.junctions, 0.5);
  EXPECT_DOUBLE_EQ(balance.taken(), 2.0);
  EXPECT_DOUBLE_EQ(balance.error(), 1.0);
  EXPECT_DOUBLE_EQ(balance.relative_error(), 1.0 / 13.0);
  EXPECT_EQ(energy_balance(before, before, {}).relative_error(), 0.0);
}

}  // namespace
}  // namespace rupture
