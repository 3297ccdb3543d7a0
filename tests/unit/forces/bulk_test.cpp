// Springs and dampers between blocks, with each choice of them: invariances, a plain second
// account, energy, and the limit of small displacements.
#include "rupture/forces/bulk.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/sliders.hpp"

namespace rupture::testing {

struct Vector {
  double x, z;
};

/// A lattice that is displaced and moves, and the forces of its springs or of its dampers.
struct Lattice {
  explicit Lattice(const Parameters& parameters)
      : p(parameters), state(p), f_x(p.Nx, p.Nz), f_z(f_x) {}

  template <class Visit>
  void each(const Visit& visit) const {
    for (Eigen::Index j = 0; j < p.Nz; ++j) {
      for (Eigen::Index i = 0; i < p.Nx; ++i) visit(i, j);
    }
  }
  /// Sets a vector field from the position of the undeformed block.
  template <class Map>
  void set(Field& x, Field& z, const Map& map) const {
    each([&](Eigen::Index i, Eigen::Index j) {
      const Vector value = map(static_cast<double>(i) * l(), static_cast<double>(j) * l());
      x(i, j) = value.x;
      z(i, j) = value.z;
    });
  }
  template <class Map>
  void displace(const Map& map) {
    set(state.u_x, state.u_z, map);
  }
  /// Displacements of up to `size` [m].
  void shake(double size) {
    Noise noise(size);
    for (Field* u : {&state.u_x, &state.u_z}) noise.fill(*u);
  }
  void elastic() { Bulk(p).elastic(state.u_x, state.u_z, f_x, f_z); }
  void damping() { Bulk(p).damping(state, f_x, f_z); }
  double energy() const { return Bulk(p).elastic_energy(state.u_x, state.u_z); }

  void expect_force(Eigen::Index i, Eigen::Index j, Vector f, double tolerance) const {
    EXPECT_NEAR(f_x(i, j), f.x, tolerance) << i << ", " << j;
    EXPECT_NEAR(f_z(i, j), f.z, tolerance) << i << ", " << j;
  }
  double largest_force() const {
    return std::max(f_x.blocks().abs().maxCoeff(), f_z.blocks().abs().maxCoeff());
  }
  double l() const { return block_spacing(p); }
  double k() const { return bulk_stiffness(p); }
  double eta() const { return damping_coefficient(p); }

