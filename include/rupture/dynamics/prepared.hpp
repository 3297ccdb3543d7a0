// Prepared interfaces: initial states with a prescribed prestress (SI Methods, "Fronts on prepared
// interfaces"; Figs. 3D, 4C, 4D, S3).
//
// p_i = F_N / Nx on every bottom block, the top row presses against an elastic ceiling, and the
// driving point stands still. Stresses and widths are given in the paper's dimensionless forms,
//   tau-bar = (tau_0/p - mu_d) / (mu_s - mu_d),   sigma-bar = sigma / (f_thres - f_slip).
#pragma once

#include <vector>

#include "rupture/model/phi_shape.hpp"
#include "rupture/model/state.hpp"

namespace rupture {

/// Whether the junctions of the trigger region are depinned at once, which starts the event.
enum class Trigger { depinned, pinned };

struct Prestress {
  double tau_bar = 0;    ///< prestress of the blocks at x >= x_trigger, uniform [1]
  double sigma_bar = 0;  ///< width of phi in the pinned junctions [1]
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

/// The same state by damped relaxation for `duration` [s], the paper's way. Slow; it exists to
/// check the direct solve.
State relaxed_prepared_state(const Parameters& parameters, const Prestress& prestress,
                             double duration);

}  // namespace rupture
