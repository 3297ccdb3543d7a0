// Friction of a block that slides at constant speed (claim 1G): renewal theory, and the law itself.
//
// At constant p every junction repeats one cycle: pinned, its force rises from f_new at the rate
// k_ij v until f_thres, which takes T_p = (f_thres - f_new) / (k_ij v) at a mean force
// (f_thres + f_new) / 2; then it slips for t_R at f_slip. Cycles are independent and alike, so by
// the renewal-reward theorem the time average of its force is
//     f(v) = (T_p (f_thres + f_new)/2 + <t_R> f_slip) / (T_p + <t_R>),
// which depends on T(t_R) only through <t_R>. Limits for f_new = 0: mu_s/2 for v -> 0, mu_d for
// v -> infinity; between them f falls monotonically if mu_d < mu_s/2.
#pragma once

#include <vector>

#include "rupture/analysis/statistics.hpp"
#include "rupture/model/parameters.hpp"

namespace rupture {

/// A sliding block of these parameters under the normal force p.
struct SteadySliding {
  Parameters parameters;
  double p = 0;  ///< [N]
};

/// tau/p of renewal theory at speed v > 0 [m/s].
double renewal_friction(const SteadySliding& block, double v);

/// How long and how often the law is run. The defaults are 4000 cycles of reference junctions.
struct SteadyRun {
  int replicas = 8;            ///< independent blocks, from which the standard error follows
  int running_in = 10;         ///< cycles T_p + <t_R> before the measurement
  int measured = 5;            ///< cycles that count
  int steps_per_cycle = 4000;  ///< junctions break and are pinned up to a step late
};

/// tau/p of the reference law at speed v > 0 [m/s], averaged over the cycles measured. On top of
/// the standard error there is that of the step, up to about 1/steps_per_cycle of the value.
Mean measured_friction(const SteadySliding& block, double v, const SteadyRun& run = {});

/// `points` speeds from v_from to v_to at equal ratios, both ends included [m/s].
std::vector<double> speeds_between(double v_from, double v_to, int points);

}  // namespace rupture
