// The reference interface law: junctions that are pinned, break, slip and are pinned again
// (Methods).
//
// Valid for any normal force p_i >= 0. With f_N = p_i / N_s at the current p_i, k_ij = sqrt(kappa
// f_N):
//   pinned:   f = k_ij (x_i - x_ij); breaks when |f| > f_thres = mu_s f_N, then |f| = f_slip with
//   the
//             same sign, and a slipping time t_R is drawn;
//   slipping: x_ij trails the block so that |f| <= f_slip = mu_d f_N; after t_R pinned again with
//             f_new = 0 (x_ij = x_i), or where it is when f_new = f_slip;
//   p_i = 0:  no friction; attachment points follow the block.
// All comparisons are made on stretches x_i - x_ij against mu w, where w = f_N / k_ij.
#pragma once

#include <cstdint>
#include <vector>

#include "rupture/forces/kernels.hpp"
#include "rupture/model/state.hpp"

namespace rupture {

/// Breaks junction j of block i at u_x [m] and time t [s]: it slips with |f| = f_slip in the
/// direction of its force, for a slipping time that is drawn. `w` as in ContactView.
void break_junction(const Parameters& parameters, Junctions& junctions, Eigen::Index i,
                    Eigen::Index j, double u_x, double w, double t);

class ReferenceLaw {
 public:
  /// Works on `junctions`, which must outlive the law.
  ReferenceLaw(const Parameters& parameters, Junctions& junctions);

  /// Moves every junction to time `t` [s] with the interface blocks at u_x [m] under the given
  /// contact. Returns how many junctions broke or were pinned again.
  struct Changes {
    std::int64_t broken = 0;
    std::int64_t repinned = 0;
  };
  Changes update(const double* u_x, const ContactView& contact, double t);

  /// Friction force on each block, tau_i = sum_j k_ij (x_i - x_ij), positive towards -x [N].
  void friction(const double* u_x, const ContactView& contact, double* tau) const;

  /// Number of pinned junctions of each block.
  const std::vector<std::int32_t>& pinned() const { return pinned_; }

 private:
  bool is_quiet(Eigen::Index i, double u, double w, double t) const;
  void update_junctions(Eigen::Index i, double u, double w, double t, Changes& changes);
  void refresh(Eigen::Index i);

  const Parameters parameters_;
  Junctions& junctions_;
  // What the arrays above say of each block, kept so that untouched blocks cost nothing.
  std::vector<double> sum_;               // of all attachment points [m]
  std::vector<double> lowest_, highest_;  // attachment points of pinned junctions [m]
  std::vector<double> next_repin_;        // earliest repin time [s]
  std::vector<std::int32_t> pinned_;
};

}  // namespace rupture
