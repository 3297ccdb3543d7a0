#include "rupture/dynamics/simulation.hpp"

#include <fmt/core.h>
#ifdef _OPENMP
#include <omp.h>
#endif

#include <cmath>
#include <utility>

#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"

namespace rupture {
namespace {

int this_thread() {
#ifdef _OPENMP
  return omp_get_thread_num();
#else
  return 0;
#endif
}

}  // namespace

Simulation::Simulation(const Parameters& parameters, State state, int threads)
    : parameters_((validate(parameters), parameters)),
      state_(std::move(state)),
      bulk_(parameters, threads),
      law_(parameters, state_.junctions),
      p_(static_cast<std::size_t>(parameters.Nx)),
      k_ij_(p_),
      w_(p_),
      tau_(p_),
      last_break_(state_.step),
      ruptured_(p_.size()) {
  find_normal_forces();
  law_.friction(state_.u_x.row(0), contact(), tau_.data());
  F_T_ = driving_force(parameters_, state_);
  note_ruptures();
  ruptures_.clear();  // blocks that had ruptured before this simulation began
  leading_edge_ruptured_ = false;
  power_ = initial_power();
}

void Simulation::advance(std::int64_t steps) {
  if (bulk_.bands() == 1) {
    advance_band(0, steps);
  } else {
#pragma omp parallel num_threads(bulk_.bands())
    advance_band(this_thread(), steps);
  }
  if (!blown_up_) add_work();
  if (blown_up_) report_blow_up();
}

/// What one thread does. The first one also moves the interface, while no other changes the state.
void Simulation::advance_band(int band, std::int64_t steps) {
  const bool is_first = band == 0;
  bulk_.kick_drift(band, state_);
  for (std::int64_t n = 0; n < steps; ++n) {
#pragma omp barrier
    bulk_.prepare(band, state_);
    if (is_first && n > 0) add_work();
    if (is_first) move_interface();
#pragma omp barrier
    if (blown_up_) return;
    const Boundary boundary = {p_.data(), tau_.data(), mean_normal_force(parameters_),
                               driving_row(parameters_), F_T_};
    bulk_.finish(band, boundary, n + 1 < steps ? Then::go_on : Then::stop, state_);
  }
}

/// Steps 2 and 3 of the scheme, and the driving force of step 4.
void Simulation::move_interface() {
  ++state_.step;
  find_normal_forces();
  const auto changes = law_.update(state_.u_x.row(0), contact(), time());
  law_.friction(state_.u_x.row(0), contact(), tau_.data());
  if (changes.broken > 0) last_break_ = state_.step;
  if (changes.broken + changes.repinned > 0) note_ruptures();
  F_T_ = driving_force(parameters_, state_);
}

void Simulation::find_normal_forces() {
  kernels().contact(parameters_.Nx, state_.u_z.row(0), foundation_stiffness(parameters_),
                    static_cast<double>(parameters_.N_s), parameters_.kappa, contact());
}

void Simulation::note_ruptures() {
  const double limit = kRupturedFraction * static_cast<double>(parameters_.N_s);
  for (std::size_t i = 0; i < ruptured_.size(); ++i) {
    const bool now = law_.pinned()[i] < limit;
    if (now && !ruptured_[i]) {
      ruptures_.push_back({state_.step, time(), static_cast<std::int64_t>(i)});
      leading_edge_ruptured_ |= i + 1 == ruptured_.size();
    }
    ruptured_[i] = now;
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
  bulk_.damping(state_.v_x, state_.v_z, f_x, f_z);
  return power((f_x.blocks() * state_.v_x.blocks() + f_z.blocks() * state_.v_z.blocks()).sum(),
               state_.v_x.row(0));
}

/// Work done in the step just finished.
void Simulation::add_work() {
  const double damping_power = bulk_.damping_power();
  blown_up_ = !std::isfinite(damping_power);
  const Power now = power(damping_power, bulk_.bottom_velocity());
  const double half_dt = 0.5 * parameters_.dt;
  work_.driving += half_dt * (power_.driving + now.driving);
  work_.damping += half_dt * (power_.damping + now.damping);
  work_.junctions += half_dt * (power_.junctions + now.junctions);
  power_ = now;
}

Energies Simulation::energies() const {
  Energies e;
  e.kinetic = bulk_.kinetic_energy(state_.v_x, state_.v_z);
  e.bulk = bulk_.elastic_energy(state_.u_x, state_.u_z);
  const double k_f = foundation_stiffness(parameters_);
  for (Eigen::Index i = 0; i < parameters_.Nx; ++i) {
    const double u_z = state_.u_z(i, 0);
    if (u_z < 0.0) e.contact += 0.5 * k_f * u_z * u_z;
    e.load += mean_normal_force(parameters_) * state_.u_z(i, parameters_.Nz - 1);
  }
  e.driving = parameters_.K > 0.0 ? 0.5 * F_T_ * F_T_ / parameters_.K : 0.0;
  return e;
}

void Simulation::report_blow_up() const {
  for (Eigen::Index j = 0; j < parameters_.Nz; ++j) {
    for (Eigen::Index i = 0; i < parameters_.Nx; ++i) {
      if (std::isfinite(state_.v_x(i, j)) && std::isfinite(state_.v_z(i, j))) continue;
      throw Failure(
          fmt::format("numerical blow-up at t = {:.7g} s in block ({}, {}): go back to the last "
                      "checkpoint and use a smaller numerics.dt",
                      time(), i, j));
    }
  }
  throw Failure(fmt::format("numerical blow-up at t = {:.7g} s", time()));
}

}  // namespace rupture
