// The loops that every time step runs, compiled once per instruction set and chosen at start.
//
// All variants give the same bits: they use + - * / and sqrt only, without contraction, and every
// sum has a fixed order. Arrays are rows of a Field (see field.hpp): padded, zero outside the
// lattice.
#pragma once

#include <cstddef>
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

struct LatticeShape {
  std::ptrdiff_t Nx, Nz, stride;  ///< blocks per row, rows, distance between rows
};

/// Stiffness of the springs that start in each block of one row, arrays of length `stride`; zero
/// where there is no block at the other end [N/m].
struct SpringRow {
  const double* k_right;
  const double* k_up;
  const double* k_diagonal;
};

/// Terms in the series of a spring's tension at small strain.
inline constexpr int kTensionTerms = 6;

/// The bulk springs.
struct Springs {
  double l;  ///< lattice spacing [m]
  // NOLINTNEXTLINE(*-avoid-c-arrays): std::array has functions, which the kernels may not use
  double series[kTensionTerms];  ///< c_n / l^(2n+2): the tension's series in powers of s l^2
  double small;                  ///< the series serves up to (s l^2)^2 = small [m^4]
  const double* small_right;     ///< the same, and infinite where there is no block to the right
  SpringRow bottom_row, row, top_row;  ///< of the bottom row, those between, and the top one
};

/// The dampers between blocks, arrays of length `stride`.
struct Dampers {
  const double* eta;      ///< damping coefficient, zero outside the lattice [N s/m]
  const double* columns;  ///< columns i-1, i, i+1 that exist: 2 at the sides, 3 between
  /// The coefficients of dampers that act along their springs, of all rows but the top one and of
  /// that; null if they act along the relative velocity.
  SpringRow row, top_row;
};

/// The normal contact of each interface block, for friction; arrays of length Nx.
struct ContactView {
  double* p;     ///< normal force p_i [N]
  double* k_ij;  ///< junction stiffness [N/m]
  double* w;     ///< f_N / k_ij, so that f_thres = k_ij (mu_s w) [m]
};

/// Forces from outside on the slider.
struct Boundary {
  const double* p;             ///< normal force on each bottom block, upwards [N]
  const double* tau;           ///< friction on each bottom block, towards -x [N]
  const double* top;           ///< force from above on each top block, downwards [N]
  std::ptrdiff_t driving_row;  ///< row whose leftmost block is driven
  double F_T;                  ///< driving force, towards +x [N]
};

/// Fields that change during a step.
struct Motion {
  VectorView u, v, f;  ///< displacement [m], velocity [m/s], net force [N]
  double half_kick;    ///< dt / 2m [s/kg]
  double dt;           ///< [s]
};

/// Rows first..last-1, which one thread works on, and its scratch space (Kernels::scratch_size).
struct Band {
  std::ptrdiff_t first, last;
  double* scratch;
};

/// Whether the first half of the next step follows the end of this one.
enum class Then { stop, go_on };

/// Results of a step besides the new state.
struct StepResult {
  double* damping_power;    ///< [Nz] power of the damping forces on each row [W]
  double* bottom_velocity;  ///< [stride] v_x of the bottom row at the end of the step [m/s]
};

struct Kernels {
  std::string_view name;

  /// What these kernels compute otherwise than they must; null if nothing.
  const char* (*inexactness)();

  /// Doubles of scratch space that a band needs, 64-byte aligned and zero at first.
  std::ptrdiff_t (*scratch_size)(const LatticeShape&);

  /// First half kick and drift: v += (dt/2m) f, then u += dt v.
  void (*kick_drift)(const LatticeShape&, const Motion&, const Band&);

  /// Forces of all bulk springs at displacements u; overwrites f. `band` has all rows.
  void (*elastic)(const LatticeShape&, const Springs&, ConstVectorView u, VectorView f,
                  const Band& band);

  /// Damping forces at displacements u and velocities v; overwrites f. `band` has all rows.
  void (*damping)(const LatticeShape&, const Springs&, const Dampers&, ConstVectorView u,
                  ConstVectorView v, VectorView f, const Band& band);

  /// Keeps what `finish` must know of the rows next to the band. To be called for all bands before
  /// `finish` is called for any.
  void (*prepare)(const LatticeShape&, const Springs&, const Dampers&, const Motion&, const Band&);

  /// The end of a step, row by row: f = springs + damping + boundary, second half kick v += (dt/2m)
  /// f, and, where the next step follows at once, its `kick_drift`; f is then not kept.
  void (*finish)(const LatticeShape&, const Springs&, const Dampers&, const Boundary&,
                 const Motion&, const Band&, Then, const StepResult&);

  /// p_i, k_ij and w of each block on a foundation, from its kappa (model/contact_formulas.hpp).
  void (*contact)(std::ptrdiff_t Nx, const double* u_z, double k_f, double N_s, const double* kappa,
                  ContactView out);

  /// Lets the slipping junctions of one block trail it: their attachment points are clamped to
  /// [lower, upper]. Returns the sum of all attachment points, in a fixed order of eight lanes.
  double (*trail)(std::ptrdiff_t N_s, double lower, double upper, const double* repin_time,
                  double* attachment);
};

/// Throws Failure if the library, or kernels that this processor can run, round otherwise than they
/// must, because of options of the compiler or linker.
void check_arithmetic();

/// The kernels for the widest instruction set of this processor, or for the one that the
/// environment variable RUPTURE_ISA names (sse2, avx2, avx512, neon, baseline). Throws UsageError
/// if that one is unknown or the processor lacks it, Failure as check_arithmetic() does.
const Kernels& kernels();

}  // namespace rupture
