// One slider on its interface, moved in time by velocity Verlet.
//
// Scheme, for a state complete at step n (u, v, f, junctions at time t_n = n dt):
//   1. half kick and drift       v += (dt/2m) f;  u += dt v
//   2. normal forces             p_i on the bottom row and the forces on the top row at the new
//                                positions (NormalContact)
//   3. junctions                 break, slip, are pinned again at the new x_i, p_i and time t_{n+1}
//   4. forces                    springs at u, damping at the half-kicked v, p, tau, F_N, F_T, and
//                                that of the support's dashpots, eta_f v_z at the half-kicked v,
//                                where it is pressed; it never pulls. Friction follows p alone.
//   5. half kick                 v += (dt/2m) f
// Afterwards the state is complete at step n+1. plain_step.hpp is the same in plain terms, and what
// each step must equal; take_steps() has the same numbers. Between two steps that follow each
// other, 5 and the next 1 are done row by row in one sweep. f is part of the state because the
// damping force was taken at the half-kicked velocity, which is not kept.
#pragma once

#include <span>

#include "rupture/dynamics/energy.hpp"
#include "rupture/forces/bulk.hpp"
#include "rupture/forces/interface_law.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/normal_contact.hpp"
#include "rupture/model/rupture.hpp"

namespace rupture {

class Helpers;

/// Thrown when the state of a run has become meaningless (docs/guard.md).
struct Alarm : Failure {
  using Failure::Failure;
};

class Simulation {
 public:
  /// Takes over a complete state. The bulk is shared out among `threads` threads, which changes no
  /// bit of any result. ruptures() also reports when blocks fall below the pinned
  /// fractions `crossings`. Throws UsageError if the parameters are invalid or not those that the
  /// state was made with.
  Simulation(const Parameters& parameters, State state, int threads = 1,
             const std::vector<double>& crossings = {});
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Moves the state by `steps` >= 0 steps. Throws Alarm (time and block) when a number stops
  /// being finite.
  void advance(std::int64_t steps = 1);
  /// From now on, advance() ends at the step at which this block ruptures.
  void stop_at_rupture_of(std::optional<std::int64_t> block);

  const Parameters& parameters() const { return parameters_; }
  const State& state() const { return state_; }
  double time() const { return rupture::time(parameters_, state_); }

  std::span<const double> p() const { return p_; }      ///< normal force per interface block [N]
  std::span<const double> tau() const { return tau_; }  ///< friction force per block [N]
  double F_T() const { return F_T_; }                   ///< driving force [N]
  double x_drive() const { return drive_position(parameters_, state_.drive, state_.step); }
  const std::vector<std::int32_t>& pinned() const { return law_->pinned(); }

  /// Events of the run since it began: since this simulation was made, or before it as well.
  const RunSoFar& run() const { return run_; }
  /// Continues a run that another simulation began.
  void resume_from(const RunSoFar& run) { run_ = run; }

  /// Block ruptures since this simulation was made, and crossings of the fractions asked for, in
  /// the order of time.
  const std::vector<Rupture>& ruptures() const { return ruptures_; }

  /// Energies now, and work done since the simulation was made.
  Energies energies() const;
  const Work& work() const { return work_; }

 private:
  /// The blocks whose pinned fraction is below one value.
  struct PinnedBelow {
    double fraction;
    std::vector<bool> blocks;
  };

  ContactView contact() { return {p_.data(), k_ij_.data(), w_.data()}; }
  void take_steps(std::int64_t steps);
  Boundary boundary() const;
  void find_normal_forces();
  void find_contact();
  void damp_support();
  void move_interface();
  void move_junctions();
  void note_ruptures();
  Power power(double damping_power, const double* bottom_velocity) const;
  Power initial_power();
  void add_work();
  [[noreturn]] void report_blow_up() const;

  const Parameters parameters_;
  std::vector<NormalContact> normal_;  // of each column
  std::vector<double> kappa_;          // of each block [N/m^2]
  State state_;
  Bulk bulk_;
  std::unique_ptr<Helpers> helpers_;  // for all bands but one
  std::unique_ptr<InterfaceLaw> law_;
  std::vector<double> p_, k_ij_, w_, tau_;
  const double eta_f_;          // of the support's dashpots, 0 without them [N s/m]
  double dashpot_power_ = 0;    // that they take [W]
  std::vector<double> bottom_;  // with them: force from below on each bottom block [N]
  std::vector<double> top_;     // force from above on each top block, downwards [N]
  double F_T_;
  std::vector<PinnedBelow> pinned_below_;  // first of kRupturedFraction
  std::vector<Rupture> ruptures_;
  RunSoFar run_;
  std::optional<std::int64_t> watched_;  // block
  bool watched_ruptures_ = false;        // in this step
  Work work_;
  Power power_;
  bool blown_up_ = false;
};

/// The state, to be continued with other parameters: its time and driving point stay where they
/// are, its junctions become those of another law. Throws UsageError if they are invalid, or if one
/// changes that must be kept.
State continued(State state, const Parameters& after);

/// The number of threads with which a slider of this size runs fastest: one while it is small, then
/// more, up to those that this machine or the environment variable OMP_NUM_THREADS allows.
int default_thread_count(const Parameters& parameters);

}  // namespace rupture
