// The normal-load equilibrium from which driving starts (SI Methods), by a direct solve.
#pragma once

#include <cstdint>

#include "rupture/model/state.hpp"

namespace rupture {

/// With more blocks than this, the equations are solved in the order of nested dissection [1]. That
/// is faster from 2,000 blocks on, but it changes the last bits. Those of recipes and tests shall
/// stay; none of their sliders has more than 7,000 blocks.
inline constexpr std::int64_t kBlocksOfDissection = 10000;

/// With more blocks than this, a factor may have more than the 2^31 entries that it can count: it
/// has some 30 log2(N) - 71 per block of N x N blocks, 270 here.
inline constexpr std::int64_t kMostBlocks = 7'000'000;

/// Uniaxial compression under F_N against the support, nothing moved sideways: near the
/// equilibrium, and a start from which Newton's method converges to it. Throws UsageError if there
/// are too many blocks for that.
State compressed(const Parameters& parameters);

/// The slider at rest under F_N, F_T = 0, all junctions attached at x_ij = x_i(undeformed) and
/// forbidden to break; the driving point is placed so that F_T = 0.
///
/// Newton's method on the static equations (springs, load, unilateral foundation, junction
/// stiffness at the current p_i) with a sparse LU factorisation, until the largest net force on a
/// block is below 1e-11 F_N / N_x. Throws Failure if it does not converge, or if a junction ends up
/// beyond its strength (naming the block and the ratio |f| / f_thres).
State normal_load_equilibrium(const Parameters& parameters);

/// Largest component of the net static force on any block of `state`, friction and load included,
/// driving excluded [N].
double static_residual(const Parameters& parameters, const State& state);

/// The same equilibrium by damped relaxation, the paper's way: velocity Verlet with an extra force
/// -alpha v, alpha = eta/40, on every block for `duration` [s]. Slow; it exists to check the direct
/// solve.
State relaxed_equilibrium(const Parameters& parameters, double duration);

}  // namespace rupture
