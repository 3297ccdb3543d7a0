// Two oracles of sliders at rest: the net force on them, and the paper's way to find them.
#pragma once

#include <cmath>

#include "dynamics/statics.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::testing {

/// Largest component of the net static force on any block, driving excluded [N].
inline double static_residual(const Parameters& p, const State& state) {
  Bulk bulk(p);
  Field f_x(p.Nx, p.Nz), f_z(p.Nx, p.Nz);
  static_forces(p, {}, bulk, state, f_x, f_z);
  return largest(f_x, f_z);
}

/// The slider at rest by damped relaxation: velocity Verlet with an extra force -alpha v, alpha =
/// eta/40, on every block for `duration` [s].
inline State relaxed(const Parameters& p, const LoadCase& load_case, double duration) {
  Bulk bulk(p);
  State state = compressed(p);
  Field damping_x(p.Nx, p.Nz), damping_z(p.Nx, p.Nz);
  const double alpha = damping_coefficient(p) / 40.0, half_kick = p.dt / (2.0 * block_mass(p));
  const auto kick = [&](Field& v, Field& f, const Field& damping) {
    for (Eigen::Index j = 0; j < p.Nz; ++j) {
      double *v_j = v.row(j), *f_j = f.row(j);
      const double* damping_j = damping.row(j);
      for (Eigen::Index i = 0; i < p.Nx; ++i) {
        f_j[i] += damping_j[i] - alpha * v_j[i];
        v_j[i] += half_kick * f_j[i];
      }
    }
  };
  for (auto n = std::llround(duration / p.dt); n > 0; --n) {
    bulk.kick_drift(0, state);
    static_forces(p, load_case, bulk, state, state.f_x, state.f_z);
    bulk.damping(state, damping_x, damping_z);
    kick(state.v_x, state.f_x, damping_x);
    kick(state.v_z, state.f_z, damping_z);
  }
  return state;
}

}  // namespace rupture::testing
