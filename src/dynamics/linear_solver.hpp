// Linear equations of a slider at rest. Each order of elimination has a file of its own, because
// Eigen's factorisation takes a compiler longest of all.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>

namespace rupture {

/// Solves A x = b by sparse LU factorisation.
class LinearSolver {
 public:
  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;

  LinearSolver() = default;
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;
  virtual ~LinearSolver() = default;

  /// Takes a matrix A, with its nonzero entries where those of the first one were. False if it is
  /// singular.
  virtual bool factorize(const Matrix& matrix) = 0;

  /// x, for the matrix taken last.
  virtual Vector solve(const Vector& right_hand_side) const = 0;
};

/// Eliminates the unknowns in the order of least fill that COLAMD finds.
std::unique_ptr<LinearSolver> minimum_degree_solver();

/// Eliminates the unknowns in the order that they have.
std::unique_ptr<LinearSolver> ordered_solver();

}  // namespace rupture
