// The loops of kernels.hpp, compiled once per instruction set: RUPTURE_ISA names this variant.
// Nothing here may include a library header with inline functions: the linker would keep one copy
// of each for all variants, possibly one that the processor cannot run.
#include <math.h>

#include "rupture/forces/kernels.hpp"
#include "rupture/model/never.hpp"

#define RUPTURE_STRING_(x) #x
#define RUPTURE_STRING(x) RUPTURE_STRING_(x)
#define RUPTURE_JOIN_(a, b) a##b
#define RUPTURE_JOIN(a, b) RUPTURE_JOIN_(a, b)

namespace rupture {
namespace {

using Index = std::ptrdiff_t;

/// Row r of the scratch space; entries -8..-1 exist and are zero.
double* scratch_row(const LatticeShape& n, double* scratch, Index r) {
  return scratch + r * (n.stride + 8) + 8;
}

void kick_drift(LatticeShape n, double half_kick, double dt, ConstVectorView f, VectorView v,
                VectorView u) {
  const Index size = n.Nz * n.stride;
  const double* fx = f.x;
  const double* fz = f.z;
  double* vx = v.x;
  double* vz = v.z;
  double* ux = u.x;
  double* uz = u.z;
#pragma omp simd
  for (Index i = 0; i < size; ++i) {
    vx[i] += half_kick * fx[i];
    vz[i] += half_kick * fz[i];
    ux[i] += dt * vx[i];
    uz[i] += dt * vz[i];
  }
}

/// One vector register of doubles; arithmetic acts on each of its RUPTURE_LANES lanes.
typedef double Lanes __attribute__((vector_size(RUPTURE_LANES * sizeof(double))));

Lanes load(const double* from) {
  Lanes lanes;
  __builtin_memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

void store(double* to, Lanes lanes) {
  __builtin_memcpy(to, &lanes, sizeof lanes);
}

Lanes square_root(Lanes x) {
  for (int lane = 0; lane < RUPTURE_LANES; ++lane) x[lane] = sqrt(x[lane]);
  return x;
}

/// The lanes of `now` moved up by one; the last lane of `before` moves in.
Lanes shift_in(Lanes before, Lanes now) {
#if RUPTURE_LANES == 8
  return __builtin_shufflevector(before, now, 7, 8, 9, 10, 11, 12, 13, 14);
#elif RUPTURE_LANES == 4
  return __builtin_shufflevector(before, now, 3, 4, 5, 6);
#else
  return __builtin_shufflevector(before, now, 1, 2);
#endif
}

struct Force {
  Lanes x, z;
};

/// i l + d, without the addition where i = 0.
template <int i>
Lanes along(double l, Lanes d) {
  if constexpr (i == 0) {
    return d;
  } else {
    return i * l + d;
  }
}

/// Force on the near end of a spring along lattice vector (ix, iz) l whose far end moved by (dx,
/// dz) relative to the near end: F = k (r - l_0) e_r = k (1 - 1/sqrt(1+s)) r with s = (r^2 -
/// l_0^2)/l_0^2.
///
/// r^2 - l_0^2 = (2 ix l + dx) dx + (2 iz l + dz) dz and 1 - 1/q = s / (q + q^2), q^2 = 1 + s:
/// neither cancels at small strain. `exists` is 0 in lanes where there is no such spring.
template <int ix, int iz>
Force spring(Springs c, Lanes dx, Lanes dz, Lanes exists) {
  constexpr double n = ix * ix + iz * iz;  // l_0^2 = n l^2; next-nearest springs have k/2 = k/n
  const double per_length_2 = 1.0 / (n * c.l * c.l);
  const Lanes s = (along<2 * ix>(c.l, dx) * dx + along<2 * iz>(c.l, dz) * dz) * per_length_2;
  const Lanes q2 = 1.0 + s;
  const Lanes tension = ((c.k / n) * exists) * s / (square_root(q2) + q2);
  return {tension * along<ix>(c.l, dx), tension * along<iz>(c.l, dz)};
}

/// Springs inside row j and from row j to row j + 1, found from column i:
///
///     (i,j+1)   (i+1,j+1)        right:  (i,j)   - (i+1,j)
///        |  \ /  |               up:     (i,j)   - (i,j+1)
///        |  / \  |               rise:   (i,j)   - (i+1,j+1)
///     (i,j) --- (i+1,j)          fall:   (i+1,j) - (i,j+1)
///
/// `next` holds what row j receives from below and is replaced by what row j + 1 receives from row
/// j. Forces on column i + 1 are kept in `to_right` (row j) and `to_rise` (row j + 1) and shifted
/// there. `use(i, force)` receives the sum of the spring forces on blocks i, i + 1, ...
template <class Use>
void elastic_row(const LatticeShape& n, Springs c, ConstVectorView u, VectorView next, Use use) {
  Force to_right = {}, to_rise = {};
  for (Index i = 0; i < n.stride; i += RUPTURE_LANES) {
    const double* here_x = u.x + i;
    const double* here_z = u.z + i;
    const double* above_x = here_x + n.stride;
    const double* above_z = here_z + n.stride;
    const Lanes ux = load(here_x), uz = load(here_z);
    const Lanes ux_right = load(here_x + 1), uz_right = load(here_z + 1);
    const Lanes ux_above = load(above_x), uz_above = load(above_z);
    const Lanes has_right = load(n.has_right + i), inside = load(n.inside + i);

    const Force right = spring<1, 0>(c, ux_right - ux, uz_right - uz, has_right);
    const Force up = spring<0, 1>(c, ux_above - ux, uz_above - uz, inside);
    const Force rise = spring<1, 1>(c, load(above_x + 1) - ux, load(above_z + 1) - uz, has_right);
    const Force fall = spring<-1, 1>(c, ux_above - ux_right, uz_above - uz_right, has_right);

    const Force on_right = {fall.x - right.x, fall.z - right.z};
    const Force force = {
        load(next.x + i) + ((right.x + rise.x) + up.x) + shift_in(to_right.x, on_right.x),
        load(next.z + i) + ((right.z + rise.z) + up.z) + shift_in(to_right.z, on_right.z)};
    store(next.x + i, -(up.x + fall.x) - shift_in(to_rise.x, rise.x));
    store(next.z + i, -(up.z + fall.z) - shift_in(to_rise.z, rise.z));
    to_right = on_right;
    to_rise = rise;
    use(i, force);
  }
}

/// The top row: only springs inside the row remain.
template <class Use>
void elastic_top_row(const LatticeShape& n, Springs c, ConstVectorView u, ConstVectorView next,
                     Use use) {
  Force to_right = {};
  for (Index i = 0; i < n.stride; i += RUPTURE_LANES) {
    const Force right = spring<1, 0>(c, load(u.x + i + 1) - load(u.x + i),
                                     load(u.z + i + 1) - load(u.z + i), load(n.has_right + i));
    const Force force = {load(next.x + i) + (right.x - shift_in(to_right.x, right.x)),
                         load(next.z + i) + (right.z - shift_in(to_right.z, right.z))};
    to_right = right;
    use(i, force);
  }
}

void elastic(LatticeShape n, Springs c, ConstVectorView u, VectorView f, double* scratch) {
  const VectorView next = {scratch_row(n, scratch, 0), scratch_row(n, scratch, 1)};
  for (Index i = 0; i < n.stride; ++i) next.x[i] = next.z[i] = 0.0;
  for (Index row = 0; row < n.Nz * n.stride; row += n.stride) {
    const ConstVectorView u_row = {u.x + row, u.z + row};
    const auto keep = [&](Index i, const Force& force) {
      store(f.x + row + i, force.x);
      store(f.z + row + i, force.z);
    };
    if (row + n.stride < n.Nz * n.stride) {
      elastic_row(n, c, u_row, next, keep);
    } else {
      elastic_top_row(n, c, u_row, {next.x, next.z}, keep);
    }
  }
}

/// v[i-1] + v[i] + v[i+1]
Lanes sum_of_three(const double* v) {
  return (load(v - 1) + load(v + 1)) + load(v);
}

/// eta sum_j (v_j - v_i) over the 3 x 3 neighbourhood, from the sums of three along x of the rows
/// below, here and above. `blocks` is how many blocks the neighbourhood has, block i included.
Lanes damping_force(Lanes eta, Lanes blocks, Lanes below, Lanes here, Lanes above, Lanes v) {
  return eta * (((below + above) + here) - blocks * v);
}

/// Rows among j - 1, j, j + 1 that exist.
double rows_around(const LatticeShape& n, Index j) {
  return (j == 0 || j + 1 == n.Nz) ? 2.0 : 3.0;
}

void damping(LatticeShape n, double eta, ConstVectorView v, VectorView f) {
  const auto component = [&](const double* v_i, Lanes eta_i, Lanes blocks) {
    return damping_force(eta_i, blocks, sum_of_three(v_i - n.stride), sum_of_three(v_i),
                         sum_of_three(v_i + n.stride), load(v_i));
  };
  for (Index j = 0; j < n.Nz; ++j) {
    for (Index i = 0; i < n.stride; i += RUPTURE_LANES) {
      const Index b = j * n.stride + i;
      const Lanes eta_i = eta * load(n.inside + i);
      const Lanes blocks = rows_around(n, j) * load(n.columns + i);
      store(f.x + b, component(v.x + b, eta_i, blocks));
      store(f.z + b, component(v.z + b, eta_i, blocks));
    }
  }
}

/// The sum of eight lanes, in an order that no compiler may change.
double sum_of_lanes(const double* lane) {
  return ((lane[0] + lane[4]) + (lane[2] + lane[6])) + ((lane[1] + lane[5]) + (lane[3] + lane[7]));
}

/// Adds what the boundary does to row j to the forces that the row receives.
void add_boundary(const LatticeShape& n, const Boundary& boundary, Index j, VectorView received) {
  if (j == 0) {
    for (Index i = 0; i < n.Nx; ++i) received.x[i] -= boundary.tau[i];
    for (Index i = 0; i < n.Nx; ++i) received.z[i] += boundary.p[i];
  }
  if (j + 1 == n.Nz) {
    for (Index i = 0; i < n.Nx; ++i) received.z[i] -= boundary.load;
  }
  if (j == boundary.driving_row) received.x[0] += boundary.F_T;
}

/// Sums of three along x of v, of the row below and of the row at hand; both move up row by row.
/// They are taken before a row is kicked, because damping acts at the half-kicked velocities.
struct RowSums {
  VectorView below, here;
};

/// Steps 4 and 5 of the scheme in one sweep, row by row from the bottom: f = springs + damping +
/// boundary, v += (dt/2m) f.
double finish(LatticeShape n, Springs c, double eta, double half_kick, ConstVectorView u,
              const Boundary& boundary, VectorView f, VectorView v, double* scratch) {
  const VectorView next = {scratch_row(n, scratch, 0), scratch_row(n, scratch, 1)};
  const RowSums sums = {{scratch_row(n, scratch, 2), scratch_row(n, scratch, 3)},
                        {scratch_row(n, scratch, 4), scratch_row(n, scratch, 5)}};
  for (Index i = 0; i < n.stride; i += RUPTURE_LANES) {
    store(next.x + i, Lanes{});
    store(next.z + i, Lanes{});
    store(sums.below.x + i, Lanes{});
    store(sums.below.z + i, Lanes{});
    store(sums.here.x + i, sum_of_three(v.x + i));
    store(sums.here.z + i, sum_of_three(v.z + i));
  }
  double power[8] = {};
  for (Index j = 0; j < n.Nz; ++j) {
    const Index row = j * n.stride;
    const double rows = rows_around(n, j);
    const auto finish_blocks = [&](Index i, const Force& springs) {
      const Index b = row + i;
      const Lanes eta_i = eta * load(n.inside + i);
      const Lanes blocks = rows * load(n.columns + i);
      const Lanes vx = load(v.x + b), vz = load(v.z + b);
      const Lanes here_x = load(sums.here.x + i), here_z = load(sums.here.z + i);
      const Lanes above_x = sum_of_three(v.x + b + n.stride);
      const Lanes above_z = sum_of_three(v.z + b + n.stride);
      const Lanes damping_x =
          damping_force(eta_i, blocks, load(sums.below.x + i), here_x, above_x, vx);
      const Lanes damping_z =
          damping_force(eta_i, blocks, load(sums.below.z + i), here_z, above_z, vz);
      store(sums.below.x + i, here_x);
      store(sums.below.z + i, here_z);
      store(sums.here.x + i, above_x);
      store(sums.here.z + i, above_z);

      const Lanes fx = springs.x + damping_x, fz = springs.z + damping_z;
      const Lanes kicked_x = vx + half_kick * fx, kicked_z = vz + half_kick * fz;
      store(f.x + b, fx);
      store(f.z + b, fz);
      store(v.x + b, kicked_x);
      store(v.z + b, kicked_z);
      double* lane = power + i % 8;
      store(lane, load(lane) + (damping_x * kicked_x + damping_z * kicked_z));
    };
    add_boundary(n, boundary, j, next);
    if (j + 1 < n.Nz) {
      elastic_row(n, c, {u.x + row, u.z + row}, next, finish_blocks);
    } else {
      elastic_top_row(n, c, {u.x + row, u.z + row}, {next.x, next.z}, finish_blocks);
    }
  }
  return sum_of_lanes(power);
}

void contact(Index Nx, const double* u_z, double k_f, double N_s, double kappa, ContactView out) {
  double* p = out.p;
  double* k_ij = out.k_ij;
  double* w = out.w;
#pragma omp simd
  for (Index i = 0; i < Nx; ++i) {
    const double pressed = u_z[i] < 0.0 ? u_z[i] : 0.0;
    const double p_i = -(k_f * pressed);
    const double f_N = p_i / N_s;
    const double k = sqrt(kappa * f_N);
    p[i] = p_i;
    k_ij[i] = k;
    w[i] = p_i > 0.0 ? k / kappa : 0.0;  // f_N / k_ij, without dividing zero by zero
  }
}

double trail(Index N_s, double lower, double upper, const double* repin_time, double* attachment) {
  double lanes[8] = {};
  const Index whole = N_s - N_s % 8;
  const auto trailed = [&](Index j) {
    const double a = attachment[j];
    const double high = a > lower ? a : lower;
    const double clamped = high < upper ? high : upper;
    return repin_time[j] < kNever ? clamped : a;
  };
  for (Index first = 0; first < whole; first += 8) {
#pragma omp simd
    for (Index lane = 0; lane < 8; ++lane) {
      const double a = trailed(first + lane);
      attachment[first + lane] = a;
      lanes[lane] += a;
    }
  }
  for (Index j = whole; j < N_s; ++j) {
    attachment[j] = trailed(j);
    lanes[j - whole] += attachment[j];
  }
  return sum_of_lanes(lanes);
}

}  // namespace

extern const Kernels RUPTURE_JOIN(kernels_, RUPTURE_ISA);
const Kernels RUPTURE_JOIN(kernels_, RUPTURE_ISA) = {
    RUPTURE_STRING(RUPTURE_ISA), kick_drift, elastic, damping, finish, contact, trail};

}  // namespace rupture
