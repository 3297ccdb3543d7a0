#include "rupture/dynamics/simulation.hpp"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "helpers.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/laws.hpp"

namespace rupture {
namespace {

/// With fewer blocks for each, threads gain too little for the processors that they take.
constexpr std::int64_t kBlocksPerThread = 2000;

/// Threads that this process is meant to have: OMP_NUM_THREADS, or one for each processor it may
/// use.
int allowed_threads() {
  const char* const asked = std::getenv("OMP_NUM_THREADS");
  if (const int threads = asked != nullptr ? std::atoi(asked) : 0; threads > 0) return threads;
  cpu_set_t processors;
  return sched_getaffinity(0, sizeof processors, &processors) == 0 ? CPU_COUNT(&processors) : 1;
}

const Parameters& valid(const Parameters& parameters, const State& state) {
  validate(parameters);
  refuse_other_parameters(state, parameters);
  return parameters;
}

/// One spring per block cannot become many, nor the other way round.
void refuse_other_springs(const Parameters& before, const Parameters& after) {
  const LawInfo &old_law = law_info(before.law), &new_law = law_info(after.law);
  if (old_law.springs == new_law.springs) return;
  const bool had_one = old_law.springs == SpringsPerBlock::one;
  throw UsageError(
      "junctions.law cannot change from {} to {} in a restart: the {} law has one spring per "
      "block; start with load --set junctions.law={}",
      old_law.name, new_law.name, had_one ? old_law.name : new_law.name, new_law.name);
}

void refuse_changes_of_kept(const Parameters& before, const Parameters& after) {
  for (const ParameterInfo* info : differing(before, after)) {
    if (info->restart == Restart::may_change) continue;
    throw UsageError(
        "{} cannot change in a restart: the checkpoint has {}{}; start a new run with load or "
        "prepare",
        info->name, parameter_text(before, *info),
        info->unit == "1" ? "" : fmt::format(" {}", info->unit));
  }
}

}  // namespace

int default_thread_count(const Parameters& p) {
  const std::int64_t useful = p.Nx * p.Nz / kBlocksPerThread;
  return static_cast<int>(std::clamp<std::int64_t>(useful, 1, allowed_threads()));
}

Simulation::Simulation(const Parameters& parameters, State state, int threads,
                       const std::vector<double>& crossings)
    : parameters_(valid(parameters, state)),
      state_(std::move(state)),
      bulk_(parameters, threads),
      helpers_(std::make_unique<Helpers>(bulk_.bands())),
      law_(make_law(parameters, state_.junctions)),
      tau_(static_cast<std::size_t>(parameters.Nx)),
      eta_f_(foundation_damping_coefficient(parameters)),
      F_T_(driving_force(parameters, state_)),
      pinned_below_{{kRupturedFraction, std::vector<bool>(tau_.size())}} {
  for (std::int64_t i = 0; i < parameters.Nx; ++i) {
    normal_.emplace_back(parameters, i);
    kappa_.push_back(parameters.kappa[i]);
    p_.push_back(normal_.back().normal_force(0.0));
    k_ij_.push_back(junction_stiffness(parameters, i, p_.back()));
    w_.push_back(friction_stretch(parameters, i, p_.back()));
    top_.push_back(normal_.back().top_force(0.0));
  }
  bottom_ = p_;
  for (const double fraction : crossings) {
    pinned_below_.push_back({fraction, std::vector<bool>(tau_.size())});
  }
  find_normal_forces();  // of the side with the support; F_N on the other does not change
  law_->friction(state_.u_x.row(0), contact(), tau_.data());
  note_ruptures();
  ruptures_.clear();  // blocks that had ruptured before this simulation began
  run_ = run_from(parameters_, state_.step);
  power_ = initial_power();
}

Simulation::~Simulation() = default;

void Simulation::advance(std::int64_t steps) {
  if (steps == 0) return;
  take_steps(steps);
  if (!blown_up_) add_work();
  if (blown_up_) report_blow_up();
}

/// While this thread moves the interface, helpers only read the bulk. Who works on which band
/// changes nothing. Numbers: sub-steps of the header.
void Simulation::take_steps(std::int64_t steps) {
  const BandWork keep = [this](int band) { bulk_.keep_neighbouring_rows(band, state_); };
  helpers_->share([this](int band) { bulk_.half_kick_and_drift(band, state_); });  // 1
  for (std::int64_t n = 0; n < steps; ++n) {
    helpers_->share(keep, [this, n] {
      if (n > 0) add_work();
      if (!blown_up_) move_interface();  // 2, 3, and tau and F_T for 4
    });
    if (blown_up_) return;

    const Then then = n + 1 < steps && !watched_ruptures_ ? Then::go_on : Then::stop;
    helpers_->share([this, then](int band) {
      bulk_.add_forces_and_half_kick(band, boundary(), then, state_);  // 4, 5; and 1 to go on
    });
    if (then == Then::stop) return;
  }
}

void Simulation::stop_at_rupture_of(std::optional<std::int64_t> block) {
  watched_ = block;
}

Boundary Simulation::boundary() const {
  const double* from_below = eta_f_ > 0.0 ? bottom_.data() : p_.data();
  return {from_below, tau_.data(), top_.data(), driving_row(parameters_), F_T_};
}

void Simulation::move_interface() {
  ++state_.step;
  find_normal_forces();                                       // 2
  move_junctions();                                           // 3
  law_->friction(state_.u_x.row(0), contact(), tau_.data());  // tau
  F_T_ = driving_force(parameters_, state_);
}

void Simulation::move_junctions() {
  watched_ruptures_ = false;
  const auto changes = law_->update(state_.u_x.row(0), state_.v_x.row(0), contact(), time());
  if (changes.broken > 0) run_.last_break = state_.step;
  if (changes.broken + changes.repinned > 0) note_ruptures();
}

void Simulation::find_normal_forces() {
  if (has_constant_p(parameters_)) {
    const double* u_z = state_.u_z.row(parameters_.Nz - 1);
    for (std::size_t i = 0; i < top_.size(); ++i) top_[i] = normal_[i].top_force(u_z[i]);
  } else {
    find_contact();
  }
  if (eta_f_ > 0.0) damp_support();
}

void Simulation::find_contact() {
  kernels().contact(parameters_.Nx, state_.u_z.row(0), foundation_stiffness(parameters_),
                    static_cast<double>(parameters_.N_s), kappa_.data(), contact());
  if (parameters_.k_ij_from == StiffnessFrom::current) return;
  for (std::size_t i = 0; i < p_.size(); ++i) {
    const auto block = static_cast<std::int64_t>(i);
    k_ij_[i] = junction_stiffness(parameters_, block, p_[i]);
    w_[i] = friction_stretch(parameters_, block, p_[i]);
  }
}

/// Adds the dashpots to the force of the support on the side where that is.
void Simulation::damp_support() {
  const bool is_below = !has_constant_p(parameters_);
  const double* v_z = state_.v_z.row(is_below ? 0 : parameters_.Nz - 1);
  dashpot_power_ = 0.0;
  for (std::size_t i = 0; i < p_.size(); ++i) {
    const double elastic = is_below ? p_[i] : top_[i];
    const double inwards = is_below ? -v_z[i] : v_z[i];
    const double f = elastic > 0.0 ? std::max(eta_f_ * inwards, -elastic) : 0.0;
    (is_below ? bottom_ : top_)[i] = elastic + f;
    dashpot_power_ += f * inwards;
  }
}

void Simulation::note_ruptures() {
  for (auto& [fraction, below] : pinned_below_) {
    const double limit = pinned_limit(parameters_, fraction);
    for (std::size_t i = 0; i < below.size(); ++i) {
      const bool now = law_->pinned()[i] < limit;
      if (now && !below[i]) {
        ruptures_.push_back({state_.step, time(), static_cast<std::int64_t>(i), fraction});
        if (fraction == kRupturedFraction) {
          add_rupture(parameters_, ruptures_.back(), run_);
          watched_ruptures_ |= watched_ == ruptures_.back().block;
        }
      }
      below[i] = now;
    }
  }
}

Power Simulation::power(double damping_power, const double* bottom_velocity) const {
  Power now;
  now.driving = F_T_ * parameters_.V;
  now.damping = -damping_power;
  for (std::size_t i = 0; i < tau_.size(); ++i) now.junctions += tau_[i] * bottom_velocity[i];
  return now;
}

/// The damping force at the half-kicked velocity is gone; at the full one it is nearly the same.
Power Simulation::initial_power() {
  Field f_x(parameters_.Nx, parameters_.Nz), f_z(f_x);
  bulk_.damping(state_, f_x, f_z);
  return power((f_x.blocks() * state_.v_x.blocks() + f_z.blocks() * state_.v_z.blocks()).sum() -
                   dashpot_power_,
               state_.v_x.row(0));
}

/// Work done in the step just finished.
void Simulation::add_work() {
  const double damping_power = bulk_.damping_power();
  blown_up_ = !std::isfinite(damping_power);
  const Power now = power(damping_power - dashpot_power_, bulk_.bottom_velocity());
  work_ += integrate(power_, now, parameters_.dt);
  power_ = now;
}

Energies Simulation::energies() const {
  Energies e;
  e.kinetic = bulk_.kinetic_energy(state_.v_x, state_.v_z);
  e.bulk = bulk_.elastic_energy(state_.u_x, state_.u_z);
  for (Eigen::Index i = 0; i < parameters_.Nx; ++i) {
    const double bottom = state_.u_z(i, 0), top = state_.u_z(i, parameters_.Nz - 1);
    const NormalContact& normal = normal_[static_cast<std::size_t>(i)];
    e.contact += normal.contact_energy(bottom, top);
    e.load += normal.load_energy(bottom, top);
  }
  e.driving = parameters_.K > 0.0 ? 0.5 * F_T_ * F_T_ / parameters_.K : 0.0;
  return e;
}

void Simulation::report_blow_up() const {
  for (Eigen::Index j = 0; j < parameters_.Nz; ++j) {
    for (Eigen::Index i = 0; i < parameters_.Nx; ++i) {
      if (std::isfinite(state_.v_x(i, j)) && std::isfinite(state_.v_z(i, j))) continue;
      throw Alarm(
          "numerical blow-up at t = {:.7g} s in block ({}, {}): start again with a "
          "smaller numerics.dt or change the parameters by less",
          time(), i, j);
    }
  }
  throw Alarm("numerical blow-up at t = {:.7g} s", time());
}

State continued(State state, const Parameters& after) {
  const Parameters before = state.made_with;
  refuse_changes_of_kept(before, after);
  refuse_other_springs(before, after);
  validate(after);
  change_law(before, after, time(before, state), state.junctions);
  change_pace(before, after, state);
  state.made_with = after;
  return state;
}

}  // namespace rupture
