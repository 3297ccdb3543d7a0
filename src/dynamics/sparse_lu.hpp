// Eigen's sparse LU factorisation as a LinearSolver.
#pragma once

#include <Eigen/SparseLU>
#include <optional>

#include "linear_solver.hpp"

namespace rupture {

template <class Ordering>
class SparseLu final : public LinearSolver {
 public:
  bool factorize(const Matrix& matrix) override {
    if (!solver_) solver_.emplace().analyzePattern(matrix);
    solver_->factorize(matrix);
    return solver_->info() == Eigen::Success;
  }

  Vector solve(const Vector& right_hand_side) const override {
    return solver_->solve(right_hand_side);
  }

 private:
  std::optional<Eigen::SparseLU<Matrix, Ordering>> solver_;
};

}  // namespace rupture
