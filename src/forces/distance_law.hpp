// The distance law (not of the paper, which contrasts "time- rather than distance-controlled
// relaxations"): the reference law, but a junction slips for a distance instead of a time. At rest
// nothing relaxes; the law has no time of its own.
//
// Breaking and the loop as in junction_law.hpp. Its own:
//   slipping: |f| <= f_slip = mu_d f_N until x_ij has moved by d_R over the track, forwards and
//             backwards alike, with d_R from a folded Gaussian, drawn at the break;
//   then      pinned with f_new = 0 (x_ij = x_i), or where it is when f_new = f_slip.
// Without contact x_ij follows the block, but does not slide.
#pragma once

#include <limits>

#include "junction_law.hpp"

namespace rupture {

class DistanceLaw final : public JunctionLaw<DistanceLaw> {
 public:
  using JunctionLaw::JunctionLaw;

  void start_slipping(Eigen::Index i, Eigen::Index j, double /*t*/) override {
    const Parameters& p = parameters_;
    const double d_R =
        folded_gaussian(p.d_R[i], p.delta_d_R[i], p.seed, static_cast<std::uint32_t>(i),
                        static_cast<std::uint32_t>(j), junctions_.draws(i, j)++);
    junctions_.slip_left(i, j) = std::max(d_R, std::numeric_limits<double>::min());  // 0: pinned
    junctions_.repin_time(i, j) = Junctions::unknown;
  }

 private:
  friend JunctionLaw;
  bool is_over(Eigen::Index i, Eigen::Index j, double slid, double /*t*/) {
    return (junctions_.slip_left(i, j) -= slid) <= 0.0;
  }
  void pin(Eigen::Index i, Eigen::Index j, double u, double w) {
    junctions_.slip_left(i, j) = 0.0;
    JunctionLaw::pin(i, j, u, w);
  }
};

}  // namespace rupture
