// Springs and dampers between blocks, with each choice of them: a plain second account, and the
// limit of small displacements. Their energy is in verification/energy_balance_test.cpp.
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
  /// Displacements of up to `size` [m].
  void shake(double size) {
    Noise noise(size);
    for (Field* u : {&state.u_x, &state.u_z}) noise.fill(*u);
  }
  void elastic() { Bulk(p).elastic(state.u_x, state.u_z, f_x, f_z); }
  void damping() { Bulk(p).damping(state, f_x, f_z); }

  void expect_force(Eigen::Index i, Eigen::Index j, Vector f, double tolerance) const {
    EXPECT_NEAR(f_x(i, j), f.x, tolerance) << i << ", " << j;
    EXPECT_NEAR(f_z(i, j), f.z, tolerance) << i << ", " << j;
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

}  // namespace rupture::testing
