// Springs and dampers between blocks: invariances, a plain second account, energy and padding.
#include "rupture/forces/bulk.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/sliders.hpp"

namespace rupture {
namespace {

using testing::Noise;
using testing::small_slider;

struct Vector {
  double x, z;
};

/// Displacements, velocities and forces of one lattice, and what they add up to.
struct Lattice {
  explicit Lattice(const Parameters& parameters)
      : p(parameters), bulk(p), x(p.Nx, p.Nz), z(x), f_x(x), f_z(x) {}

  template <class Visit>
  void each(const Visit& visit) const {
    for (Eigen::Index j = 0; j < p.Nz; ++j) {
      for (Eigen::Index i = 0; i < p.Nx; ++i) visit(i, j);
    }
  }
  /// Sets the vector field (x, z) from the position of the undeformed block.
  template <class Map>
  void set(const Map& map) {
    each([&](Eigen::Index i, Eigen::Index j) {
      const Vector value = map(static_cast<double>(i) * l(), static_cast<double>(j) * l());
      x(i, j) = value.x;
      z(i, j) = value.z;
    });
  }
  void set_noise(double size) {
    Noise noise(size);
    noise.fill(x);
    noise.fill(z);
  }
  void elastic() { bulk.elastic(x, z, f_x, f_z); }
  void damping() {
    State state(p);
    state.v_x = x;
    state.v_z = z;
    bulk.damping(state, f_x, f_z);
  }
  double largest_force() const {
    return std::max(f_x.blocks().abs().maxCoeff(), f_z.blocks().abs().maxCoeff());
  }
  double l() const { return block_spacing(p); }
  double k() const { return bulk_stiffness(p); }

  Parameters p;
  Bulk bulk;
  Field x, z, f_x, f_z;
};

TEST(Springs, do_not_resist_a_translation) {
  Lattice a(small_slider(9, 6));
  a.set([](double, double) { return Vector{0.125, -0.5}; });  // differences vanish exactly
  a.elastic();
  EXPECT_EQ(a.largest_force(), 0.0);
  EXPECT_EQ(a.bulk.elastic_energy(a.x, a.z), 0.0);
}

TEST(Springs, do_not_resist_a_finite_rotation) {
  Lattice a(small_slider(9, 6));
  for (const double angle : {0.3, -2.0, 3.1}) {
    const double c = std::cos(angle), s = std::sin(angle);
    a.set([&](double x, double z) { return Vector{(c - 1) * x - s * z, s * x + (c - 1) * z}; });
    a.elastic();
    // positions reach 2e-2 m and are rounded to 2e-18 m, or 1e-15 l
    EXPECT_LT(a.largest_force(), 2e-14 * a.k() * a.l()) << angle;
    EXPECT_LT(a.bulk.elastic_energy(a.x, a.z), 1e-26 * a.k() * a.l() * a.l()) << angle;
  }
}

TEST(Springs, pull_along_the_gradient_of_their_energy) {
  Lattice a(small_slider(5, 4));
  a.set_noise(0.1 * a.l());
  a.elastic();
  const double step = 1e-5 * a.l();  // truncation 1e-10, rounding 1e-16 / 1e-5 of k l
  const auto force = [&](Field& u, Eigen::Index i, Eigen::Index j) {
    const double here = u(i, j);
    u(i, j) = here + step;
    const double above = a.bulk.elastic_energy(a.x, a.z);
    u(i, j) = here - step;
    const double below = a.bulk.elastic_energy(a.x, a.z);
    u(i, j) = here;
    return -(above - below) / (2.0 * step);
  };
  a.each([&](Eigen::Index i, Eigen::Index j) {
    EXPECT_NEAR(a.f_x(i, j), force(a.x, i, j), 1e-8 * a.k() * a.l());
    EXPECT_NEAR(a.f_z(i, j), force(a.z, i, j), 1e-8 * a.k() * a.l());
  });
}

TEST(Bulk, knows_the_kinetic_energy) {
  Lattice a(small_slider(4, 3));
  a.set([](double, double) { return Vector{3.0, 4.0}; });
  EXPECT_DOUBLE_EQ(a.bulk.kinetic_energy(a.x, a.z), 0.5 * a.p.M * 25.0);
}

/// Sum of `bond(di, dj)` over the up to 8 neighbours of block (i, j).
template <class Bond>
Vector over_neighbours(const Lattice& a, Eigen::Index i, Eigen::Index j, const Bond& bond) {
  Vector sum = {0.0, 0.0};
  for (int dj = -1; dj <= 1; ++dj) {
    for (int di = -1; di <= 1; ++di) {
      const bool exists = i + di >= 0 && i + di < a.p.Nx && j + dj >= 0 && j + dj < a.p.Nz;
      if (!exists || (di == 0 && dj == 0)) continue;
      const Vector f = bond(di, dj);
      sum.x += f.x;
      sum.z += f.z;
    }
  }
  return sum;
}

/// Vector loops read and write 2, 4 or 8 blocks at once; whatever the length of a row, nothing may
/// leak over its end.
template <class Check>
void for_row_lengths(const Check& check) {
  for (Eigen::Index Nx = 3; Nx <= 20; ++Nx) {
    SCOPED_TRACE(Nx);
    check(Nx);
  }
}

/// Elastic and damping forces, of displacements or velocities, against plain sums.
template <class Bond>
void expect_plain_sum(Lattice& a, double scale, const Bond& bond) {
  a.each([&](Eigen::Index i, Eigen::Index j) {
    const Vector f = over_neighbours(a, i, j, [&](int di, int dj) {
      return bond(di, dj, a.x(i + di, j + dj) - a.x(i, j), a.z(i + di, j + dj) - a.z(i, j));
    });
    EXPECT_NEAR(a.f_x(i, j), f.x, 1e-14 * scale);
    EXPECT_NEAR(a.f_z(i, j), f.z, 1e-14 * scale);
  });
}

TEST(RowLengths, give_the_forces_of_a_plain_sum_over_neighbours) {
  for_row_lengths([](Eigen::Index Nx) {
    for (const Eigen::Index Nz : {2, 3, 5}) {
      Lattice a(small_slider(Nx, Nz));
      a.set_noise(0.1 * a.l());
      a.elastic();
      expect_plain_sum(a, a.k() * a.l(), [&](int di, int dj, double dx, double dz) {
        const double k = di != 0 && dj != 0 ? a.k() / 2.0 : a.k();
        const double r_x = di * a.l() + dx, r_z = dj * a.l() + dz, r = std::hypot(r_x, r_z);
        const double f = k * (r - std::hypot(di, dj) * a.l());
        return Vector{f * r_x / r, f * r_z / r};
      });
      a.set_noise(1.0);
      a.damping();
      const double eta = damping_coefficient(a.p);
      expect_plain_sum(a, eta, [&](int, int, double dx, double dz) {
        return Vector{eta * dx, eta * dz};
      });
    }
  });
}

void expect_zero_padding(const Field& field) {
  for (Eigen::Index j = -1; j <= field.Nz(); ++j) {
    const bool row = j >= 0 && j < field.Nz();
    for (Eigen::Index i = row ? field.Nx() : 0; i < field.stride(); ++i) {
      ASSERT_EQ(field.row(j)[i], 0.0) << i << ", " << j;
    }
  }
}

/// A shaken slider and boundary forces that differ on every block.
struct Shaken {
  explicit Shaken(const Parameters& parameters)
      : p(parameters), state(p), normal(static_cast<std::size_t>(p.Nx)), tau(normal), top(normal) {
    Noise displacements(0.01 * block_spacing(p)), velocities(1.0), forces(30.0);
    displacements.fill(state.u_x);
    displacements.fill(state.u_z);
    velocities.fill(state.v_x);
    velocities.fill(state.v_z);
    for (double& force : normal) force = forces();
    for (double& force : tau) force = forces();
    for (double& force : top) force = forces();
  }
  Boundary boundary() const { return {normal.data(), tau.data(), top.data(), 1, 55.0}; }

