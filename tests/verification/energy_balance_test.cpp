// Energy account of a run: work of driving and load = energy gained + what damping took + work
// against the junctions.
//
// Work is summed by the trapezoidal rule. Then the error of velocity Verlet is known. With G, the
// sum of all forces on a block of mass m, and F, that of springs, support, load and drive,
//   work - energy gained - what was taken = change of the sum of dt^2/(8 m) (G^2 - 2 F G),
// whatever damping and the junctions do. It follows from v' - v = dt/(2m) (G + G') and
// u' - u = dt (v + dt/(2m) G), and is exact where F is linear in u. So linearised springs leave
// rounding errors; those of the slider, which turn, leave more. A damped foundation is left out:
// its power is taken at the half-kicked velocity, which leaves up to 1e-5 of the largest term.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

#include "rupture/dynamics/equilibrium.hpp"
#include "rupture/model/normal_contact.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

Parameters soon_pinned_slider(Law law = Law::reference) {
  Parameters p = quick_slider();  // ruptures after 0.3 ms
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
  std::int64_t broken;  ///< as often, at least, do junctions break; 0: none does
  double taken = 0.5;   ///< least part of the supplied energy that is taken
};

constexpr std::int64_t kAll = 9 * 100;  // junctions; draws are not counted of single springs
const Case kCases[] = {
    {"driven_sticking", soon_pinned_slider(), 0.2e-3, 0.0, 0, 0.0},
    {"driven_through_rupture_and_sliding", soon_pinned_slider(), 1e-3, 0.0, 2 * kAll},
    {"driven_simplified", soon_pinned_slider(Law::simplified), 1e-3, 0.0, 0},
    {"driven_decaying", soon_pinned_slider(Law::decaying), 1e-3, 0.0, kAll},
    {"driven_distance", soon_pinned_slider(Law::distance), 1e-3, 0.0, kAll},
    {"driven_other_bulk", with_other_bulk(soon_pinned_slider()), 1e-3, 0.0, kAll},
    // 160 N on a slider that bears 121 N, and 8 N
    {"pulled_through_rupture", stopped(soon_pinned_slider()), 0.3e-3, 40e-6, kAll, 0.0},
    {"pulled_sticking", stopped(soon_pinned_slider()), 0.3e-3, 2e-6, 0, 0.0},
    // no point moves and the load's work is small: what the event dissipates comes from the springs
    {"event_on_a_prepared_interface", prepared_slider(), 0.3e-3, 0.0, kAll, 0.0},
};

State at_start(const Parameters& p, double pull) {
  if (p.support == Support::ceiling) return prepared_state(p, quick_prestress());
  State state = normal_load_equilibrium(p);
  state.drive.origin_position += pull;
  state.f_x(0, driving_row(p)) += p.K * pull;  // which its block must feel from the start
  return state;
}

/// Sum of dt^2/(8 m) (G^2 - 2 F G) over all blocks [J].
double error_of_scheme(const Simulation& simulation) {
  const Parameters& p = simulation.parameters();
  const State& s = simulation.state();
  Field F_x(p.Nx, p.Nz), F_z(F_x);
  Bulk(p).elastic(s.u_x, s.u_z, F_x, F_z);
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    const NormalContact normal(p, i);
    F_z(i, 0) += normal.normal_force(s.u_z(i, 0));
    F_z(i, p.Nz - 1) -= normal.top_force(s.u_z(i, p.Nz - 1));
  }
  F_x(0, driving_row(p)) += simulation.F_T();
  const auto sum = [](const Field& F, const Field& G) {
    return (G.blocks() * (G.blocks() - 2.0 * F.blocks())).sum();
  };
  return p.dt * p.dt / (8.0 * block_mass(p)) * (sum(F_x, s.f_x) + sum(F_z, s.f_z));
}

/// With their tolerance, relative to the largest term of the account.
constexpr std::pair<BulkSprings, double> kSprings[] = {{BulkSprings::linearised, 1e-12},
                                                       {BulkSprings::exact, 1e-6}};

class EnergyBalanceOf : public ::testing::TestWithParam<std::tuple<Case, double>> {};

TEST_P(EnergyBalanceOf, a_run_has_the_error_of_velocity_verlet) {
  const auto& [run, damping] = GetParam();
  for (const auto& [springs, tolerance] : kSprings) {
    Parameters p = run.p;
    p.damping = damping;
    p.springs = springs;
    Simulation simulation(p, at_start(p, run.pull));
    const Energies before = simulation.energies();
    const double error_before = error_of_scheme(simulation);
    simulation.advance(std::llround(run.duration / p.dt));
    const EnergyBalance balance = energy_balance(before, simulation.energies(), simulation.work());
    const double error = error_of_scheme(simulation) - error_before;
    const double largest = std::abs(balance.error()) / balance.relative_error();
    EXPECT_NEAR(balance.error(), error, tolerance * largest);
    EXPECT_TRUE(p.V > 0.0 ? balance.supplied > 0.0 : balance.supplied != 0.0);
    EXPECT_TRUE(run.taken == 0.0 || balance.taken() > run.taken * balance.supplied);
    const auto broken = static_cast<std::int64_t>(simulation.state().junctions.draws.sum());
    EXPECT_GE(broken, run.broken);
    EXPECT_TRUE(broken == 0 || run.broken > 0) << broken;
  }
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
  p.dt = 1e-7;
  Simulation first(p, normal_load_equilibrium(p));
  while (first.ruptures().empty()) first.advance();
  Simulation second(p, first.state());
  const Energies before = second.energies();
  second.advance(200);
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

}  // namespace rupture::testing
