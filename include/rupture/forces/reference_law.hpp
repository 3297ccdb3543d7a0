// The reference interface law: junctions that are pinned, break, slip and are pinned again
// (Methods).
//
// Breaking and the loop as in junction_law.hpp. Its own:
//   slipping: |f| <= f_slip = mu_d f_N for a slipping time t_R, which is drawn at the break;
//   then      pinned with f_new = 0 (x_ij = x_i), or where it is when f_new = f_slip.
#pragma once

#include "rupture/forces/junction_law.hpp"

namespace rupture {

class ReferenceLaw final : public JunctionLaw<ReferenceLaw> {
 public:
  /// Works on `junctions`, which must outlive the law.
  ReferenceLaw(const Parameters& parameters, Junctions& junctions);

  /// Junction j of block i slips from time t [s] on, until t_R later, which is drawn.
  static void start_slipping(const Parameters& parameters, Junctions& junctions, Eigen::Index i,
                             Eigen::Index j, double t);
};

extern template class JunctionLaw<ReferenceLaw>;

}  // namespace rupture
