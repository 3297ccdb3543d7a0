// The elastic slider: springs between neighbouring blocks and their damping.
#pragma once

#include <utility>

#include "rupture/forces/kernels.hpp"
#include "rupture/model/state.hpp"

namespace rupture {

class Bulk {
 public:
  /// Divides the rows into `bands` of nearly equal height, for as many threads; at most one band
  /// per row. Neither their number nor the instruction set of the kernels changes a bit of any
  /// result.
  explicit Bulk(const Parameters& parameters, int bands = 1);
  Bulk(const Bulk&) = delete;
  Bulk& operator=(const Bulk&) = delete;

  /// Spring forces at displacements u [N]; overwrites f.
  void elastic(const Field& u_x, const Field& u_z, Field& f_x, Field& f_z);

  /// Damping forces eta sum_j (v_j - v_i) over the up to 8 neighbours [N], or with the part of
  /// v_j - v_i along each spring; overwrites f.
  void damping(const State& state, Field& f_x, Field& f_z);

  // The bulk's part in a time step (dynamics/simulation.hpp), for one band each. Every band must
  // have kept the rows beside it before forces are added to one.
  int bands() const { return static_cast<int>(bands_.size()); }
  void half_kick_and_drift(int band, State& state) const;
  void keep_neighbouring_rows(int band, State& state) const;
  void add_forces_and_half_kick(int band, const Boundary& boundary, Then then, State& state);

  /// Power of the damping forces in the step that was finished last [W].
  double damping_power() const;
  /// Velocity v_x of the bottom row at the end of that step, shape [Nx] [m/s].
  const double* bottom_velocity() const { return bottom_velocity_.data(); }

  /// Energy stored in the springs, sum of 1/2 k_ij (r_ij - l_ij)^2 [J].
  double elastic_energy(const Field& u_x, const Field& u_z) const;

  /// Kinetic energy, sum of 1/2 m v^2 [J].
  double kinetic_energy(const Field& v_x, const Field& v_z) const;

 private:
  const Band& band(int index) const { return bands_[static_cast<std::size_t>(index)]; }
  Motion motion(State& state) const;

  const Kernels& kernels_;
  const Parameters parameters_;
  LatticeShape shape_;
  double mass_, half_kick_, dt_;
  AlignedVector rows_;  // what Springs and Dampers point to
  Springs springs_{};
  Dampers dampers_{};
  AlignedVector scratch_;
  std::vector<Band> bands_;
  AlignedVector damping_power_, bottom_velocity_;
};

/// Calls `use(i, j, ix, iz)` for each spring: from block (i, j) along the lattice vector (ix, iz).
void for_each_spring(const Parameters& p, const auto& use) {
  for (Eigen::Index j = 0; j < p.Nz; ++j) {
    for (Eigen::Index i = 0; i < p.Nx; ++i) {
      for (const auto& [ix, iz] : {std::pair(1, 0), {0, 1}, {1, 1}, {-1, 1}}) {
        if (i + ix >= 0 && i + ix < p.Nx && j + iz < p.Nz) use(i, j, ix, iz);
      }
    }
  }
}

inline VectorView view(Field& x, Field& z) {
  return {x.row(0), z.row(0)};
}
inline ConstVectorView view(const Field& x, const Field& z) {
  return {x.row(0), z.row(0)};
}

}  // namespace rupture
