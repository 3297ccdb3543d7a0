// Order of convergence of velocity Verlet in the time step.
//
// Without damping the scheme is of second order. With damping it is of first order: the damping
// force at t_{n+1} uses the half-kicked velocity, that of t_{n+1/2}. (Where junctions break, the
// time of the break is rounded up to a step, which is of first order too; here none breaks.)
#include <gtest/gtest.h>

#include <cmath>

#include "rupture/dynamics/equilibrium.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

/// Driven at 0.1 m/s with junctions that cannot break, in time steps of dt.
Parameters unbroken(Parameters p, double dt) {
  p.dt = dt;
  p.mu_s = 100.0;
  p.V = 0.1;
  return p;
}

State after_another_80_us(const Parameters& p, const State& state) {
  Simulation simulation(p, state);
  simulation.advance(std::llround(80e-6 / p.dt));
  return simulation.state();
}

/// From a smooth velocity field.
State slider_after_80_us(Parameters p, double dt) {
  p = unbroken(p, dt);
  State state = normal_load_equilibrium(p);
  for (Eigen::Index j = 0; j < p.Nz; ++j) {
    for (Eigen::Index i = 0; i < p.Nx; ++i) {
      const double x = static_cast<double>(i) / static_cast<double>(p.Nx - 1);
      const double z = static_cast<double>(j) / static_cast<double>(p.Nz - 1);
      state.v_x(i, j) = 0.05 * std::sin(2.0 * x + 3.0 * z + 0.3);
      state.v_z(i, j) = 0.05 * std::cos(3.0 * x - z + 1.0);
    }
  }
  return after_another_80_us(p, state);
}

/// That, and then 80 us in other steps.
State continued(const Parameters& p, double first_dt, double dt) {
  const Parameters after = unbroken(p, dt);
  return after_another_80_us(after, rupture::continued(slider_after_80_us(p, first_dt), after));
}

double distance(const Field& a, const Field& b) {
  return std::sqrt((a.blocks() - b.blocks()).square().sum());
}

/// Halving the time step reduces the error by a factor of 2^order. `run(dt)` gives the state at the
/// end.
template <class Run>
void expect_order(const Run& run, double order, double tolerance) {
  const State coarse = run(1e-7), middle = run(0.5e-7), fine = run(0.25e-7);
  for (Field State::*u : {&State::u_x, &State::v_x}) {
    const double factor = distance(coarse.*u, middle.*u) / distance(middle.*u, fine.*u);
    EXPECT_NEAR(std::log2(factor), order, tolerance);
  }
}

TEST(VelocityVerlet, is_of_second_order_without_damping_and_of_first_order_with_it) {
  Parameters p = small_slider(9, 5);
  const auto run = [&](double dt) { return slider_after_80_us(p, dt); };
  expect_order(run, 1.0, 0.05);
  p.damping = 0.0;
  expect_order(run, 2.0, 0.02);
  const auto after_other_steps = [&](double dt) { return continued(p, 2e-7, dt); };
  expect_order(after_other_steps, 2.0, 0.02);
}

}  // namespace rupture::testing