  Parameters p;
  State state;
  std::vector<double> normal, tau, top;
};

/// With either bulk, for each height.
std::vector<Shaken> shaken(Eigen::Index Nx, const std::vector<Eigen::Index>& heights) {
  std::vector<Shaken> sliders;
  for (const Eigen::Index Nz : heights) {
    sliders.emplace_back(small_slider(Nx, Nz));
    sliders.emplace_back(testing::with_other_bulk(small_slider(Nx, Nz)));
  }
  return sliders;
}

TEST(RowLengths, leave_the_padding_zero) {
  for_row_lengths([](Eigen::Index Nx) {
    for (Shaken s : shaken(Nx, {4})) {
      Bulk bulk(s.p);
      Field f_x(s.p.Nx, s.p.Nz), f_z(f_x);
      for (const Then then : {Then::stop, Then::go_on, Then::stop}) {
        bulk.kick_drift(0, s.state);
        bulk.prepare(0, s.state);
        bulk.finish(0, s.boundary(), then, s.state);
        for (const Field* field :
             {&s.state.u_x, &s.state.u_z, &s.state.v_x, &s.state.v_z, &s.state.f_x, &s.state.f_z}) {
          expect_zero_padding(*field);
        }
        bulk.elastic(s.state.u_x, s.state.u_z, f_x, f_z);
        expect_zero_padding(f_x);
        expect_zero_padding(f_z);
        bulk.damping(s.state, f_x, f_z);
        expect_zero_padding(f_x);
        expect_zero_padding(f_z);
      }
    }
  });
}

TEST(RowLengths, finish_a_step_with_all_forces_and_tell_the_damping_power) {
  for_row_lengths([](Eigen::Index Nx) {
    for (Shaken s : shaken(Nx, {2, 3, 5})) {
      const Eigen::Index Nz = s.p.Nz;
      Bulk bulk(s.p);
      Field f_x(s.p.Nx, s.p.Nz), f_z(f_x), d_x(f_x), d_z(f_x);
      bulk.elastic(s.state.u_x, s.state.u_z, f_x, f_z);
      bulk.damping(s.state, d_x, d_z);
      f_x.blocks() += d_x.blocks();
      f_z.blocks() += d_z.blocks();
      for (Eigen::Index i = 0; i < Nx; ++i) {
        f_x(i, 0) -= s.tau[static_cast<std::size_t>(i)];
        f_z(i, 0) += s.normal[static_cast<std::size_t>(i)];
        f_z(i, Nz - 1) -= s.top[static_cast<std::size_t>(i)];
      }
      f_x(0, 1) += 55.0;
      const double half_kick = s.p.dt / (2.0 * block_mass(s.p));
      Field v_x = s.state.v_x, v_z = s.state.v_z;
      v_x.blocks() += half_kick * f_x.blocks();
      v_z.blocks() += half_kick * f_z.blocks();
      const double expected =
          (d_x.blocks() * v_x.blocks()).sum() + (d_z.blocks() * v_z.blocks()).sum();

      bulk.prepare(0, s.state);
      bulk.finish(0, s.boundary(), Then::stop, s.state);
      EXPECT_NEAR(bulk.damping_power(), expected, 1e-12 * std::abs(expected));
      for (Eigen::Index i = 0; i < Nx; ++i) {
        EXPECT_EQ(bulk.bottom_velocity()[i], s.state.v_x(i, 0));
      }
      const auto differs = [](const Field& a, const Field& b) {
        return (a.blocks() - b.blocks()).abs().maxCoeff() / a.blocks().abs().maxCoeff();
      };
      // only the order of the sums may differ
      EXPECT_LT(differs(f_x, s.state.f_x), 1e-14);
      EXPECT_LT(differs(f_z, s.state.f_z), 1e-14);
      EXPECT_LT(differs(v_x, s.state.v_x), 1e-14);
      EXPECT_LT(differs(v_z, s.state.v_z), 1e-14);
    }
  });
}

void expect_equal(const State& a, const State& b) {
  const auto equal = [](const Field& x, const Field& y) {
    return (x.blocks() == y.blocks()).all();
  };
  EXPECT_TRUE(equal(a.u_x, b.u_x) && equal(a.u_z, b.u_z)) << "displacements";
  EXPECT_TRUE(equal(a.v_x, b.v_x) && equal(a.v_z, b.v_z)) << "velocities";
  EXPECT_TRUE(equal(a.f_x, b.f_x) && equal(a.f_z, b.f_z)) << "forces";
}

/// Three steps with the rows in `bands` bands, which are worked on in turn.
State three_steps(Shaken s, int bands, Then between) {
  Bulk bulk(s.p, bands);
  EXPECT_LE(bulk.bands(), bands);
  const auto each_band = [&](const auto& work) {
    for (int band = bulk.bands() - 1; band >= 0; --band) work(band);
  };
  each_band([&](int band) { bulk.kick_drift(band, s.state); });
  for (int n = 0; n < 3; ++n) {
    const Then then = n < 2 ? between : Then::stop;
    each_band([&](int band) { bulk.prepare(band, s.state); });
    each_band([&](int band) { bulk.finish(band, s.boundary(), then, s.state); });
    if (n < 2 && then == Then::stop) {
      each_band([&](int band) { bulk.kick_drift(band, s.state); });
    }
  }
  return s.state;
}

TEST(RowLengths, steps_in_one_sweep_give_the_bits_of_single_steps) {
  for_row_lengths([](Eigen::Index Nx) {
    for (const Shaken& s : shaken(Nx, {5})) {
      expect_equal(three_steps(s, 1, Then::go_on), three_steps(s, 1, Then::stop));
    }
  });
}

TEST(Bands, change_no_bit) {
  for (const Eigen::Index Nx : {9, 70, 130}) {  // in one chunk, two and three
    for (const Shaken& s : shaken(Nx, {7})) {
      const State whole = three_steps(s, 1, Then::go_on);
      for (int bands = 2; bands <= 9; ++bands) {
        expect_equal(three_steps(s, bands, Then::go_on), whole);
      }
    }
  }
}

/// Force on the right one of two blocks that have been drawn apart to (1 + e) times their distance.
double pull(double e) {
  Parameters p = small_slider(3, 2);
  Lattice a(p);
  for (Eigen::Index j = 0; j < 2; ++j) a.x(2, j) = e * a.l();
  a.elastic();
  return a.f_x(2, 1);
}

/// The same in closed form: one spring k along x, one k/2 along the diagonal.
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

}  // namespace
}  // namespace rupture
