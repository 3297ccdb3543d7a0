// The distribution phi(f_T) of the forces that a block's junctions carry (Figs. 4, S4, S5).
#pragma once

#include <optional>

#include "rupture/model/phi_shape.hpp"
#include "rupture/model/state.hpp"

namespace rupture {

/// Normal force p_i on each interface block [N].
std::vector<double> normal_forces(const Parameters& parameters, const State& state);

/// Friction force on each interface block, sum_j k_ij (x_i - x_ij) [N].
std::vector<double> friction_forces(const Parameters& parameters, const State& state);

/// Forces that the junctions of one block carry.
struct BlockForces {
  double x = 0;                ///< position of the block [m]
  double k_ij = 0;             ///< stiffness of one junction [N/m]
  double f_thres = 0;          ///< strength of one junction [N]
  double f_slip = 0;           ///< force of one slipping junction [N]
  double mean = 0;             ///< mean force over all junctions [N]
  double sigma = 0;            ///< standard deviation over all junctions [N]
  double slipping = 0;         ///< fraction of junctions that are slipping
  std::vector<double> forces;  ///< f_j = k_ij (x_i - x_ij) of each junction [N]

  /// Friction force on the block [N].
  double tau() const { return mean * static_cast<double>(forces.size()); }
  double sigma_bar() const { return sigma / (f_thres - f_slip); }
};

/// All interface blocks, from the driven side.
std::vector<BlockForces> block_forces(const Parameters& parameters, const State& state);

/// Counts of `forces` in `bins` equal bins between -f_thres and f_thres.
std::vector<std::int64_t> histogram(const BlockForces& block, int bins);

/// Throws Failure if the interface has a single spring per block and so no phi.
void refuse_single_springs(const Parameters& parameters);

/// Fate of the slipping junctions of a block whose phi is replaced.
enum class Slipping { keep, pin };

struct PhiChange {
  PhiShape shape = PhiShape::uniform;
  std::optional<double> sigma_bar;  ///< none: as wide as each block allows, to f_thres - |mean|
  double x_from = 0, x_to = 1e300;  ///< blocks with x_from <= x <= x_to [m]
  Slipping slipping = Slipping::keep;

  /// Whether a block at x [m] is one of them, to rounding: 35 l is not quite 0.0875 m.
  bool includes(double x) const { return x >= x_from * (1.0 - 1e-9) && x <= x_to * (1.0 + 1e-9); }
};

/// A block whose junctions cannot take the requested phi without one exceeding f_thres.
struct ImpossibleBlock {
  double x;                  ///< [m]
  double largest_sigma_bar;  ///< widest phi it could take
};

/// Replaces phi in a region, keeping each block's mean: the pinned junctions' (Slipping::keep), or
/// all junctions', which are pinned (Slipping::pin). Junctions keep the order of their forces.
/// Blocks that cannot take the new phi, or are not pressed, are left as they are and returned.
std::vector<ImpossibleBlock> change_phi(const Parameters& parameters, State& state,
                                        const PhiChange& change);

}  // namespace rupture
