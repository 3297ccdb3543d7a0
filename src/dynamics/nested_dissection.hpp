// The order in which elimination fills in least.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rupture {

/// Order of elimination of a lattice of Nx x Nz blocks by nested dissection: a line of blocks
/// cuts the lattice into halves, which are cut in turn, and comes after both. Returns the place of
/// block (i, j) in that order at [j Nx + i]. Integers and coordinates only.
std::vector<Eigen::Index> nested_dissection(Eigen::Index Nx, Eigen::Index Nz);

}  // namespace rupture
