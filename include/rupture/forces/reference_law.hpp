// The reference interface law: junctions that are pinned, break, slip and are pinned again
// (Methods).
//
// Valid for any normal force p_i >= 0. With f_N = p_i / N_s at the current p_i, k_ij = sqrt(kappa
// f_N):
//   pinned:   f = k_ij (x_i - x_ij); breaks when |f| > f_thres = mu_s f_N, then |f| = f_slip with
//             the same sign, and a slipping time t_R is drawn;
//   slipping: x_ij trails the block so that |f| <= f_slip = mu_d f_N; after t_R pinned again with
//             f_new = 0 (x_ij = x_i), or where it is when f_new = f_slip;
//   p_i = 0:  no friction; attachment points follow the block.
// All comparisons are made on stretches x_i - x_ij against mu w, where w = f_N / k_ij.
#pragma once

#include <vector>

#include "rupture/forces/block_summary.hpp"
#include "rupture/forces/interface_law.hpp"

namespace rupture {

/// Breaks junction j of block i at u_x [m] and time t [s]: it slips with |f| = f_slip in the
/// direction of its force, for a slipping time that is drawn. `w` as in ContactView.
void break_junction(const Parameters& parameters, Junctions& junctions, Eigen::Index i,
                    Eigen::Index j, double u_x, double w, double t);

class ReferenceLaw final : public InterfaceLaw {
 public:
  /// Works on `junctions`, which must outlive the law.
  ReferenceLaw(const Parameters& parameters, Junctions& junctions);

  Changes update(const double* u_x, const double* v_x, const ContactView& contact,
                 double t) override;
  void friction(const double* u_x, const ContactView& contact, double* tau) const override {
    blocks_.friction(u_x, contact, tau);
  }
  const std::vector<std::int32_t>& pinned() const override { return blocks_.pinned(); }

 private:
  void update_junctions(Eigen::Index i, double u, double w, double t, Changes& changes);

  const Parameters parameters_;
  Junctions& junctions_;
  BlockSummary blocks_;
};

}  // namespace rupture
