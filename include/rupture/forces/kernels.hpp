// The loops that every time step runs, compiled once per instruction set and chosen at start.
//
// All variants give the same bits: they use + - * / and sqrt only, without contraction, and every
// sum has a fixed order. Arrays are rows of a Field (see field.hpp): padded, zero outside the
// lattice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rupture {

/// A vector field on the lattice; pointers to block (0, 0) of each component.
struct VectorView {
  double* x;
  double* z;
};
struct ConstVectorView {
  const double* x;
  const double* z;
};

/// Size of the lattice, and rows of length `stride` that tell which columns exist.
struct LatticeShape {
  std::ptrdiff_t Nx, Nz, stride;
  const double* has_right;  ///< 1 where block i has a right neighbour, else 0
  const double* inside;     ///< 1 for i < Nx, else 0
  const double* columns;    ///< columns i-1, i, i+1 that exist: 2 at the sides, 3 between
};

/// Constants of the bulk springs: spacing l [m] and nearest-neighbour stiffness k [N/m].
struct Springs {
  double l, k;
};

/// What friction needs to know of each interface block, arrays of length Nx.
struct ContactView {
  double* p;     ///< normal force p_i [N]
  double* k_ij;  ///< junction stiffness [N/m]
  double* w;     ///< f_N / k_ij, so that f_thres = k_ij (mu_s w) [m]
};

/// Rows of scratch that `elastic` and `finish` need, each of length stride + 8.
inline constexpr std::ptrdiff_t kScratchRows = 6;

/// Forces from outside on the slider.
struct Boundary {
  const double* p;             ///< normal force on each bottom block, upwards [N]
  const double* tau;           ///< friction on each bottom block, towards -x [N]
  double load;                 ///< normal load on each top block, downwards [N]
  std::ptrdiff_t driving_row;  ///< row whose leftmost block is driven
  double F_T;                  ///< driving force, towards +x [N]
};

struct Kernels {
  std::string_view name;

  /// First half kick and drift: v += (dt/2m) f, then u += dt v.
  void (*kick_drift)(LatticeShape, double half_kick, double dt, ConstVectorView f, VectorView v,
                     VectorView u);

  /// Forces of all bulk springs at displacements u; overwrites f. `scratch`: see kScratchRows.
  void (*elastic)(LatticeShape, Springs, ConstVectorView u, VectorView f, double* scratch);

  /// Damping forces eta * sum over the 8 neighbours of (v_j - v_i); overwrites f.
  void (*damping)(LatticeShape, double eta, ConstVectorView v, VectorView f);

  /// The end of a step in one sweep over the rows: f = springs + damping + boundary, then the
  /// second half kick v += (dt/2m) f. Returns the power of the damping forces, sum of damping . v
  /// [W].
  double (*finish)(LatticeShape, Springs, double eta, double half_kick, ConstVectorView u,
                   const Boundary& boundary, VectorView f, VectorView v, double* scratch);

  /// p_i = -k_f u_z where u_z < 0, else 0; k_ij = sqrt(kappa f_N); w = f_N / k_ij; f_N = p_i / N_s.
  void (*contact)(std::ptrdiff_t Nx, const double* u_z, double k_f, double N_s, double kappa,
                  ContactView out);

  /// Lets the slipping junctions of one block trail it: their attachment points are clamped to
  /// [lower, upper]. Returns the sum of all attachment points, in a fixed order of eight lanes.
  double (*trail)(std::ptrdiff_t N_s, double lower, double upper, const double* repin_time,
                  double* attachment);
};

/// The kernels for the widest instruction set of this processor, or for the one that the
/// environment variable RUPTURE_ISA names (sse2, avx2, avx512, baseline). Throws UsageError if that
/// one is unknown or the processor lacks it.
const Kernels& kernels();

/// The variant called `name`; null if this build does not hold it or this processor cannot run it.
const Kernels* find_kernels(std::string_view name);

}  // namespace rupture