  Parameters p;
  State state;
  Field f_x, f_z;
};

Parameters linearised(Parameters p) {
  p.springs = BulkSprings::linearised;
  return p;
}

/// Each choice of springs and dampers, of linearised springs with the other faces and dampers.
std::vector<Parameters> choices(Eigen::Index Nx, Eigen::Index Nz) {
  const Parameters p = small_slider(Nx, Nz), other = with_other_bulk(p);
  return {p, other, linearised(p), linearised(other)};
}

/// Turned by an angle, and turning so fast that neighbours pass at 1 m/s.
Lattice turning(const Parameters& p, double angle) {
  Lattice a(p);
  const double c = std::cos(angle), s = std::sin(angle), rate = 1.0 / a.l();
  a.displace([&](double x, double z) { return Vector{(c - 1) * x - s * z, s * x + (c - 1) * z}; });
  a.set(a.state.v_x, a.state.v_z, [&](double x, double z) {
    return Vector{-rate * (s * x + c * z), rate * (c * x - s * z)};
  });
  return a;
}

TEST(Springs, do_not_resist_a_finite_rotation) {
  for (const double angle : {0.3, -2.0, 3.1}) {
    Lattice a = turning(small_slider(9, 6), angle);
    a.elastic();
    // positions reach 2e-2 m and are rounded to 2e-18 m, or 1e-15 l
    EXPECT_LT(a.largest_force(), 2e-14 * a.k() * a.l()) << angle;
    EXPECT_LT(a.energy(), 1e-26 * a.k() * a.l() * a.l()) << angle;
  }
}

TEST(DampingAlongSpring, does_not_resist_a_rigid_rotation_unlike_damping_along_the_velocity) {
  for (const DampingAlong along : {DampingAlong::velocity, DampingAlong::spring}) {
    Parameters p = small_slider(9, 6);
    p.damping_along = along;
    Lattice a = turning(p, 0.3);
    a.damping();
    if (along == DampingAlong::spring) {
      EXPECT_LT(a.largest_force(), 1e-13 * a.eta());
    } else {
      EXPECT_GT(a.largest_force(), a.eta()) << "at the faces";
    }
  }
}

TEST(Springs, pull_along_the_gradient_of_their_energy) {
  for (const Parameters& p : choices(5, 4)) {
    Lattice a(p);
    a.shake(0.1 * a.l());
    a.elastic();
    const double step = 1e-5 * a.l();  // truncation 1e-10, rounding 1e-16 / 1e-5 of k l
    const auto force = [&](Field& u, Eigen::Index i, Eigen::Index j) {
      const double here = u(i, j);
      u(i, j) = here + step;
      const double above = a.energy();
      u(i, j) = here - step;
      const double below = a.energy();
      u(i, j) = here;
      return -(above - below) / (2.0 * step);
    };
    a.each([&](Eigen::Index i, Eigen::Index j) {
      const Vector f = {force(a.state.u_x, i, j), force(a.state.u_z, i, j)};
      a.expect_force(i, j, f, 1e-8 * a.k() * a.l());
    });
  }
}

/// Sum over the up to 8 neighbours of block (i, j): springs, or dampers. Linearised ones keep the
/// directions that they had at first.
Vector plain_sum(const Lattice& a, Eigen::Index i, Eigen::Index j, bool dampers) {
  const Parameters& p = a.p;
  const State& s = a.state;
  const bool half_edges = p.edge_springs == EdgeSprings::half;
  const bool linear = p.springs == BulkSprings::linearised;
  Vector sum = {0.0, 0.0};
  for (Eigen::Index n = std::max<Eigen::Index>(j - 1, 0); n < std::min(j + 2, p.Nz); ++n) {
    for (Eigen::Index m = std::max<Eigen::Index>(i - 1, 0); m < std::min(i + 2, p.Nx); ++m) {
      if (m == i && n == j) continue;
      const Vector at_first = {static_cast<double>(m - i) * a.l(),
                               static_cast<double>(n - j) * a.l()};
      const Vector u = {s.u_x(m, n) - s.u_x(i, j), s.u_z(m, n) - s.u_z(i, j)};
      const double x = at_first.x + (linear ? 0.0 : u.x), z = at_first.z + (linear ? 0.0 : u.z);
      const Vector v = {s.v_x(m, n) - s.v_x(i, j), s.v_z(m, n) - s.v_z(i, j)};
      const bool along_row = n == j && (j == 0 || j == p.Nz - 1);
      const bool along_column = m == i && (i == 0 || i == p.Nx - 1);
      const bool diagonal = m != i && n != j;
      const bool half = diagonal || (half_edges && (along_row || along_column));
      const double r = std::hypot(x, z), l_0 = std::hypot(at_first.x, at_first.z);
      const double stretch = linear ? (x * u.x + z * u.z) / l_0 : r - l_0;
      const double stretching = a.k() * (half ? 0.5 : 1.0) * stretch;
      const double force = dampers ? a.eta() * (v.x * x + v.z * z) / r : stretching;
      const bool along_velocity = dampers && p.damping_along == DampingAlong::velocity;
      sum.x += along_velocity ? a.eta() * v.x : force * x / r;
      sum.z += along_velocity ? a.eta() * v.z : force * z / r;
    }
  }
  return sum;
}

// Vector loops read and write 2, 4 or 8 blocks at once: rows of every length.
TEST(Bulk, gives_the_forces_of_a_plain_sum_over_neighbours) {
  for (Eigen::Index Nx = 2; Nx <= 20; ++Nx) {
    for (const Eigen::Index Nz : {2, 3, 5}) {
      for (const Parameters& p : choices(Nx, Nz)) {
        Lattice a(p);
        a.shake(0.1 * a.l());
        Noise velocities(1.0);
        for (Field* v : {&a.state.v_x, &a.state.v_z}) velocities.fill(*v);
        for (const bool dampers : {false, true}) {
          dampers ? a.damping() : a.elastic();
          const double scale = dampers ? a.eta() : a.k() * a.l();
          a.each([&](Eigen::Index i, Eigen::Index j) {
            a.expect_force(i, j, plain_sum(a, i, j, dampers), 1e-14 * scale);
          });
        }
      }
    }
  }
}

/// Of 2 x 2 blocks, the upper right one has moved to the right by 3/4 l and goes on at 1 m/s: its
/// springs are 7/4, 5/4 and sqrt(65)/4 l long, along (1, 0), (3, 4)/5 and (7, 4)/sqrt(65).
TEST(Bulk, of_two_by_two_blocks_with_half_edges_and_damping_along_springs_is_as_by_hand) {
  Lattice a(with_other_bulk(small_slider(2, 2)));
  a.state.u_x(1, 1) = 0.75 * a.l();
  a.state.v_x(1, 1) = 1.0;
  const auto expect = [&](Eigen::Index i, Eigen::Index j, Vector f, double unit) {
    a.expect_force(i, j, {f.x * unit, f.z * unit}, 1e-14 * unit);
  };
  const double kl = a.k() * a.l();
  a.elastic();
  expect(0, 1, {0.375, 0.0}, kl);  // (7/4 - 1)/2
  expect(1, 0, {0.075, 0.1}, kl);  // (5/4 - 1)/2 along (3, 4)/5
  // (sqrt(65)/4 - sqrt(2))/2 along (7, 4)/sqrt(65)
  expect(0, 0, {0.2610593864850795, 0.1491767922771883}, kl);
  expect(1, 1, {-0.7110593864850795, -0.2491767922771883}, kl);
  a.damping();
  expect(0, 1, {1.0, 0.0}, a.eta());
  expect(1, 0, {0.36, 0.48}, a.eta());                              // 3/5 along (3, 4)/5
  expect(0, 0, {0.7538461538461538, 0.4307692307692308}, a.eta());  // 7/sqrt(65) of that direction
  expect(1, 1, {-2.113846153846154, -0.9107692307692308}, a.eta());
}

/// Force on the right one of two blocks that have been drawn apart to (1 + e) times their distance.
double pull(double e) {
  Lattice a(small_slider(3, 2));
  for (Eigen::Index j = 0; j < 2; ++j) a.state.u_x(2, j) = e * a.l();
  a.elastic();
  return a.f_x(2, 1);
}

/// These forces in closed form: one spring k along x, one k/2 along the diagonal.
double exact_pull(double e) {
  const Parameters p = small_slider(3, 2);
  const double k = bulk_stiffness(p), l = block_spacing(p);
  const long double E = e, r = std::sqrt((1.0L + E) * (1.0L + E) + 1.0L), root = std::sqrt(2.0L);
  // r - sqrt(2) = ((1+E)^2 - 1) / (r + sqrt(2))
  const long double diagonal = 0.5L * ((2.0L + E) * E / (r + root)) * (1.0L + E) / r;
  return static_cast<double>(-static_cast<long double>(k) * static_cast<long double>(l) *
                             (E + diagonal));
}

TEST(Springs, keep_their_digits_where_the_series_ends) {
  // s = 2 e + e^2 on either side of 1/400, and far beyond
  for (const double e : {1e-13, 1e-9, -1e-6, 1e-4, 1e-3, -1.2e-3, 1.24e-3, 1.249e-3, 1.2501e-3,
                         -1.2515e-3, 2e-3, -0.01, 0.1, -0.3}) {
    EXPECT_NEAR(pull(e) / exact_pull(e), 1.0, 8e-16) << e;
  }
}

// Stretched along one axis by e and across it by -e/3, only its ends pull back: with E e on
// the area of each block, l B inside and half of that at the corners.
TEST(EdgeSprings, of_half_stiffness_leave_E_and_nu_as_they_are_up_to_the_faces) {
  for (const bool along_x : {true, false}) {
    Parameters p = linearised(small_slider(7, 5));
    p.edge_springs = EdgeSprings::half;
    Lattice a(p);
    const double e = 1e-3, pull = p.E * e * a.l() * p.B;
    a.displace([&](double x, double z) {
      return along_x ? Vector{e * x, -e / 3.0 * z} : Vector{-e / 3.0 * x, e * z};
    });
    a.elastic();
    a.each([&](Eigen::Index i, Eigen::Index j) {
      const double side = (i == 0 ? 1.0 : 0.0) - (i == p.Nx - 1 ? 1.0 : 0.0);
      const double end = (j == 0 ? 1.0 : 0.0) - (j == p.Nz - 1 ? 1.0 : 0.0);
      const double corner = side != 0.0 && end != 0.0 ? 0.5 : 1.0;
      const Vector f = {along_x ? side * corner * pull : 0.0, along_x ? 0.0 : end * corner * pull};
      a.expect_force(i, j, f, 1e-12 * pull);
    });
  }
}

}  // namespace rupture::testing
