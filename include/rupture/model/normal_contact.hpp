// The forces that press on a slider in z: of its support on one side, F_N on the other. Nothing
// else needs to know which of them is below.
//
//   slider.support   bottom blocks            top blocks                presses where
//   foundation       -k_f u_z, never pulls    column_load()             u_z < 0 at the bottom
//   ceiling          column_load()            k_f u_z, never pulls      u_z > 0 at the top
#pragma once

#include "rupture/model/parameters.hpp"

namespace rupture {

/// Whether every bottom block bears its part of F_N, wherever it is: that of prepared interfaces.
inline bool has_constant_p(const Parameters& p) {
  return p.support == Support::ceiling;
}

/// The contact of one column of blocks.
class NormalContact {
 public:
  NormalContact(const Parameters& p, std::int64_t i);

  /// Normal force p_i on a bottom block at u_z, upwards [N].
  double normal_force(double u_z) const;
  /// Force from above on a top block at u_z, downwards [N].
  double top_force(double u_z) const;

  /// Derivative dp_i/du_z of the force on a bottom block, and that of the force on a top block; 0
  /// where it does not depend on u_z or there is no contact [N/m].
  double normal_force_slope(double u_z) const;
  double top_force_slope(double u_z) const;

  /// How far a column with its lowest block at `bottom` and its highest at `top` (their u_z) is
  /// pressed into the support; negative where it does not touch [m].
  double compression(double bottom, double top) const;
  /// Energy of the support under that column, 1/2 k_f u_z^2 where it is pressed [J].
  double contact_energy(double bottom, double top) const;
  /// Potential of the load on that column [J].
  double load_energy(double bottom, double top) const;

  /// u_z at height z [m] under uniaxial compression, at rest between F_N and the support [m].
  double compressed_u_z(double z) const;

 private:
  Support support_;
  double k_f_;     // [N/m]
  double load_;    // column_load() [N]
  double strain_;  // F_N / (L B E)
  double H_;       // [m]
};

}  // namespace rupture
