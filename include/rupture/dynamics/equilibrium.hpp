// The normal-load equilibrium from which driving starts (SI Methods), by a direct solve.
// And prepared interfaces, see below.
#pragma once

#include "rupture/model/phi_shape.hpp"
#include "rupture/model/state.hpp"

namespace rupture {

/// With more blocks than this, the equations are solved in the order of nested dissection [1]. That
/// is faster from 2,000 blocks on, but it changes the last bits. Those of recipes and tests must
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

// Prepared interfaces: initial states with a prescribed prestress (SI Methods, "Fronts on prepared
// interfaces"; Figs. 3D, 4C, 4D, S3).
//
// p_i is its part of F_N on every bottom block, the top row presses against an elastic ceiling, and
// the driving point stands still. Stresses and widths are given in the paper's dimensionless forms,
//   tau-bar = (tau_0/p - mu_d) / (mu_s - mu_d),   sigma-bar = sigma / (f_thres - f_slip).

/// Whether the junctions of the trigger region are depinned at once, which starts the event.
enum class Trigger { depinned, pinned };

struct Prestress {
  AlongX<double> tau_bar = 0;    ///< prestress of the blocks at x >= x_trigger [1]
  AlongX<double> sigma_bar = 0;  ///< width of phi in the pinned junctions [1]
  PhiShape shape = PhiShape::uniform;
  double x_trigger = 22.5e-3;    ///< blocks at x < x_trigger form the trigger region [m]
  double tau_bar_trigger = 0.3;  ///< their prestress [1]
  Trigger trigger = Trigger::depinned;
};

/// Prescribed friction force on each interface block, tau_i = p (mu_d + tau-bar (mu_s - mu_d)) [N].
std::vector<double> prescribed_friction(const Parameters& parameters, const Prestress& prestress);

/// The sigma-bar at which the outermost junction of a block that stays pinned reaches f_thres.
double largest_sigma_bar(const Parameters& parameters, const Prestress& prestress);

/// The slider at rest at t = 0, with the driving spring balancing sum tau_i and the driving point
/// at 0. The net friction force on each block is tau_i, and the forces of its junctions are the
/// exact quantiles of phi, f_j = tau_i/N_s + a q_j. In a depinned trigger region, whose junctions
/// slip from t = 0 on, they are what they were after a break: f_slip with the sign of tau_i.
///
/// The equilibrium is found directly, as in normal_load_equilibrium(). Throws UsageError, with the
/// largest possible value, if a junction would be beyond f_thres; also unless slider.support is
/// ceiling, K > 0 and mu_d < mu_s. Throws Failure if there is no equilibrium.
State prepared_state(const Parameters& parameters, const Prestress& prestress);

}  // namespace rupture
