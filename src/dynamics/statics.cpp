#include "statics.hpp"

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "rupture/forces/bulk.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/normal_contact.hpp"

namespace rupture {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;
using Block2 = Eigen::Matrix2d;

/// Columns i_0 to i_1 and rows j_0 to j_1, the ends excluded.
struct Rectangle {
  Eigen::Index i_0, i_1, j_0, j_1;

  Eigen::Index width() const { return i_1 - i_0; }
  Eigen::Index height() const { return j_1 - j_0; }
};

/// Numbers the blocks of a part on from `next`. Cuts across the longer side: springs reach the next
/// column and row, so one line separates.
void dissect(const Rectangle& part, Eigen::Index Nx, Eigen::Index& next,
             std::vector<Eigen::Index>& places) {
  Rectangle last = part;
  if (part.width() > 2 || part.height() > 2) {
    Rectangle before = part, after = part;
    if (part.width() >= part.height()) {
      before.i_1 = last.i_0 = (part.i_0 + part.i_1) / 2;
      after.i_0 = last.i_1 = last.i_0 + 1;
    } else {
      before.j_1 = last.j_0 = (part.j_0 + part.j_1) / 2;
      after.j_0 = last.j_1 = last.j_0 + 1;
    }
    dissect(before, Nx, next, places);
    dissect(after, Nx, next, places);
  }
  for (Eigen::Index j = last.j_0; j < last.j_1; ++j) {
    for (Eigen::Index i = last.i_0; i < last.i_1; ++i) {
      places[static_cast<std::size_t>(j * Nx + i)] = next++;
    }
  }
}

/// Index of u_x of block (i, j) among the unknowns; that of u_z is one more. The blocks come one
/// after the other: row by row, or in the order of nested dissection.
class Unknowns {
 public:
  Unknowns(const Parameters& p, Elimination elimination)
      : Nx_(p.Nx), places_(static_cast<std::size_t>(p.Nx * p.Nz)) {
    std::iota(places_.begin(), places_.end(), 0);
    if (elimination == Elimination::nested_dissection) places_ = nested_dissection(p.Nx, p.Nz);
  }
  Eigen::Index operator()(Eigen::Index i, Eigen::Index j) const {
    return 2 * places_[static_cast<std::size_t>(j * Nx_ + i)];
  }

 private:
  Eigen::Index Nx_;
  std::vector<Eigen::Index> places_;
};

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

void add_springs(const Parameters& p, const Unknowns& unknown, const State& state,
                 Triplets& triplets) {
  const double l = spring_length(p);
  for_each_spring(p, [&](Eigen::Index i, Eigen::Index j, int ix, int iz) {
    const double n = ix * ix + iz * iz;
    const Eigen::Vector2d r(ix * l + state.u_x(i + ix, j + iz) - state.u_x(i, j),
                            iz * l + state.u_z(i + ix, j + iz) - state.u_z(i, j));
    const double k = spring_stiffness(p, i, j, ix, iz);
    const Block2 tangent = spring_tangent(k, std::sqrt(n) * l, r);
    const Eigen::Index here = unknown(i, j), there = unknown(i + ix, j + iz);
    add_block(triplets, here, here, tangent);
    add_block(triplets, there, there, tangent);
    add_block(triplets, here, there, -tangent);
    add_block(triplets, there, here, -tangent);
  });
}

/// Minus the derivative of static_forces with respect to the displacements.
Matrix stiffness(const Parameters& p, const LoadCase& load_case, const Unknowns& unknown,
                 const State& state) {
  Triplets triplets;
  triplets.reserve(static_cast<std::size_t>(64 * p.Nx * p.Nz));
  add_springs(p, unknown, state, triplets);
  const Eigen::Index top = p.Nz - 1;
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    const auto forces = interface_forces(p, load_case, state, i);
    Block2 tangent;
    tangent << forces.dtau_dux, forces.dtau_duz, 0.0, -forces.dp_duz;
    add_block(triplets, unknown(i, 0), unknown(i, 0), tangent);
    const double slope = NormalContact(p, i).top_force_slope(state.u_z(i, top));
    if (slope > 0.0) triplets.emplace_back(unknown(i, top) + 1, unknown(i, top) + 1, slope);
  }
  if (load_case.K > 0.0) {
    const Eigen::Index driven = unknown(0, driving_row(p));
    triplets.emplace_back(driven, driven, load_case.K);
  }
  const Eigen::Index size = 2 * p.Nx * p.Nz;
  Matrix matrix(size, size);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

Vector gather(const Parameters& p, const Unknowns& unknown, const Field& x, const Field& z) {
  Vector values(2 * p.Nx * p.Nz);
  for (Eigen::Index j = 0; j < p.Nz; ++j) {
    for (Eigen::Index i = 0; i < p.Nx; ++i) {
      values[unknown(i, j)] = x(i, j);
      values[unknown(i, j) + 1] = z(i, j);
    }
  }
  return values;
}

void add_displacement(const Parameters& p, const Unknowns& unknown, const Vector& change,
                      State& state) {
  for (Eigen::Index j = 0; j < p.Nz; ++j) {
    for (Eigen::Index i = 0; i < p.Nx; ++i) {
      state.u_x(i, j) += change[unknown(i, j)];
      state.u_z(i, j) += change[unknown(i, j) + 1];
    }
  }
}

/// Net static force on every block [N]; overwrites f.
void static_forces(const Parameters& p, const LoadCase& load_case, Bulk& bulk, const State& state,
                   Field& f_x, Field& f_z) {
  bulk.elastic(state.u_x, state.u_z, f_x, f_z);
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    const auto forces = interface_forces(p, load_case, state, i);
    f_x(i, 0) -= forces.tau;
    f_z(i, 0) += forces.p;
    f_z(i, p.Nz - 1) -= NormalContact(p, i).top_force(state.u_z(i, p.Nz - 1));
  }
  if (load_case.K > 0.0) f_x(0, driving_row(p)) -= load_case.K * state.u_x(0, driving_row(p));
}

