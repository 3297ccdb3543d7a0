// The slider at rest: the forces on it, and how it is found.
#pragma once

#include <optional>

#include "rupture/dynamics/equilibrium.hpp"

namespace rupture {

/// Friction and driving spring, which hold a slider at rest besides its springs and its support.
struct LoadCase {
  /// Friction on each interface block, towards -x [N]. None: that of junctions which were attached
  /// at x_ij = x_i(undeformed) and cannot break.
  std::optional<std::vector<double>> tau = {};
  /// Modulus of the driving spring, its driving point at 0 [N/m]. Zero: there is none.
  double K = 0;
};

/// Forces of the interface on one block, and their derivatives.
struct InterfaceForces {
  double p, tau;              ///< upwards and towards -x [N]
  double dp_duz;              ///< [N/m]
  double dtau_dux, dtau_duz;  ///< [N/m]
};

InterfaceForces interface_forces(const Parameters& p, const LoadCase& load_case, const State& state,
                                 Eigen::Index i);

/// A block of the lattice: column i, row j.
struct Place {
  Eigen::Index i, j;
};

/// The first block that has passed its right or upper neighbour: static equations have such
/// solutions, a slider does not.
std::optional<Place> passed_block(const Parameters& p, const State& state);

/// Largest component of a vector field.
double largest(const Field& f_x, const Field& f_z);

/// Order of elimination of a lattice of Nx x Nz blocks by nested dissection: a line of blocks
/// cuts the lattice into halves, which are cut in turn, and comes after both. Returns the place of
/// block (i, j) in that order at [j Nx + i]. Integers and coordinates only.
std::vector<Eigen::Index> nested_dissection(Eigen::Index Nx, Eigen::Index Nz);

/// The order in which the factorisation takes the blocks. It moves the last bits of the solution.
enum class Elimination { column_minimum_degree, nested_dissection };

/// The slider at rest, by Newton's method with a sparse LU factorisation, until the largest net
/// force on a block is below 1e-11 F_N / N_x. Nothing if that is not reached or the lattice turns
/// inside out. Without a given order, that of the number of blocks (kBlocksOfDissection).
std::optional<State> solve_statics(const Parameters& p, const LoadCase& load_case,
                                   std::optional<Elimination> elimination = {});

}  // namespace rupture
