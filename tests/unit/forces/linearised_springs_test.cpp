// Bulk springs that are linearised for small displacements.
#include <gtest/gtest.h>

#include <cmath>

#include "rupture/dynamics/equilibrium.hpp"
#include "support/sliders.hpp"

namespace rupture {
namespace {

Parameters linearised(std::int64_t Nx, std::int64_t Nz) {
  Parameters p = testing::small_slider(Nx, Nz);
  p.springs = BulkSprings::linearised;
  return p;
}

struct Forces {
  Forces(const Parameters& p, const Field& u_x, const Field& u_z) : x(p.Nx, p.Nz), z(x) {
    Bulk(p).elastic(u_x, u_z, x, z);
  }
  double largest() const {
    return std::max(x.blocks().abs().maxCoeff(), z.blocks().abs().maxCoeff());
  }
  double distance(const Forces& other, double factor) const {
    return std::max((factor * x.blocks() - other.x.blocks()).abs().maxCoeff(),
                    (factor * z.blocks() - other.z.blocks()).abs().maxCoeff());
  }
  Field x, z;
};

/// Displacements of up to `size` [m].
std::pair<Field, Field> noise(const Parameters& p, double size) {
  std::pair<Field, Field> u = {Field(p.Nx, p.Nz), Field(p.Nx, p.Nz)};
  testing::Noise numbers(size);
  numbers.fill(u.first);
  numbers.fill(u.second);
  return u;
}

TEST(LinearisedSprings, pull_a_displaced_block_back_along_the_undeformed_bonds) {
  const Parameters p = linearised(3, 3);
  const double k = bulk_stiffness(p), d = 5e-4;  // a fifth of the spacing
  Field x(3, 3), z(3, 3);
  x(1, 1) = d;
  const Forces f(p, x, z);
  EXPECT_NEAR(f.x(1, 1), -3.0 * k * d, 1e-12 * k * d) << "two along x, four diagonals of k/4";
  EXPECT_NEAR(f.z(1, 1), 0.0, 1e-12 * k * d);
  EXPECT_NEAR(f.x(2, 1), k * d, 1e-12 * k * d);
  EXPECT_NEAR(f.z(2, 1), 0.0, 1e-12 * k * d);
  EXPECT_NEAR(f.x(1, 2), 0.0, 1e-12 * k * d) << "a spring that is drawn aside does not pull";
  EXPECT_NEAR(f.x(2, 2), 0.25 * k * d, 1e-12 * k * d);
  EXPECT_NEAR(f.z(2, 2), 0.25 * k * d, 1e-12 * k * d);
}

TEST(LinearisedSprings, pull_in_proportion_to_the_displacement) {
  const Parameters p = linearised(9, 6);
  const auto [x, z] = noise(p, 1e-4);
  const auto [x_8, z_8] = noise(p, 8e-4);
  const Forces f(p, x, z), f_8(p, x_8, z_8);
  EXPECT_LT(f.distance(f_8, 8.0), 1e-13 * f_8.largest());
  const Forces exact(testing::small_slider(9, 6), x_8, z_8);
  EXPECT_GT(f_8.distance(exact, 1.0), 0.1 * exact.largest());
}

TEST(LinearisedSprings, are_the_limit_of_small_displacements) {
  const Parameters p = linearised(9, 6);
  for (const double size : {1e-7, 1e-8}) {
    const auto [x, z] = noise(p, size);
    const Forces f(p, x, z), exact(testing::small_slider(9, 6), x, z);
    EXPECT_LT(f.distance(exact, 1.0), 10.0 * size / block_spacing(p) * exact.largest());
  }
}

TEST(LinearisedSprings, store_half_the_work_of_their_final_forces) {
  const Parameters p = linearised(9, 6);
  const auto [x, z] = noise(p, 8e-4);
  const Forces f(p, x, z);
  const double work = -(f.x.blocks() * x.blocks() + f.z.blocks() * z.blocks()).sum();
  EXPECT_NEAR(Bulk(p).elastic_energy(x, z), 0.5 * work, 1e-12 * work);
}

TEST(LinearisedSprings, have_an_equilibrium_in_which_nothing_moves) {
  Parameters p = linearised(9, 5);
  p.V = 0.0;
  Simulation simulation(p, normal_load_equilibrium(p));
  simulation.advance(1000);
  EXPECT_LT(simulation.state().v_x.blocks().abs().maxCoeff(), 1e-12);
  EXPECT_LT(simulation.state().v_z.blocks().abs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace rupture
