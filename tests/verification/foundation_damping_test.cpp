// Dashpots of the foundation: a slider that swings on a soft foundation is a damped oscillator.
#include <gtest/gtest.h>

#include <cmath>

#include "rupture/dynamics/equilibrium.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

constexpr double v_0 = 4e-4;  // [m/s]

/// Speed of a column of mass M_c on its spring and dashpot, sent off from its rest with v_0.
double oscillator(const Parameters& p, double t) {
  const double M_c = static_cast<double>(p.Nz) * block_mass(p);
  const double gamma = foundation_damping_coefficient(p) / (2.0 * M_c);
  const double omega = std::sqrt(foundation_stiffness(p) / M_c - gamma * gamma);
  return v_0 * std::exp(-gamma * t) * (std::cos(omega * t) - gamma / omega * std::sin(omega * t));
}

TEST(FoundationDamping, lets_a_slider_swing_out_as_a_damped_oscillator) {
  // On a foundation 10,000 times softer than the bulk it moves as a whole; always pressed.
  Parameters p = small_slider(9, 5);
  p.K = p.V = 0.0;
  p.F_N = 9e-3;
  p.foundation = 1e-4;
  p.foundation_damping = 0.2;
  State start = normal_load_equilibrium(p);
  start.v_z.blocks() = v_0;
  Simulation simulation(p, start);
  const Energies before = simulation.energies();
  for (int n = 0; n < 15; ++n) {  // a period has 12,500 steps
    simulation.advance(1000);
    const double v = simulation.state().v_z.blocks().mean();
    EXPECT_NEAR(v, oscillator(p, simulation.time()), 2e-3 * v_0) << n;
  }
  const EnergyBalance balance = energy_balance(before, simulation.energies(), simulation.work());
  EXPECT_GT(balance.damping, 0.5 * before.kinetic);
  EXPECT_LT(std::abs(balance.error()), 1e-3 * before.kinetic);
}

TEST(FoundationDamping, never_pulls_and_leaves_a_block_without_contact_alone) {
  Parameters p = free_plate(9, 5);
  p.foundation_damping = 1.0;
  for (const double u_z : {1e-3, -1e-6}) {  // in the air, and pressed, with p < eta_f v
    State start(p);
    start.u_z.blocks() = u_z;
    start.v_z.blocks() = 1.0;
    Simulation simulation(p, start);
    simulation.advance(3);
    EXPECT_NEAR(simulation.state().v_z(4, 0), 1.0, 1e-9);
  }
}

}  // namespace rupture::testing
