// The simplified interface law (SI Methods, Fig. S2): one spring per block, and slow slip put in by
// hand. It shows that slow slip alone suffices for slow fronts, whatever its origin.
//
// Valid for any normal force p_i >= 0 and v_slow >= 0. The spring has the stiffness of all
// junctions together, k_i = N_s k_ij = N_s sqrt(kappa f_N) with f_N = p_i / N_s at the current p_i:
//   pinned:   tau = k_i (x_i - x_is); breaks when |tau| > tau_thres = mu_s p_i, then
//             |tau| = mu_d p_i with the same sign, which is also the sign of its sliding direction
//             d = +1 or -1;
//   slipping: x_is trails the block so that |tau| <= mu_d p_i; pinned where it is, still bearing
//             that force, in the first later step in which the block does not move along d;
//   both:     until t_R after the last break, x_is moves along d by v_slow dt per step; while
//             slipping only as far as |tau| <= mu_d p_i allows, so that it moves with the larger of
//             v_slow and the block's speed;
//   p_i = 0:  no friction; the attachment point follows the block.
// The block's velocity is the half-kicked one, (x_i - its last x_i) / dt. d is the direction of the
// break rather than the sign of an earlier velocity, so that the state holds no velocity of a past
// step; a block that moves against d when its spring breaks (because p_i falls) is pinned at once.
// The slow slip lasts for the mean slipping time t_R; nothing is drawn. Its end and d are stored as
// one number, d (time of the break + t_R).
#pragma once

#include <vector>

#include "rupture/forces/interface_law.hpp"

namespace rupture {

class SimplifiedLaw final : public InterfaceLaw {
 public:
  /// Works on `junctions`, which must outlive the law.
  SimplifiedLaw(const Parameters& parameters, Junctions& junctions);

  Changes update(const double* u_x, const double* v_x, const ContactView& contact,
                 double t) override;
  void friction(const double* u_x, const ContactView& contact, double* tau) const override;
  const std::vector<std::int32_t>& pinned() const override { return pinned_; }

  /// As break_by_law(): |tau| = mu_d p_i, and slow slip begins.
  static void break_spring(const Parameters& parameters, Junctions& junctions, Eigen::Index i,
                           Eigen::Index j, double u_x, double w, double t);

 private:
  void update_spring(Eigen::Index i, double u, double v, double w, double t, Changes& changes);

  const Parameters parameters_;
  Junctions& junctions_;
  std::vector<std::int32_t> pinned_;
};

}  // namespace rupture
