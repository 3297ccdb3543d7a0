// The lattice is the isotropic plane-stress solid it stands for: E as given, Poisson ratio 1/3, and
// the wave speeds that follow.
//
// A block of mass m stands for an area l^2 of the solid, also at the surface, so the density of the
// lattice is rho = m / (l^2 B). It differs from M / (L H B) by the half cells that stick out at the
// sides, (1 + 1/(Nx-1)) (1 + 1/(Nz-1)) - 1 = 5 % at reference size.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "support/sliders.hpp"

namespace rupture::testing {

using std::numbers::pi;

double lattice_density(const Parameters& p) {
  return block_mass(p) / (block_spacing(p) * block_spacing(p) * p.B);
}
double shear_speed(const Parameters& p) {  // sqrt(G / rho), G = E / (2 (1 + nu))
  return std::sqrt(p.E / (2.0 * (1.0 + kPoissonRatio)) / lattice_density(p));
}
double longitudinal_speed(const Parameters& p) {  // plane stress, no lateral strain
  return std::sqrt(p.E / (1.0 - kPoissonRatio * kPoissonRatio) / lattice_density(p));
}

/// Speed of a plane wave with |q| l = ql along `direction`, from the force that it exerts on one
/// block of an endless lattice: u = A e cos(q.r), m omega^2 A = -F.e at r = 0, c = omega / q.
double plane_wave_speed(double ql, double direction, double polarization) {
  const Parameters p = small_slider(5, 5);
  const double l = block_spacing(p), q = ql / l;
  const double A = 1e-9 * l;  // small enough to be linear
  const double e_x = std::cos(polarization), e_z = std::sin(polarization);
  Field u_x(5, 5), u_z(u_x), f_x(u_x), f_z(u_x);
  for (Eigen::Index j = 0; j < 5; ++j) {
    for (Eigen::Index i = 0; i < 5; ++i) {
      const double x = static_cast<double>(i - 2) * l, z = static_cast<double>(j - 2) * l;
      const double wave = A * std::cos(q * (x * std::cos(direction) + z * std::sin(direction)));
      u_x(i, j) = e_x * wave;
      u_z(i, j) = e_z * wave;
    }
  }
  Bulk(p).elastic(u_x, u_z, f_x, f_z);
  const double omega2 = -(f_x(2, 2) * e_x + f_z(2, 2) * e_z) / (block_mass(p) * A);
  return std::sqrt(omega2) / q;
}

class PlaneWave : public ::testing::TestWithParam<double> {};

// A lattice wave is slower than that of the continuum by about (ql)^2/24 of its speed, which is
// 0.1 % at 40 blocks per wavelength, and less between the axes.
constexpr double kBlocksPerWave = 40;
constexpr double kDispersion = (2.0 * pi / kBlocksPerWave) * (2.0 * pi / kBlocksPerWave) / 24.0;

void expect_speed(double c, double direction, double polarization) {
  const double coarse =
      plane_wave_speed(2.0 * pi / kBlocksPerWave, direction, polarization) / c - 1;
  const double fine = plane_wave_speed(pi / kBlocksPerWave, direction, polarization) / c - 1;
  EXPECT_NEAR(coarse, 0.0, 1.6 * kDispersion);
  EXPECT_NEAR(fine, coarse / 4.0, 0.01 * kDispersion) << "it vanishes with (ql)^2";
}

TEST_P(PlaneWave, has_the_plane_stress_speed_if_longitudinal_and_that_of_shear_if_transverse) {
  expect_speed(longitudinal_speed(small_slider(5, 5)), GetParam(), GetParam());
  expect_speed(shear_speed(small_slider(5, 5)), GetParam(), GetParam() + pi / 2.0);
}

// along x, along z, along the diagonal and between: the solid is isotropic
INSTANTIATE_TEST_SUITE_P(Directions, PlaneWave,
                         ::testing::Values(0.0, pi / 2.0, pi / 4.0, 0.3, 2.5));

/// Half a period of one mode of a free plate: the time between the first two zeros of `amplitude`.
/// Not a number if they do not come within 1 ms, several periods of every mode here.
double half_period(const Parameters& p, State state,
                   const std::function<double(const State&)>& amplitude) {
  Simulation simulation(p, std::move(state));
  double first_zero = 0.0, before = amplitude(simulation.state());
  while (simulation.time() < 1e-3) {
    simulation.advance();
    const double now = amplitude(simulation.state());
    if ((now > 0.0) != (before > 0.0)) {
      const double zero = simulation.time() - p.dt * now / (now - before);
      if (first_zero > 0.0) return zero - first_zero;
      first_zero = zero;
    }
    before = now;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

constexpr double kAmplitude = 1e-9;  // [m], strains of 1e-7

/// Speed of the lowest standing wave through the height, uniform along x, u = A cos(pi (j + 1/2) /
/// Nz). The plate is so long that nothing from its sides reaches the middle column in 3/4 period.
double standing_wave_speed(const Parameters& p, Field State::*u) {
  const auto shape = [&](Eigen::Index j) {
    return std::cos(pi * (static_cast<double>(j) + 0.5) / static_cast<double>(p.Nz));
  };
  State state = lifted(p);
  for (Eigen::Index j = 0; j < p.Nz; ++j) (state.*u).blocks().row(j) += kAmplitude * shape(j);
  const double t = half_period(p, state, [&](const State& now) {
    double sum = 0.0;
    for (Eigen::Index j = 0; j < p.Nz; ++j) sum += (now.*u)(p.Nx / 2, j) * shape(j);
    return sum;
  });
  return static_cast<double>(p.Nz) * block_spacing(p) / t;
}

TEST(StandingWave, through_the_height_has_speed_c_s_in_shear_and_c_L_in_compression) {
  const Parameters p = free_plate(101, 17);
  constexpr double tolerance = 0.002;  // dispersion at half a wave in 17 blocks: (pi/17)^2/24
  EXPECT_NEAR(standing_wave_speed(p, &State::u_x) / shear_speed(p), 1.0, tolerance);
  EXPECT_NEAR(standing_wave_speed(p, &State::u_z) / longitudinal_speed(p), 1.0, tolerance);
}

TEST(StaticStretch, SLOW_has_poisson_ratio_one_third_and_youngs_modulus_E) {
  // Both ends of a free strip are pulled until the mean strain is 1e-6; relaxed with a drag on
  // every block.
  const Parameters p = small_slider(41, 7);
  const double l = block_spacing(p);
  // The surface rows have whole springs k but only one layer of diagonals, so that Nz rows act like
  // Nz - 1/4 rows of the solid.
  const double pull = 1e-6 * p.E * p.B * l * (static_cast<double>(p.Nz) - 0.25);
  const double drag = 0.1 * damping_coefficient(p);
  Bulk bulk(p);
  State state(p);
  for (int n = 0; n < 20000; ++n) {
    plain_step(p, p.dt, bulk, state, [&](State& s) {
      s.f_x.blocks().col(0) -= pull / static_cast<double>(p.Nz);
      s.f_x.blocks().col(p.Nx - 1) += pull / static_cast<double>(p.Nz);
      s.f_x.blocks() -= drag * s.v_x.blocks();
      s.f_z.blocks() -= drag * s.v_z.blocks();
    });
  }
  ASSERT_LT(state.v_x.blocks().abs().maxCoeff(), 1e-15) << "not at rest";
  // in the middle, three heights from the ends
  const Eigen::Index i = p.Nx / 2;
  const double strain_x = (state.u_x(i + 1, 3) - state.u_x(i - 1, 3)) / (2.0 * l);
  const double strain_z = (state.u_z(i, p.Nz - 1) - state.u_z(i, 0)) / p.H;
  EXPECT_NEAR(-strain_z / strain_x, 1.0 / 3.0, 1e-5);
  EXPECT_NEAR(strain_x, 1e-6, 1e-6 * 1e-5);
}

}  // namespace rupture::testing
