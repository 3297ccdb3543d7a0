// Damping forces eta sum_j (v_j - v_i) over the up to eight neighbours, as a 3 x 3 sum.
#pragma once

#include "pair.hpp"

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

void damping(const LatticeShape& n, const Dampers& d, ConstVectorView v, VectorView f) {
  for (Index j = 0; j < n.Nz; ++j) {
    const auto row = [&](Index r) {
      return ConstVectorView{v.x + r * n.stride, v.z + r * n.stride};
    };
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
