// Springs along the faces that are half as stiff, and dampers that act along their springs.
#include <gtest/gtest.h>

#include <cmath>

#include "rupture/forces/bulk.hpp"
#include "support/sliders.hpp"

namespace rupture {
namespace {

struct Force {
  double x, z;
};

/// Springs and dampers of a moving lattice, each computed apart.
struct Moving {
  explicit Moving(const Parameters& parameters)
      : p(parameters), state(p), f_x(p.Nx, p.Nz), f_z(f_x) {}
  void elastic() { Bulk(p).elastic(state.u_x, state.u_z, f_x, f_z); }
  void damping() { Bulk(p).damping(state, f_x, f_z); }
  void expect_force(Eigen::Index i, Eigen::Index j, Force f, double scale) const {
    EXPECT_NEAR(f_x(i, j), f.x, 1e-14 * scale) << i << ", " << j;
    EXPECT_NEAR(f_z(i, j), f.z, 1e-14 * scale) << i << ", " << j;
  }

  Parameters p;
  State state;
  Field f_x, f_z;
};

/// Of 2 x 2 blocks, the upper right one is drawn to the right by 3/4 l, and moves there with 1 m/s:
/// the spring of its column is 5/4 l long, that of its diagonal sqrt(65)/4 l.
Moving drawn(Parameters p) {
  Moving a(p);
  a.state.u_x(1, 1) = 0.75 * block_spacing(p);
  a.state.v_x(1, 1) = 1.0;
  return a;
}

TEST(EdgeSprings, of_two_by_two_blocks_are_half_as_stiff_unlike_diagonals) {
  for (const EdgeSprings edge : {EdgeSprings::full, EdgeSprings::half}) {
    Parameters p = testing::small_slider(2, 2);
    p.edge_springs = edge;
    Moving a = drawn(p);
    a.elastic();
    const double l = block_spacing(p), k = bulk_stiffness(p), kl = k * l;
    const double face = edge == EdgeSprings::half ? kl / 2.0 : kl;
    const double root = std::sqrt(65.0), stretch = root / 4.0 - std::sqrt(2.0);
    const Force top = {face * 0.75, 0.0}, column = {face * 0.25 * 0.6, face * 0.25 * 0.8};
    const Force diagonal = {kl / 2.0 * stretch * 7.0 / root, kl / 2.0 * stretch * 4.0 / root};
    a.expect_force(0, 0, diagonal, kl);
    a.expect_force(1, 0, column, kl);
    a.expect_force(0, 1, top, kl);
    a.expect_force(1, 1, {-top.x - column.x - diagonal.x, -column.z - diagonal.z}, kl);
    const double energy =
        face * l / 2.0 * (0.75 * 0.75 + 0.25 * 0.25) + kl * l / 4.0 * stretch * stretch;
    EXPECT_NEAR(Bulk(p).elastic_energy(a.state.u_x, a.state.u_z), energy, 1e-14 * kl * l);
  }
}

// Along (1, 0), (3, 4)/5 and (7, 4)/sqrt(65) now; linearised springs keep (0, 1) and (1,
// 1)/sqrt(2).
TEST(DampingAlongSpring, of_two_by_two_blocks_follows_the_direction_of_the_springs) {
  for (const BulkSprings springs : {BulkSprings::exact, BulkSprings::linearised}) {
    Parameters p = testing::small_slider(2, 2);
    p.damping_along = DampingAlong::spring;
    p.springs = springs;
    p.edge_springs = EdgeSprings::half;  // changes no damper
    Moving a = drawn(p);
    a.damping();
    const bool exact = springs == BulkSprings::exact;
    const double eta = damping_coefficient(p);
    const Force column = exact ? Force{9.0 / 25.0, 12.0 / 25.0} : Force{0.0, 0.0};
    const Force diagonal = exact ? Force{49.0 / 65.0, 28.0 / 65.0} : Force{0.5, 0.5};
    a.expect_force(0, 0, {eta * diagonal.x, eta * diagonal.z}, eta);
    a.expect_force(1, 0, {eta * column.x, eta * column.z}, eta);
    a.expect_force(0, 1, {eta, 0.0}, eta);
    a.expect_force(1, 1, {-eta * (1.0 + column.x + diagonal.x), -eta * (column.z + diagonal.z)},
                   eta);
  }
}

/// Sum over the neighbours of block (i, j): springs, or dampers along them.
Force plain_sum(const Moving& a, Eigen::Index i, Eigen::Index j, bool dampers) {
  const Parameters& p = a.p;
  const double l = block_spacing(p);
  Force sum = {0.0, 0.0};
  for (Eigen::Index n = std::max<Eigen::Index>(j - 1, 0); n < std::min(j + 2, p.Nz); ++n) {
    for (Eigen::Index m = std::max<Eigen::Index>(i - 1, 0); m < std::min(i + 2, p.Nx); ++m) {
      if (m == i && n == j) continue;
      const State& s = a.state;
      const double x = static_cast<double>(m - i) * l + s.u_x(m, n) - s.u_x(i, j);
      const double z = static_cast<double>(n - j) * l + s.u_z(m, n) - s.u_z(i, j);
      const bool along_row = n == j && (j == 0 || j == p.Nz - 1);
      const bool along_column = m == i && (i == 0 || i == p.Nx - 1);
      const bool diagonal = m != i && n != j;
      const double k = bulk_stiffness(p) * (diagonal || along_row || along_column ? 0.5 : 1.0);
      const double r = std::hypot(x, z), l_0 = diagonal ? std::sqrt(2.0) * l : l;
      const double speed = ((s.v_x(m, n) - s.v_x(i, j)) * x + (s.v_z(m, n) - s.v_z(i, j)) * z) / r;
      const double force = dampers ? damping_coefficient(p) * speed : k * (r - l_0);
      sum.x += force * x / r;
      sum.z += force * z / r;
    }
  }
  return sum;
}

TEST(EdgeSprings, and_dampers_along_springs_give_the_forces_of_a_plain_sum) {
  for (Eigen::Index Nx = 3; Nx <= 20; ++Nx) {
    for (const Eigen::Index Nz : {2, 3, 5}) {
      Moving a(testing::with_other_bulk(testing::small_slider(Nx, Nz)));
      testing::Noise displacements(0.1 * block_spacing(a.p)), velocities(1.0);
      for (Field* u : {&a.state.u_x, &a.state.u_z}) displacements.fill(*u);
      for (Field* v : {&a.state.v_x, &a.state.v_z}) velocities.fill(*v);
      for (const bool dampers : {false, true}) {
        dampers ? a.damping() : a.elastic();
        const double scale =
            dampers ? damping_coefficient(a.p) : bulk_stiffness(a.p) * block_spacing(a.p);
        for (Eigen::Index j = 0; j < Nz; ++j) {
          for (Eigen::Index i = 0; i < Nx; ++i) {
            a.expect_force(i, j, plain_sum(a, i, j, dampers), scale);
          }
        }
      }
    }
  }
}

TEST(DampingAlongSpring, does_not_resist_a_rigid_rotation_unlike_damping_along_the_velocity) {
  for (const DampingAlong along : {DampingAlong::velocity, DampingAlong::spring}) {
    Parameters p = testing::small_slider(9, 6);
    p.damping_along = along;
    Moving a(p);
    const double l = block_spacing(p), angle = 0.3, rate = 1.0 / l;  // neighbours pass at 1 m/s
    for (Eigen::Index j = 0; j < p.Nz; ++j) {
      for (Eigen::Index i = 0; i < p.Nx; ++i) {
        const double X = static_cast<double>(i) * l, Z = static_cast<double>(j) * l;
        const double x = std::cos(angle) * X - std::sin(angle) * Z;
        const double z = std::sin(angle) * X + std::cos(angle) * Z;
        a.state.u_x(i, j) = x - X;
        a.state.u_z(i, j) = z - Z;
        a.state.v_x(i, j) = -rate * z;
        a.state.v_z(i, j) = rate * x;
      }
    }
    a.damping();
    const double force = a.f_x.blocks().abs().maxCoeff() / damping_coefficient(p);
    if (along == DampingAlong::spring) {
      EXPECT_LT(force, 1e-13);
    } else {
      EXPECT_GT(force, 1.0) << "at the faces";
    }
  }
}

// Stretched along one axis by e and across it by -e/3, only its ends pull back: with E e on
// the area of each block, l B inside and half of that at the corners.
TEST(EdgeSprings, of_half_stiffness_leave_E_and_nu_as_they_are_up_to_the_faces) {
  for (const bool along_x : {true, false}) {
    Parameters p = testing::small_slider(7, 5);
    p.edge_springs = EdgeSprings::half;
    p.springs = BulkSprings::linearised;
    Moving a(p);
    const double l = block_spacing(p), e = 1e-3, pull = p.E * e * l * p.B;
    for (Eigen::Index j = 0; j < p.Nz; ++j) {
      for (Eigen::Index i = 0; i < p.Nx; ++i) {
        a.state.u_x(i, j) = (along_x ? e : -e / 3.0) * static_cast<double>(i) * l;
        a.state.u_z(i, j) = (along_x ? -e / 3.0 : e) * static_cast<double>(j) * l;
      }
    }
    a.elastic();
    for (Eigen::Index j = 0; j < p.Nz; ++j) {
      for (Eigen::Index i = 0; i < p.Nx; ++i) {
        const double side = (i == 0 ? 1.0 : 0.0) - (i == p.Nx - 1 ? 1.0 : 0.0);
        const double end = (j == 0 ? 1.0 : 0.0) - (j == p.Nz - 1 ? 1.0 : 0.0);
        const double corner = side != 0.0 && end != 0.0 ? 0.5 : 1.0;
        const Force f = {along_x ? side * corner * pull : 0.0, along_x ? 0.0 : end * corner * pull};
        a.expect_force(i, j, f, 100.0 * pull);
      }
    }
  }
}

}  // namespace
}  // namespace rupture
