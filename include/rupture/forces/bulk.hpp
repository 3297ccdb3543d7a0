// The elastic slider: springs between neighbouring blocks and their damping (physics: "Slider").
#pragma once

#include "rupture/forces/kernels.hpp"
#include "rupture/model/state.hpp"

namespace rupture {

class Bulk {
 public:
  explicit Bulk(const Parameters& parameters);

  /// Spring forces at displacements u [N]; overwrites f.
  void elastic(const Field& u_x, const Field& u_z, Field& f_x, Field& f_z);

  /// Damping forces eta sum_j (v_j - v_i) over the up to 8 neighbours [N]; overwrites f.
  void damping(const Field& v_x, const Field& v_z, Field& f_x, Field& f_z);

  /// The end of a step: f = springs + damping + boundary, v += half_kick f, with half_kick = dt/2m.
  /// Returns the power of the damping forces [W].
  double finish(double half_kick, const Boundary& boundary, State& state);

  /// Energy stored in the springs, sum of 1/2 k_ij (r_ij - l_ij)^2 [J].
  double elastic_energy(const Field& u_x, const Field& u_z) const;

  /// Kinetic energy, sum of 1/2 m v^2 [J].
  double kinetic_energy(const Field& v_x, const Field& v_z) const;

  const LatticeShape& shape() const { return shape_; }

 private:
  Springs springs_;
  double eta_, mass_;
  AlignedVector rows_;  // has_right, inside, columns
  AlignedVector scratch_;
  LatticeShape shape_;
};

inline VectorView view(Field& x, Field& z) {
  return {x.row(0), z.row(0)};
}
inline ConstVectorView view(const Field& x, const Field& z) {
  return {x.row(0), z.row(0)};
}

}  // namespace rupture
