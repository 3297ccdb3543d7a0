#include "sparse_lu.hpp"

namespace rupture {

std::unique_ptr<LinearSolver> minimum_degree_solver() {
  return std::make_unique<SparseLu<Eigen::COLAMDOrdering<int>>>();
}

}  // namespace rupture
