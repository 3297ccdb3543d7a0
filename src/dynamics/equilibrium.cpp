#include "rupture/dynamics/equilibrium.hpp"

#include <fmt/core.h>

#include <cmath>

#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"
#include "statics.hpp"

namespace rupture {
namespace {

void place_driving_point(const Parameters& p, State& state) {
  state.drive = {state.step, state.u_x(0, driving_row(p))};
}

void check_strength(const Parameters& p, const State& state) {
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    const auto friction = interface_forces(p, {}, state, i);
    if (std::abs(friction.tau) <= p.mu_s * friction.p) continue;
    throw Failure(fmt::format(
        "the junctions of block {} cannot bear the normal load: |f|/f_thres = {:.3g} at F_N = {:g} "
        "N; raise junctions.mu_s or slider.foundation, or lower slider.F_N",
        i, std::abs(friction.tau) / (p.mu_s * friction.p), p.F_N));
  }
}

}  // namespace

double static_residual(const Parameters& p, const State& state) {
  Bulk bulk(p);
  Field f_x(p.Nx, p.Nz), f_z(p.Nx, p.Nz);
  static_forces(p, {}, bulk, state, f_x, f_z);
  return largest(f_x, f_z);
}

State normal_load_equilibrium(const Parameters& p) {
  validate(p);
  auto state = solve_statics(p, {});
  if (!state) {
    throw Failure(
        fmt::format("no equilibrium under F_N = {:g} N was found: the load is too large for "
                    "slider.E = {:g} Pa or the slider tips over",
                    p.F_N, p.E));
  }
  check_strength(p, *state);
  place_driving_point(p, *state);
  return *std::move(state);
}

State relaxed_equilibrium(const Parameters& p, double duration) {
  validate(p);
  State state = relax(p, {}, duration);
  place_driving_point(p, state);
  return state;
}

}  // namespace rupture
