// Forces of the bulk springs, each spring computed once.
#pragma once

#include "pair.hpp"

namespace rupture {
namespace {

/// A spring along lattice vector (ix, iz) l whose far end has moved by d = (dx, dz) relative to
/// the near end.
template <int ix, int iz>
struct Spring {
  Pair d;

  /// S = s l^2 = (r^2 - l_0^2) / n with n = ix^2 + iz^2, l_0^2 = n l^2. It does not cancel at small
  /// strain: r^2 - l_0^2 = (2 ix l + dx) dx + (2 iz l + dz) dz.
  Lanes strain(double l) const {
    const Lanes difference = along<2 * ix>(l, d.x) * d.x + along<2 * iz>(l, d.z) * d.z;
    if constexpr (ix != 0 && iz != 0) return 0.5 * difference;
    return difference;
  }

  /// Pair on the near end: tension times r.
  Pair pull(double l, Lanes tension) const {
    return tension * Pair{along<ix>(l, d.x), along<iz>(l, d.z)};
  }

  /// Pair on the near end of a damper along the spring: eta (w.n) n with n = r/|r|, where the far
  /// end moves at w relative to the near end. Where the ends meet there is no n, nor a force.
  Pair damp(double l, Lanes eta, const Pair& w) const {
    const Lanes x = along<ix>(l, d.x), z = along<iz>(l, d.z);
    return pull(l, eta * (x * w.x + z * w.z) / larger(x * x + z * z, kTiny + Lanes{}));
  }

 private:
  /// i l + d, without the addition where i = 0.
  template <int i>
  static Lanes along(double l, Lanes d) {
    if constexpr (i == 0) return d;
    return i * l + d;
  }
  static constexpr double kTiny = 1e-300;  // [m^2]
};

/// The springs that start in a block, see add_springs(); of velocities, their relative velocities.
struct Bonds {
  Spring<1, 0> right;
  Spring<0, 1> up;
  Spring<1, 1> rise;
  Spring<-1, 1> fall;
};

inline Bonds bonds(ConstVectorView u, ConstVectorView up, Index i) {
  const Pair here = load(u, i), to_right = load(u, i + 1);
  const Pair above = load(up, i), to_above_right = load(up, i + 1);
  return {{to_right - here}, {above - here}, {to_above_right - here}, {above - to_right}};
}

/// Tension per length of springs with stiffness k, k (1 - l_0/r) = k (1 - 1/sqrt(1+s)).
struct Tension {
  Lanes k, S, SS;  // stiffness, s l^2 and its square
  Lanes value;

  Tension at_large_strain(const Springs& c) const;
};

/// At small strain by the series k (s/2 - 3/8 s^2 + 5/16 s^3 - 35/128 s^4 + 63/256 s^5 - 231/1024
/// s^6), without square root and division: up to |s| = 1/400 the rest is less than the rounding.
inline Tension tension(const Springs& c, Lanes k, Lanes S) {
  const Lanes SS = S * S;
  const Lanes terms_01 = c.series[0] + c.series[1] * S;
  const Lanes terms_23 = c.series[2] + c.series[3] * S;
  const Lanes terms_45 = c.series[4] + c.series[5] * S;
  return {k, S, SS, (k * S) * (terms_01 + SS * (terms_23 + SS * terms_45))};
}

/// Beyond, as k s / (q + q^2) with q^2 = 1 + s, which does not cancel either.
inline Tension Tension::at_large_strain(const Springs& c) const {
  const Lanes s = S / (c.l * c.l);
  const Lanes q2 = 1.0 + s;
  return {k, S, SS, SS > c.small ? k * s / (square_root(q2) + q2) : value};
}

/// Blocks whose forces one loop hands to the next, few enough to stay in the nearest cache.
constexpr Index kChunk = 64;

/// Forces of the springs that start in a block on the blocks to its right.
struct ToRight {
  Pair same_row;   ///< on (i+1, j): fall - right
  Pair row_above;  ///< on (i+1, j+1), reversed: rise
};

/// The forces of the springs that start in blocks i, i + 1, ... on their near ends.
struct Pulls {
  Pair right, up, rise, fall;
};

/// Gives each force to both ends of its spring, see add_springs(); `here` is where the sum goes.
[[gnu::always_inline]] inline ToRight share_out(const Pulls& f, ToRight left, Index i,
                                                VectorView from_below, VectorView forces,
                                                Index here) {
  const ToRight now = {f.fall - f.right, f.rise};
  const Pair from_left = shifted_up(left.same_row, now.same_row);
  store(forces, here, (((f.right + f.rise) + f.up) + from_left) - load(from_below, i));
  store(from_below, i, (f.up + f.fall) + shifted_up(left.row_above, now.row_above));
  return now;
}

/// Sums of the springs' forces on blocks first..last-1 of a row at displacements u, `up` being the
/// row above. `from_below` holds, reversed, what these blocks receive from the row below, and then
/// what those above receive. `left` comes from the block before; returns the same for the next.
///
///     (i,j+1)   (i+1,j+1)        right:  (i,j)   - (i+1,j)
///        |  \ /  |               up:     (i,j)   - (i,j+1)
///        |  / \  |               rise:   (i,j)   - (i+1,j+1)
///     (i,j) --- (i+1,j)          fall:   (i+1,j) - (i,j+1)
[[gnu::always_inline]] inline ToRight add_springs(const Springs& springs, SpringRow stiffness,
                                                  ConstVectorView u, ConstVectorView up,
                                                  Index first, Index last, ToRight left,
                                                  VectorView from_below, VectorView forces) {
  const Springs c = springs;  // a copy, which no store to `forces` can change
  const double l = c.l;
  for (Index i = first; i < last; i += RUPTURE_LANES) {
    const auto [right, upward, rise, fall] = bonds(u, up, i);
    const Lanes k_right = load(stiffness.k_right + i), k_up = load(stiffness.k_up + i);
    const Lanes k_diagonal = load(stiffness.k_diagonal + i);
    Tension t_right = tension(c, k_right, right.strain(l));
    Tension t_up = tension(c, k_up, upward.strain(l));
    Tension t_rise = tension(c, k_diagonal, rise.strain(l));
    Tension t_fall = tension(c, k_diagonal, fall.strain(l));
    const Lanes largest = larger(t_right.SS, larger(t_rise.SS, t_fall.SS));
    if (any_larger(largest, load(c.small_right + i)) || any_larger(t_up.SS, c.small - Lanes{})) {
      t_right = t_right.at_large_strain(c);
      t_up = t_up.at_large_strain(c);
      t_rise = t_rise.at_large_strain(c);
      t_fall = t_fall.at_large_strain(c);
    }

    const Pulls pulls = {right.pull(l, t_right.value), upward.pull(l, t_up.value),
                         rise.pull(l, t_rise.value), fall.pull(l, t_fall.value)};
    left = share_out(pulls, left, i, from_below, forces, i - first);
  }
  return left;
}

/// Calls use(i, force) for every register of blocks of a row.
template <class Use>
void each_force(const LatticeShape& n, const Springs& c, const SpringRow& stiffness,
                ConstVectorView u, ConstVectorView up, VectorView from_below, VectorView forces,
                Use use) {
  ToRight left = {};
  for (Index first = 0; first < n.Nx; first += kChunk) {
    const Index last = first + kChunk < n.Nx ? first + kChunk : n.Nx;
    left = add_springs(c, stiffness, u, up, first, last, left, from_below, forces);
    for (Index i = first; i < last; i += RUPTURE_LANES) use(i, load(forces, i - first));
  }
}

}  // namespace
}  // namespace rupture
