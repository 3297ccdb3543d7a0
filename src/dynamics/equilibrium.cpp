#include "rupture/dynamics/equilibrium.hpp"

#include <fmt/core.h>

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <array>
#include <cmath>
#include <vector>

#include "rupture/forces/bulk.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"

namespace rupture {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;
using Block2 = Eigen::Matrix2d;

/// Unknowns of block (i, j): 2 (j Nx + i) for u_x, one more for u_z.
Eigen::Index unknown(const Parameters& p, Eigen::Index i, Eigen::Index j) {
  return 2 * (j * p.Nx + i);
}

/// Friction of one interface block whose junctions are attached at a = 0 and cannot break:
/// tau = N_s k_ij u_x with k_ij = sqrt(kappa p / N_s), and its derivatives.
struct UnbreakableFriction {
  double p, tau, dtau_dux, dtau_duz;
};

UnbreakableFriction unbreakable_friction(const Parameters& p, double u_x, double u_z) {
  if (u_z >= 0.0) return {0.0, 0.0, 0.0, 0.0};
  const double k_f = foundation_stiffness(p);
  const double normal = foundation_force(p, u_z);
  const double k_i = static_cast<double>(p.N_s) * junction_stiffness(p, normal);
  return {normal, k_i * u_x, k_i, -k_f * k_i * u_x / (2.0 * normal)};
}

/// Net static force on every block.
void static_forces(const Parameters& p, Bulk& bulk, const State& state, Field& f_x, Field& f_z) {
  bulk.elastic(state.u_x, state.u_z, f_x, f_z);
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    const auto friction = unbreakable_friction(p, state.u_x(i, 0), state.u_z(i, 0));
    f_x(i, 0) -= friction.tau;
    f_z(i, 0) += friction.p;
    f_z(i, p.Nz - 1) -= mean_normal_force(p);
  }
}

double largest(const Field& f_x, const Field& f_z) {
  return std::max(f_x.blocks().abs().maxCoeff(), f_z.blocks().abs().maxCoeff());
}

/// Derivative of the force of one spring with respect to the relative displacement of its ends:
/// k [(1 - 1/q) I + r r^T / (l_0^2 q^3)], q = |r| / l_0.
Block2 spring_tangent(double k, double l_0, const Eigen::Vector2d& r) {
  const double q = r.norm() / l_0;
  return k * ((1.0 - 1.0 / q) * Block2::Identity() + r * r.transpose() / (l_0 * l_0 * q * q * q));
}

void add_block(Triplets& triplets, Eigen::Index row, Eigen::Index column, const Block2& value) {
  for (int a = 0; a < 2; ++a) {
    for (int b = 0; b < 2; ++b) triplets.emplace_back(row + a, column + b, value(a, b));
  }
}

void add_springs(const Parameters& p, const State& state, Triplets& triplets) {
  constexpr std::array<std::array<int, 2>, 4> bonds = {{{1, 0}, {0, 1}, {1, 1}, {-1, 1}}};
  const double l = block_spacing(p);
  for (Eigen::Index j = 0; j < p.Nz; ++j) {
    for (Eigen::Index i = 0; i < p.Nx; ++i) {
      for (const auto [ix, iz] : bonds) {
        const Eigen::Index i2 = i + ix, j2 = j + iz;
        if (i2 < 0 || i2 >= p.Nx || j2 >= p.Nz) continue;
        const double n = ix * ix + iz * iz;
        const Eigen::Vector2d r(ix * l + state.u_x(i2, j2) - state.u_x(i, j),
                                iz * l + state.u_z(i2, j2) - state.u_z(i, j));
        const Block2 tangent = spring_tangent(bulk_stiffness(p) / n, std::sqrt(n) * l, r);
        const Eigen::Index here = unknown(p, i, j), there = unknown(p, i2, j2);
        add_block(triplets, here, here, tangent);
        add_block(triplets, there, there, tangent);
        add_block(triplets, here, there, -tangent);
        add_block(triplets, there, here, -tangent);
      }
    }
  }
}

/// Minus the derivative of static_forces with respect to the displacements.
Matrix stiffness(const Parameters& p, const State& state) {
  Triplets triplets;
  triplets.reserve(static_cast<std::size_t>(64 * p.Nx * p.Nz));
  add_springs(p, state, triplets);
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    const auto friction = unbreakable_friction(p, state.u_x(i, 0), state.u_z(i, 0));
    Block2 tangent;
    tangent << friction.dtau_dux, friction.dtau_duz, 0.0,
        friction.p > 0.0 ? foundation_stiffness(p) : 0.0;
    add_block(triplets, unknown(p, i, 0), unknown(p, i, 0), tangent);
  }
  const Eigen::Index size = 2 * p.Nx * p.Nz;
  Matrix matrix(size, size);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

Vector gather(const Parameters& p, const Field& x, const Field& z) {
  Vector values(2 * p.Nx * p.Nz);
  for (Eigen::Index j = 0; j < p.Nz; ++j) {
    for (Eigen::Index i = 0; i < p.Nx; ++i) {
      values[unknown(p, i, j)] = x(i, j);
      values[unknown(p, i, j) + 1] = z(i, j);
    }
  }
  return values;
}