/// Newton's method; `Ordering` is Eigen's name for the order in which the factorisation takes the
/// unknowns.
template <class Ordering>
std::optional<State> newton(const Parameters& p, const LoadCase& load_case,
                            Elimination elimination) {
  State state = compressed(p);
  const Unknowns unknown(p, elimination);
  constexpr int most_iterations = 50;
  const double tolerance = 1e-11 * mean_normal_force(p);
  Bulk bulk(p);
  Field f_x(p.Nx, p.Nz), f_z(p.Nx, p.Nz);
  std::optional<Eigen::SparseLU<Matrix, Ordering>> solver;
  double previous_residual = 0.0;  // a factorisation serves as long as each step gains a digit
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    static_forces(p, load_case, bulk, state, f_x, f_z);
    const double residual = largest(f_x, f_z);
    if (!std::isfinite(residual)) break;
    if (residual <= tolerance) {
      if (passed_block(p, state)) break;
      return state;
    }
    if (residual > 0.1 * previous_residual) {
      if (p.Nx * p.Nz > kBlocksOfDissection) solver.reset();  // the next matrix needs its memory
      const Matrix matrix = stiffness(p, load_case, unknown, state);
      if (!solver) solver.emplace().analyzePattern(matrix);
      solver->factorize(matrix);
      if (solver->info() != Eigen::Success) break;
    }
    previous_residual = residual;
    const Vector change = solver->solve(gather(p, unknown, f_x, f_z));
    add_displacement(p, unknown, change, state);
  }
  return std::nullopt;
}

}  // namespace

State compressed(const Parameters& p) {
  if (p.Nx * p.Nz > kMostBlocks) {
    throw UsageError("slider.Nx x slider.Nz = {}: an equilibrium can have at most {} blocks",
                     p.Nx * p.Nz, kMostBlocks);
  }
  State state(p);
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    const NormalContact contact(p, i);
    for (Eigen::Index j = 0; j < p.Nz; ++j) {
      state.u_z(i, j) = contact.compressed_u_z(static_cast<double>(j) * block_spacing(p));
    }
  }
  return state;
}

InterfaceForces interface_forces(const Parameters& p, const LoadCase& load_case, const State& state,
                                 Eigen::Index i) {
  const double u_x = state.u_x(i, 0), u_z = state.u_z(i, 0);
  const NormalContact contact(p, i);
  const double normal = contact.normal_force(u_z);
  const double dp_duz = contact.normal_force_slope(u_z);
  if (load_case.tau)
    return {normal, (*load_case.tau)[static_cast<std::size_t>(i)], dp_duz, 0.0, 0.0};
  if (!(normal > 0.0)) return {0.0, 0.0, 0.0, 0.0, 0.0};
  const double k_i = static_cast<double>(p.N_s) * junction_stiffness(p, i, normal);
  const bool k_i_varies = p.k_ij_from == StiffnessFrom::current;  // then with the root of p_i
  return {normal, k_i * u_x, dp_duz, k_i, k_i_varies ? dp_duz * k_i * u_x / (2.0 * normal) : 0.0};
}

std::optional<Place> passed_block(const Parameters& p, const State& state) {
  const double l = block_spacing(p);
  for (Eigen::Index j = 0; j < p.Nz; ++j) {
    for (Eigen::Index i = 0; i < p.Nx; ++i) {
      const bool right = i + 1 < p.Nx && l + state.u_x(i + 1, j) - state.u_x(i, j) <= 0.0;
      const bool above = j + 1 < p.Nz && l + state.u_z(i, j + 1) - state.u_z(i, j) <= 0.0;
      if (right || above) return Place{i, j};
    }
  }
  return std::nullopt;
}

double largest(const Field& f_x, const Field& f_z) {
  return std::max(f_x.blocks().abs().maxCoeff(), f_z.blocks().abs().maxCoeff());
}

std::optional<State> solve_statics(const Parameters& p, const LoadCase& load_case,
                                   std::optional<Elimination> elimination) {
  const bool is_large = p.Nx * p.Nz > kBlocksOfDissection;
  const Elimination order = elimination.value_or(is_large ? Elimination::nested_dissection
                                                          : Elimination::column_minimum_degree);
  if (order == Elimination::column_minimum_degree) {
    return newton<Eigen::COLAMDOrdering<int>>(p, load_case, order);
  }
  return newton<Eigen::NaturalOrdering<int>>(p, load_case, order);  // that of Unknowns
}

std::vector<Eigen::Index> nested_dissection(Eigen::Index Nx, Eigen::Index Nz) {
  std::vector<Eigen::Index> places(static_cast<std::size_t>(Nx * Nz));
  Eigen::Index next = 0;
  dissect({0, Nx, 0, Nz}, Nx, next, places);
  return places;
}

}  // namespace rupture
