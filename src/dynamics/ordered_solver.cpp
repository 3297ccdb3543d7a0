#include "sparse_lu.hpp"

namespace rupture {

std::unique_ptr<LinearSolver> ordered_solver() {
  return std::make_unique<SparseLu<Eigen::NaturalOrdering<int>>>();
}

}  // namespace rupture
