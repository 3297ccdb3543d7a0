// Damping forces eta sum_j (v_j - v_i) over the up to eight neighbours, as a 3 x 3 sum; or damper
// by damper where each acts along its spring.
#pragma once

#include "springs.hpp"

namespace rupture {
namespace {

/// v[j-1] + v[j+1] + v[j] from three rows.
inline Pair sum_of_rows(ConstVectorView below, ConstVectorView here, ConstVectorView above,
                        Index i) {
  return (load(below, i) + load(above, i)) + load(here, i);
}

/// eta sum_j (v_j - v_i) over the 3 x 3 neighbourhood, from the sums over its three columns.
/// `blocks` is how many blocks the neighbourhood has, block i included.
inline Pair damping_force(Lanes eta, Lanes blocks, Pair left, Pair here, Pair right, Pair v) {
  return eta * (((left + right) + here) - blocks * v);
}

/// Rows among j - 1, j, j + 1 that exist.
inline double rows_around(const LatticeShape& n, Index j) {
  return (j == 0 || j + 1 == n.Nz) ? 2.0 : 3.0;
}

enum class Along { velocity, spring };

inline Along along(const Dampers& d) {
  return d.row.k_up == nullptr ? Along::velocity : Along::spring;
}

/// Sums of the dampers' forces along their springs on the blocks of row j at displacements u and
/// velocities v, as add_springs() has those of the springs.
void add_dampers(const LatticeShape& n, const Springs& c, const Dampers& d, Index j,
                 ConstVectorView u, ConstVectorView u_up, ConstVectorView v, ConstVectorView v_up,
                 VectorView from_below, VectorView forces) {
  const SpringRow& eta = j + 1 < n.Nz ? d.row : d.top_row;
  ToRight left = {};
  for (Index i = 0; i < n.Nx; i += RUPTURE_LANES) {
    const Bonds r = bonds(u, u_up, i), w = bonds(v, v_up, i);
    const Lanes eta_right = load(eta.k_right + i), eta_diagonal = load(eta.k_diagonal + i);
    const Pulls pulls = {
        r.right.damp(c.l, eta_right, w.right.d), r.up.damp(c.l, load(eta.k_up + i), w.up.d),
        r.rise.damp(c.l, eta_diagonal, w.rise.d), r.fall.damp(c.l, eta_diagonal, w.fall.d)};
    left = share_out(pulls, left, i, from_below, forces, i);
  }
}

void damping_along_velocity(const LatticeShape& n, const Dampers& d, ConstVectorView v,
                            VectorView f) {
  for (Index j = 0; j < n.Nz; ++j) {
    const auto row = [&](Index r) { return row_of(n, v, r); };
    const auto sum = [&](Index i) { return sum_of_rows(row(j - 1), row(j), row(j + 1), i); };
    for (Index i = 0; i < n.Nx; i += RUPTURE_LANES) {
      const Lanes blocks = rows_around(n, j) * load(d.columns + i);
      store(
          f, j * n.stride + i,
          damping_force(load(d.eta + i), blocks, sum(i - 1), sum(i), sum(i + 1), load(row(j), i)));
    }
  }
}

}  // namespace
}  // namespace rupture
