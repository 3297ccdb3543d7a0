// stable_time_step() is where the stability of velocity Verlet ends.
//
// The formula takes the wave vector (pi, 0), which a finite lattice reaches only in the limit: 17 x
// 17 blocks become unstable 1 % above the limit.
#include <gtest/gtest.h>

#include "rupture/dynamics/equilibrium.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

/// Factor by which 3000 steps multiply the kinetic energy of a free plate that starts from noise.
/// (Not a Simulation, which refuses time steps above the limit.)
double growth(const Parameters& p, double dt) {
  Bulk bulk(p);
  State state(p);
  Noise noise(1e-9);
  noise.fill(state.v_x);
  noise.fill(state.v_z);
  const double before = bulk.kinetic_energy(state.v_x, state.v_z);
  for (int n = 0; n < 3000; ++n) plain_step(p, dt, bulk, state, [](State&) {});
  return bulk.kinetic_energy(state.v_x, state.v_z) / before;
}

class TimeStepLimit : public ::testing::TestWithParam<double> {};

TEST_P(TimeStepLimit, SLOW_of_a_free_plate_is_sharp) {
  Parameters p = free_plate(21, 21);
  p.damping = GetParam();
  for (const Parameters& plate : {p, with_other_bulk(p)}) {
    const double limit = stable_time_step(plate);
    EXPECT_LT(growth(plate, limit), 1.0);
    EXPECT_FALSE(growth(plate, 1.01 * limit) < 1e6);  // or not a number
  }
}

INSTANTIATE_TEST_SUITE_P(Damping, TimeStepLimit, ::testing::Values(0.0, 0.1, 1.0));

/// That factor for a pressed slider without damping, with pinned junctions, at the limit.
double growth_at_the_limit(Parameters p) {
  p.damping = 0.0;
  p.mu_s = 100.0;  // nothing breaks
  p.V = 0.0;
  p.dt = stable_time_step(p);
  State state = normal_load_equilibrium(p);
  Noise noise(1e-6);
  noise.fill(state.v_x);
  noise.fill(state.v_z);
  Simulation simulation(p, state);
  const double before = simulation.energies().kinetic;
  simulation.advance(3000);
  return simulation.energies().kinetic / before;
}

TEST(TimeStepLimit, holds_with_foundation_junctions_and_driving_spring) {
  const Parameters reference = small_slider(9, 5);
  Parameters stiff_junctions = reference, stiff_foundation = reference, stiff_spring = reference;
  stiff_junctions.kappa = 1e4 * reference.kappa[0];
  stiff_foundation.foundation = 100.0;
  stiff_spring.K = 1e9;
  Parameters damped_foundation = stiff_foundation;
  damped_foundation.foundation_damping = 10.0;
  Parameters both = stiff_junctions;  // at h = 0 on the same block, where their stiffnesses add
  both.h = 0.0;
  both.K =
      static_cast<double>(both.N_s) * junction_stiffness(both, 0, 4.0 * mean_normal_force(both));
  for (const auto& p :
       {reference, stiff_junctions, stiff_foundation, damped_foundation, stiff_spring, both}) {
    EXPECT_LT(growth_at_the_limit(p), 2.0);
  }
}

}  // namespace rupture::testing
