#include "rupture/model/state.hpp"

#include <cmath>

#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/laws.hpp"

namespace rupture {

State::State(const Parameters& p)
    : made_with(p),
      u_x(p.Nx, p.Nz),
      u_z(p.Nx, p.Nz),
      v_x(p.Nx, p.Nz),
      v_z(p.Nx, p.Nz),
      f_x(p.Nx, p.Nz),
      f_z(p.Nx, p.Nz) {
  const std::int64_t springs = springs_per_block(p);
  junctions.attachment.setZero(p.Nx, springs);
  junctions.repin_time.setConstant(p.Nx, springs, Junctions::never);
  junctions.draws.setZero(p.Nx, springs);
  if (const auto& memory = law_info(p.law).memory) {
    (junctions.*memory->array).setZero(p.Nx, springs);
  }
}

void refuse_other_parameters(const State& state, const Parameters& parameters) {
  const auto others = differing(state.made_with, parameters);
  if (others.empty()) return;
  const ParameterInfo& info = *others.front();
  throw UsageError(
      "{} = {}, but the state was made with {}: give the state to continued() to change it",
      info.name, parameter_text(parameters, info), parameter_text(state.made_with, info));
}

double time_at(const Parameters& p, const Clock& clock, std::int64_t step) {
  return clock.origin_time + static_cast<double>(step - clock.origin_step) * p.dt;
}

std::int64_t steps_in(const Parameters& p, double duration) {
  const double steps = std::round(duration / p.dt);
  if (!(std::abs(steps) < 0x1p53)) {
    throw UsageError("{:g} s is too long for time steps of {:g} s", duration, p.dt);
  }
  return static_cast<std::int64_t>(steps);
}

std::int64_t step_at(const Parameters& p, const Clock& clock, double t) {
  return clock.origin_step + steps_in(p, t - clock.origin_time);
}

double time(const Parameters& p, const State& state) {
  return time_at(p, state.clock, state.step);
}

double drive_position(const Parameters& p, const Drive& drive, std::int64_t step) {
  return drive.origin_position + p.V * (static_cast<double>(step - drive.origin_step) * p.dt);
}

void change_pace(const Parameters& before, const Parameters& after, State& state) {
  if (before.dt == after.dt && before.V == after.V) return;
  state.drive = {state.step, drive_position(before, state.drive, state.step)};
  if (before.dt != after.dt) state.clock = {state.step, time(before, state)};
}

double driving_force(const Parameters& p, const State& state) {
  const double x_drive = drive_position(p, state.drive, state.step);
  return p.K * (x_drive - state.u_x(0, driving_row(p)));
}

double pinned_fraction(const Junctions& junctions, Eigen::Index i) {
  const auto row = junctions.repin_time.row(i);
  return static_cast<double>((row >= Junctions::never).count()) / static_cast<double>(row.size());
}

}  // namespace rupture
