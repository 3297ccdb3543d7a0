#include "rupture/dynamics/simulation.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"

namespace rupture {

Simulation::Simulation(const Parameters& parameters, State state)
    : parameters_((validate(parameters), parameters)),
      half_kick_(parameters.dt / (2.0 * block_mass(parameters))),
      state_(std::move(state)),
      bulk_(parameters),
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

void Simulation::advance() {
  const VectorView u = view(state_.u_x, state_.u_z);
  const VectorView v = view(state_.v_x, state_.v_z);
  const ConstVectorView f = {state_.f_x.row(0), state_.f_z.row(0)};

  kernels().kick_drift(bulk_.shape(), half_kick_, parameters_.dt, f, v, u);
  ++state_.step;

  find_normal_forces();
  const auto changes = law_.update(state_.u_x.row(0), contact(), time());
  law_.friction(state_.u_x.row(0), contact(), tau_.data());
  if (changes.broken > 0) last_break_ = state_.step;
  if (changes.broken + changes.repinned > 0) note_ruptures();

  F_T_ = driving_force(parameters_, state_);
  const Boundary boundary = {p_.data(), tau_.data(), mean_normal_force(parameters_),
                             driving_row(parameters_), F_T_};
  const double damping_power = bulk_.finish(half_kick_, boundary, state_);
  add_work(damping_power);
  if (!std::isfinite(damping_power)) report_blow_up();
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

Power Simulation::power(double damping_power) const {
  Power now;
  now.driving = F_T_ * parameters_.V;
  now.damping = -damping_power;
  for (Eigen::Index i = 0; i < parameters_.Nx; ++i) {
    now.junctions += tau_[static_cast<std::size_t>(i)] * state_.v_x(i, 0);
  }
  return now;
}

/// The damping force at the half-kicked velocity is gone; at the full one it is nearly the same.
Power Simulation::initial_power() {
  Field f_x(parameters_.Nx, parameters_.Nz), f_z(f_x);
  bulk_.damping(state_.v_x, state_.v_z, f_x, f_z);
  return power((f_x.blocks() * state_.v_x.blocks() + f_z.blocks() * state_.v_z.blocks()).sum());
}

void Simulation::add_work(double damping_power) {
  const Power now = power(damping_power);
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
