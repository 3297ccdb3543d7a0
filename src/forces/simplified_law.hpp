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

#include <algorithm>
#include <cmath>

#include "rupture/forces/interface_law.hpp"

namespace rupture {

class SimplifiedLaw final : public InterfaceLaw {
 public:
  SimplifiedLaw(const Parameters& p, Junctions& junctions) : parameters_(p), junctions_(junctions) {
    for (Eigen::Index i = 0; i < p.Nx; ++i) {
      pinned_.push_back(is_slipping(junctions.repin_time(i, 0)) ? 0 : 1);
    }
  }

  Changes update(const double* u_x, const double* v_x, const ContactView& contact,
                 double t) override {
    Changes changes;
    for (Eigen::Index i = 0; i < junctions_.attachment.rows(); ++i) {
      update_spring(i, u_x[i], v_x[i], contact.w[i], t, changes);
    }
    return changes;
  }

  void friction(const double* u_x, const ContactView& contact, double* tau) const override {
    const auto N_s = static_cast<double>(parameters_.N_s);
    for (Eigen::Index i = 0; i < junctions_.attachment.rows(); ++i) {
      tau[i] = N_s * contact.k_ij[i] * (u_x[i] - junctions_.attachment(i, 0));
    }
  }

  const std::vector<std::int32_t>& pinned() const override { return pinned_; }

  /// |tau| = mu_d p_i, and slow slip begins.
  void break_spring(Eigen::Index i, Eigen::Index j, double u, double w, double t) override {
    double& a = junctions_.attachment(i, j);
    const double direction = u > a ? 1.0 : -1.0;
    a = u - direction * parameters_.mu_d[i] * w;
    junctions_.slow_until(i, j) = direction * (t + parameters_.t_R[i]);
    junctions_.repin_time(i, j) = Junctions::unknown;
    pinned_[static_cast<std::size_t>(i)] = 0;
  }

 private:
  /// Stretches are compared with mu w, w = f_N / k_ij = p_i / k_i.
  void update_spring(Eigen::Index i, double u, double v, double w, double t, Changes& changes) {
    double& a = junctions_.attachment(i, 0);
    double& repin_time = junctions_.repin_time(i, 0);
    const double slow_until = junctions_.slow_until(i, 0);
    const double slip_stretch = parameters_.mu_d[i] * w;
    if (t < std::abs(slow_until)) {
      a += std::copysign(parameters_.v_slow[i] * parameters_.dt, slow_until);
    }
    if (!(w > 0.0)) a = u;
    if (is_slipping(repin_time)) {
      a = std::clamp(a, u - slip_stretch, u + slip_stretch);
      const bool moves_on = slow_until > 0.0 ? v > 0.0 : v < 0.0;
      if (!moves_on) {
        repin_time = Junctions::never;
        pinned_[static_cast<std::size_t>(i)] = 1;
        ++changes.repinned;
      }
    } else if (std::abs(u - a) > parameters_.mu_s[i] * w) {
      break_spring(i, 0, u, w, t);
      ++changes.broken;
    }
  }

  const Parameters parameters_;
  Junctions& junctions_;
  std::vector<std::int32_t> pinned_;
};

}  // namespace rupture
