// The two halves of a time step on the bulk: kick and drift, and its end (dynamics/simulation.hpp).
#pragma once

#include "dampers.hpp"
#include "springs.hpp"

namespace rupture {
namespace {

/// Rows that a band keeps between `prepare` and `finish`, of length stride + 16.
struct BandRows {
  VectorView from_below;     ///< see add_springs()
  VectorView v_below;        ///< velocities of the row below before its kick, at which damping acts
  VectorView u_above;        ///< displacements of the row above the band
  VectorView v_above;        ///< and velocities
  VectorView dampers_below;  ///< as from_below, of dampers along springs
  VectorView dampers;        ///< their forces on one row
  double* unused;            ///< for what nobody wants to keep
  VectorView springs;        ///< forces on one chunk of blocks
};

constexpr Index kBandRows = 13;

inline Index row_size(const LatticeShape& n) {
  return n.stride + 16;
}

std::ptrdiff_t scratch_size(const LatticeShape& n) {
  return kBandRows * row_size(n) + 2 * kChunk;
}

inline BandRows rows_of(const LatticeShape& n, const Band& band) {
  const auto row = [&](Index r) { return band.scratch + r * row_size(n) + 8; };
  const auto pair = [&](Index r) { return VectorView{row(2 * r), row(2 * r + 1)}; };
  double* chunk = band.scratch + kBandRows * row_size(n);
  return {pair(0), pair(1), pair(2), pair(3), pair(4), pair(5), row(12), {chunk, chunk + kChunk}};
}

inline const SpringRow& stiffness_of(const LatticeShape& n, const Springs& c, Index j) {
  return j + 1 == n.Nz ? c.top_row : j == 0 ? c.bottom_row : c.row;
}

inline void copy(const LatticeShape& n, VectorView from, VectorView to) {
  for (Index i = 0; i < n.stride; i += RUPTURE_LANES) {
    store(to, i, load(from, i));
  }
}

inline void clear(const LatticeShape& n, VectorView row) {
  for (Index i = 0; i < n.stride; i += RUPTURE_LANES) store(row, i, Pair{});
}

/// First half kick and drift of blocks i, i + 1, ... of a row, from their forces and velocities.
inline void kick_drift(const Motion& m, Index i, Pair f, Pair velocity, VectorView v,
                       VectorView u) {
  const Pair kicked = velocity + m.half_kick * f;
  store(v, i, kicked);
  store(u, i, load(u, i) + m.dt * kicked);
}

void kick_drift(const LatticeShape& n, const Motion& m, const Band& band) {
  for (Index j = band.first; j < band.last; ++j) {
    const VectorView f = row_of(n, m.f, j), v = row_of(n, m.v, j), u = row_of(n, m.u, j);
    for (Index i = 0; i < n.Nx; i += RUPTURE_LANES) {
      kick_drift(m, i, load(f, i), load(v, i), v, u);
    }
  }
}

/// Row `Nz` is as far from the top row as nothing: its springs are unstretched and have no
/// stiffness.
void prepare(const LatticeShape& n, const Springs& c, const Dampers& d, const Motion& m,
             const Band& band) {
  const BandRows rows = rows_of(n, band);
  copy(n, row_of(n, m.u, band.last < n.Nz ? band.last : n.Nz - 1), rows.u_above);
  copy(n, row_of(n, m.v, band.last), rows.v_above);
  copy(n, row_of(n, m.v, band.first - 1), rows.v_below);
  clear(n, rows.from_below);
  clear(n, rows.dampers_below);
  if (band.first == 0) return;
  const Index below = band.first - 1;
  const auto u = [&](Index j) { return constant(row_of(n, m.u, j)); };
  const auto v = [&](Index j) { return constant(row_of(n, m.v, j)); };
  each_force(n, c, stiffness_of(n, c, below), u(below), u(band.first), rows.from_below,
             rows.springs, [](Index, const Pair&) {});
  if (along(d) == Along::velocity) return;
  add_dampers(n, c, d, below, u(below), u(band.first), v(below), v(band.first), rows.dampers_below,
              rows.dampers);
}

/// Subtracts what the boundary does to row j from the reversed forces that the row receives.
inline void add_boundary(const LatticeShape& n, const Boundary& boundary, Index j,
                         VectorView reversed) {
  if (j == 0) {
    for (Index i = 0; i < n.Nx; ++i) reversed.x[i] += boundary.tau[i];
    for (Index i = 0; i < n.Nx; ++i) reversed.z[i] -= boundary.p[i];
  }
  if (j + 1 == n.Nz) {
    for (Index i = 0; i < n.Nx; ++i) reversed.z[i] += boundary.top[i];
  }
  if (j == boundary.driving_row) reversed.x[0] -= boundary.F_T;
}

template <Then then, Along damped>
void finish_then(LatticeShape n, Springs c, Dampers d, Boundary boundary, Motion m, Band band,
                 StepResult result) {
  const BandRows rows = rows_of(n, band);
  for (Index j = band.first; j < band.last; ++j) {
    const bool is_last = j + 1 == band.last;
    const VectorView u = row_of(n, m.u, j), v = row_of(n, m.v, j);
    const VectorView u_above = is_last ? rows.u_above : row_of(n, m.u, j + 1);
    const VectorView v_above = is_last ? rows.v_above : row_of(n, m.v, j + 1);
    const VectorView f = row_of(n, m.f, j);
    double* v_x_at_end = j == 0 ? result.bottom_velocity : rows.unused;
    const double neighbour_rows = rows_around(n, j);
    double power[kParts] = {};

    add_boundary(n, boundary, j, rows.from_below);
    const auto sum = [&](Index i) {
      return sum_of_rows(constant(rows.v_below), constant(v), constant(v_above), i);
    };
    Pair before = {}, here = sum(0);
    if constexpr (damped == Along::spring) {
      add_dampers(n, c, d, j, constant(u), constant(u_above), constant(v), constant(v_above),
                  rows.dampers_below, rows.dampers);
    }
    each_force(n, c, stiffness_of(n, c, j), constant(u), constant(u_above), rows.from_below,
               rows.springs, [&](Index i, const Pair& springs) {
                 const Pair velocity = load(v, i);
                 Pair damping;
                 if constexpr (damped == Along::spring) {
                   damping = load(rows.dampers, i);
                 } else {
                   const Pair after = sum(i + RUPTURE_LANES);
                   const Pair left = shifted_up(before, here), right = shifted_down(here, after);
                   damping = damping_force(load(d.eta + i), neighbour_rows * load(d.columns + i),
                                           left, here, right, velocity);
                   before = here;
                   here = after;
                 }
                 store(rows.v_below, i, velocity);

                 const Pair force = springs + damping;
                 const Pair kicked = velocity + m.half_kick * force;
                 double* part = power + i % kParts;
                 store(part, load(part) + (damping.x * kicked.x + damping.z * kicked.z));
                 store(v_x_at_end + i, kicked.x);
                 if constexpr (then == Then::stop) {
                   store(f, i, force);
                   store(v, i, kicked);
                 } else {
                   kick_drift(m, i, force, kicked, v, u);
                 }
               });
    result.damping_power[j] = sum_of_parts(power);
  }
}

void finish(const LatticeShape& n, const Springs& c, const Dampers& d, const Boundary& boundary,
            const Motion& m, const Band& band, Then then, const StepResult& result) {
  const auto work = along(d) == Along::spring
                        ? (then == Then::stop ? finish_then<Then::stop, Along::spring>
                                              : finish_then<Then::go_on, Along::spring>)
                        : (then == Then::stop ? finish_then<Then::stop, Along::velocity>
                                              : finish_then<Then::go_on, Along::velocity>);
  work(n, c, d, boundary, m, band, result);
}

void elastic(const LatticeShape& n, const Springs& c, ConstVectorView u, VectorView f,
             const Band& band) {
  const BandRows rows = rows_of(n, band);
  const Index top = n.Nz - 1;
  clear(n, rows.from_below);
  for (Index j = 0; j < n.Nz; ++j) {
    const VectorView f_row = row_of(n, f, j);
    each_force(n, c, stiffness_of(n, c, j), row_of(n, u, j), row_of(n, u, j < top ? j + 1 : j),
               rows.from_below, rows.springs,
               [&](Index i, const Pair& force) { store(f_row, i, force); });
  }
}

void damping(const LatticeShape& n, const Springs& c, const Dampers& d, ConstVectorView u,
             ConstVectorView v, VectorView f, const Band& band) {
  if (along(d) == Along::velocity) return damping_along_velocity(n, d, v, f);
  const BandRows rows = rows_of(n, band);
  clear(n, rows.dampers_below);
  for (Index j = 0; j < n.Nz; ++j) {
    add_dampers(n, c, d, j, row_of(n, u, j), row_of(n, u, j + 1 < n.Nz ? j + 1 : j),
                row_of(n, v, j), row_of(n, v, j + 1), rows.dampers_below, row_of(n, f, j));
  }
}

}  // namespace
}  // namespace rupture