void add_displacement(const Parameters& p, const Vector& change, State& state) {
  for (Eigen::Index j = 0; j < p.Nz; ++j) {
    for (Eigen::Index i = 0; i < p.Nx; ++i) {
      state.u_x(i, j) += change[unknown(p, i, j)];
      state.u_z(i, j) += change[unknown(p, i, j) + 1];
    }
  }
}

/// Uniaxial compression under F_N, lying on the foundation: a start from which Newton converges.
State compressed(const Parameters& p) {
  State state(p);
  const double load = mean_normal_force(p);
  const double sink = load / foundation_stiffness(p);
  const double strain = p.F_N / (p.L * p.B) / p.E;
  for (Eigen::Index j = 0; j < p.Nz; ++j) {
    const double z = static_cast<double>(j) * block_spacing(p);
    for (Eigen::Index i = 0; i < p.Nx; ++i) state.u_z(i, j) = -sink - strain * z;
  }
  return state;
}

void place_driving_point(const Parameters& p, State& state) {
  state.drive = {state.step, state.u_x(0, driving_row(p))};
}

/// True if a block has passed its right or upper neighbour: static equations have such solutions, a
/// slider does not.
bool turned_inside_out(const Parameters& p, const State& state) {
  const double l = block_spacing(p);
  for (Eigen::Index j = 0; j < p.Nz; ++j) {
    for (Eigen::Index i = 0; i < p.Nx; ++i) {
      if (i + 1 < p.Nx && l + state.u_x(i + 1, j) - state.u_x(i, j) <= 0.0) return true;
      if (j + 1 < p.Nz && l + state.u_z(i, j + 1) - state.u_z(i, j) <= 0.0) return true;
    }
  }
  return false;
}

void check_strength(const Parameters& p, const State& state) {
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    const auto friction = unbreakable_friction(p, state.u_x(i, 0), state.u_z(i, 0));
    if (std::abs(friction.tau) <= p.mu_s * friction.p) continue;
    throw Failure(fmt::format(
        "the junctions of block {} cannot bear the normal load: |f|/f_thres = {:.3g} at F_N = {:g} "
        "N; raise junctions.mu_s or slider.foundation, or lower slider.F_N",
        i, std::abs(friction.tau) / (p.mu_s * friction.p), p.F_N));
  }
}

}  // namespace

double static_residual(const Parameters& p, const State& state) {
  Bulk bulk(p);
  Field f_x(p.Nx, p.Nz), f_z(p.Nx, p.Nz);
  static_forces(p, bulk, state, f_x, f_z);
  return largest(f_x, f_z);
}

State normal_load_equilibrium(const Parameters& p) {
  validate(p);
  constexpr int most_iterations = 50;
  const double tolerance = 1e-11 * mean_normal_force(p);
  Bulk bulk(p);
  State state = compressed(p);
  Field f_x(p.Nx, p.Nz), f_z(p.Nx, p.Nz);
  Eigen::SparseLU<Matrix> solver;
  double previous_residual = 0.0;  // a factorisation serves as long as each step gains a digit
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    static_forces(p, bulk, state, f_x, f_z);
    const double residual = largest(f_x, f_z);
    if (!std::isfinite(residual)) break;
    if (residual <= tolerance) {
      if (turned_inside_out(p, state)) break;
      check_strength(p, state);
      place_driving_point(p, state);
      return state;
    }
    if (residual > 0.1 * previous_residual) {
      const Matrix matrix = stiffness(p, state);
      if (iteration == 0) solver.analyzePattern(matrix);
      solver.factorize(matrix);
      if (solver.info() != Eigen::Success) break;
    }
    previous_residual = residual;
    add_displacement(p, solver.solve(gather(p, f_x, f_z)), state);
  }
  throw Failure(
      fmt::format("no equilibrium under F_N = {:g} N was found: the load is too large for slider.E "
                  "= {:g} Pa or "
                  "the slider tips over",
                  p.F_N, p.E));
}

State relaxed_equilibrium(const Parameters& p, double duration) {
  validate(p);
  Bulk bulk(p);
  State state = compressed(p);
  Field damping_x(p.Nx, p.Nz), damping_z(p.Nx, p.Nz);
  const double alpha = damping_coefficient(p) / 40.0;
  const double half_kick = p.dt / (2.0 * block_mass(p));
  const auto steps = static_cast<std::int64_t>(std::llround(duration / p.dt));
  for (std::int64_t n = 0; n < steps; ++n) {
    bulk.kick_drift(0, state);
    static_forces(p, bulk, state, state.f_x, state.f_z);
    bulk.damping(state.v_x, state.v_z, damping_x, damping_z);
    state.f_x.blocks() += damping_x.blocks() - alpha * state.v_x.blocks();
    state.f_z.blocks() += damping_z.blocks() - alpha * state.v_z.blocks();
    state.v_x.blocks() += half_kick * state.f_x.blocks();
    state.v_z.blocks() += half_kick * state.f_z.blocks();
  }
  place_driving_point(p, state);
  return state;
}

}  // namespace rupture
