// Effective static friction of a block: how much friction its junctions can bear (Figs. 4C, S5).
//
// mu_s^eff = tau_max / p, where tau_max is the largest friction force while the block is moved
// forwards quasi-statically: all junctions are stretched together, those that reach f_thres drop to
// f_slip, and none is pinned again meanwhile (a front passes in much less than <t_R>).
//
// In units g = (f - f_slip) / (f_thres - f_slip) a junction breaks at 1 and bears 0 from then on,
// and mu-bar = (tau_max/p - mu_d) / (mu_s - mu_d) is the largest mean of g. Let the junctions carry
// g = g_0 + xi with density phi(xi), and let those with xi > e have broken: the block has moved by
// 1 - g_0 - e, and the mean is, integrated by parts,
//     G(e) = int_{-inf}^e (1 - e + xi) phi(xi) dxi = F(e) - H(e),   F = int phi,   H = int F.
// g_0 has dropped out: tau_max depends on the shape of phi and not on tau_0, as long as no junction
// is beyond f_thres at the start and none slips. A fraction s of slipping junctions bears 0
// throughout, and leaves (1 - s) max G of the pinned ones' phi.
//
// Uniform, phi = 1/2a on [-a, a]: with y = e + a, G = (y - y^2/2) / 2a, which is largest at y = 1,
// or at the end y = 2a if that comes first:
//     mu-bar = 1 - a for a <= 1/2,   1/4a for a >= 1/2;   a = sqrt(3) sigma-bar.
// Bell, with z = e/a: F = Q(1 + z) for z <= 0 and 1 - Q(1 - z) for z > 0, where
// Q(y) = 5/4 y^4 - 3/4 y^5, and with R(y) = y^5/4 - y^6/8 = int Q, H = a R(1 + z) or a (z + R(1 -
// z)). G is largest where phi(e) = F(e). phi/F falls monotonically, from infinity at z = -1 to 0 at
// z = 1, so there is one root: of a quadratic for a >= 5/2, else of a quintic (found by bisection).
#pragma once

#include "rupture/analysis/phi.hpp"

namespace rupture {

/// mu-bar of a block whose junctions, all pinned, carry this shape of phi with standard deviation
/// sigma-bar = sigma / (f_thres - f_slip) >= 0. Exact to rounding.
double effective_strength(PhiShape shape, double sigma_bar);

struct JunctionForces {
  std::vector<double> pinned;    ///< [N]
  std::vector<double> slipping;  ///< below f_slip where the block has moved back meanwhile [N]
  double f_thres, f_slip;        ///< [N]
};

/// tau_max [N]. Between two breaks the friction never falls, so the largest value is met just
/// before one of them, or when all junctions slip. A slipping junction is stretched up to f_slip.
double largest_friction(const JunctionForces& forces);

/// One interface block of a checkpoint. Without contact (or if mu_s = mu_d) the barred quantities
/// have no value.
struct BlockStrength {
  double x = 0;                           ///< position of the block [m]
  double p = 0;                           ///< normal force [N]
  double tau_max = 0;                     ///< largest friction force [N]
  double slipping = 0;                    ///< fraction of junctions that are slipping
  std::optional<double> sigma_bar = {};   ///< sigma / (f_thres - f_slip), over all junctions
  std::optional<double> tau_bar_0 = {};   ///< (tau/p - mu_d) / (mu_s - mu_d), now
  std::optional<double> mu_bar_eff = {};  ///< (tau_max/p - mu_d) / (mu_s - mu_d)
};

/// All interface blocks, from the driven side, with the forces that their junctions carry.
std::vector<BlockStrength> block_strengths(const Parameters& parameters, const State& state);

}  // namespace rupture
