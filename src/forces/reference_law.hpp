// The reference interface law: junctions that are pinned, break, slip and are pinned again
// (Methods).
//
// Breaking and the loop as in junction_law.hpp, which has its own parts as well:
//   slipping: |f| <= f_slip = mu_d f_N for a slipping time t_R, which is drawn at the break;
//   then      pinned with f_new = 0 (x_ij = x_i), or where it is when f_new = f_slip.
#pragma once

#include "junction_law.hpp"

namespace rupture {

struct ReferenceLaw final : JunctionLaw<ReferenceLaw> {
  using JunctionLaw::JunctionLaw;
};

}  // namespace rupture
