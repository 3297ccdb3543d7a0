// One block: its friction at constant speed, and its slow slip.
#pragma once

#include "rupture/analysis/statistics.hpp"
#include "rupture/model/parameters.hpp"

namespace rupture {

// Friction of a block that slides at constant speed (claim 1G): renewal theory, and the law itself.
//
// At constant p every junction repeats one cycle: pinned, its force rises from f_new at the rate
// k_ij v until f_thres, which takes T_p = (f_thres - f_new) / (k_ij v) at a mean force
// (f_thres + f_new) / 2; then it slips for t_R at f_slip. Cycles are independent and alike, so by
// the renewal-reward theorem the time average of its force is
//     f(v) = (T_p (f_thres + f_new)/2 + <t_R> f_slip) / (T_p + <t_R>),
// which depends on T(t_R) only through <t_R>. Limits for f_new = 0: mu_s/2 for v -> 0, mu_d for
// v -> infinity; between them f falls monotonically if mu_d < mu_s/2.

/// A sliding block of these parameters, which vary nowhere (at_block()), under the normal force p.
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

// Slow slip from the parameters: Eq. S1 and the relaxation of one block behind its coefficient (SI,
// "Estimate of v_slow slip from Model Parameters").

/// Coefficient of Eq. S1: a net slip of 8.5 f_slip/k_ij during 2 <t_R>, as the paper rounds it.
inline constexpr double kSlowSlipCoefficient = 4.2;

/// Eq. S1 for block i under the normal force p: v = 4.2 tau_slip / (k_i <t_R>) with tau_slip = mu_d
/// p and k_i = N_s k_ij [m/s]. Zero without contact, and where f_new = f_slip: nothing drives slow
/// slip then.
double slow_slip_estimate(const Parameters& parameters, std::int64_t i, double p);

/// The relaxation of one block. All junctions slip at f_slip at t = 0, so the force on the block is
/// N_s f_slip, and stays so, because its neighbours move along. Junction j is pinned at its
/// t_R with f_new = 0; the block moves forwards until the pinned junctions make up for the lost
/// f_slip. Those that reach f_thres on the way break, drop to f_slip, and draw another t_R.
///
/// Where none breaks, the net slip is that of the harmonic sum, H_100 = 5.187.
///
/// The force is N_s f_slip again when the pinned junctions carry f_slip on average. Pinned and
/// broken in the same order, they are interchangeable, so the slip after n such changes is the same
/// for all seeds; only its course in time is random.
struct Relaxation {
  double net_slip = 0;        ///< when no junction slips any more [f_slip / k_ij]
  double slip_after_two = 0;  ///< at t = 2 <t_R> [f_slip / k_ij]
  double slip_at_return = 0;  ///< when every junction has been pinned once, at t = `duration`
                              ///< [f_slip / k_ij]
  double duration = 0;        ///< time at which every junction has been pinned once [<t_R>]
  double quiet_time = 0;      ///< time from which no junction slips any more [<t_R>]

  /// Its course: `slip` after each junction that was pinned, at `time`.
  struct Course {
    std::vector<double> time;  ///< [<t_R>]
    std::vector<double> slip;  ///< [f_slip / k_ij]
  } course;
};

/// One relaxation of a block of these parameters, which vary nowhere (at_block()), with the
/// slipping times of block `replica`. No value if junctions still break after 100 <t_R>: they do
/// for ever if f_thres < 2 f_slip or little more.
std::optional<Relaxation> relax(const Parameters& parameters, std::uint32_t replica);

/// Mean and spread of the fields of Relaxation over independent blocks.
struct RelaxationEnsemble {
  Mean net_slip, slip_after_two, slip_at_return, duration, quiet_time;
};

/// Replicas 0 .. n-1, n >= 2. No value if one of them has none.
std::optional<RelaxationEnsemble> relax_ensemble(const Parameters& parameters, int n);

}  // namespace rupture
