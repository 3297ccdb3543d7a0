// The normal contact of one interface block, written once for the kernels' loop and for everything
// else. Internal linkage: each instruction set keeps a copy of its own (forces/kernels/isa.cpp).
#pragma once

#include <math.h>  // NOLINT(modernize-deprecated-headers): the kernels may not use <cmath>

namespace rupture {

/// Normal force p_i = -k_f u_z where u_z < 0, else 0, of a foundation on a block, upwards [N].
static inline double foundation_force(double k_f, double u_z) {
  const double pressed = u_z < 0.0 ? u_z : 0.0;
  return -(k_f * pressed);
}

/// k_ij = sqrt(kappa f_N) of N_s junctions that bear p_i = N_s f_N [N/m].
static inline double junction_stiffness(double kappa, double N_s, double p_i) {
  return sqrt(kappa * (p_i / N_s));
}

/// w = f_N / k_ij = k_ij / kappa, so that f_thres = k_ij (mu_s w); 0 without contact [m].
static inline double friction_stretch(double kappa, double k_ij, double p_i) {
  return p_i > 0.0 ? k_ij / kappa : 0.0;
}

}  // namespace rupture
