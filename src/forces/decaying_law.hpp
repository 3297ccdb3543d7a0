// The decaying interface law (Fig. S6): the reference law, but for a slipping force that falls with
// time. It is an example of another behaviour of single junctions, to show that results do not
// depend on the reference one.
//
// Breaking and the loop as in junction_law.hpp; valid for mu_new <= mu_d. Its own, with t_s the
// time since the junction broke:
//   slipping: |f| <= f_slip(t_s) = f_slip^0 - (f_slip^0 - f_new) t_s / t_R,  f_slip^0 = mu_d f_N,
//             f_new = mu_new f_N, all at the current f_N, for a slipping time t_R that is drawn;
//   then      pinned where it is, carrying f_new (less if the block has reversed); with
//             junctions.repin = exact so that it carries f_new in any case, with the sign of the
//             force that it has.
// The decay is computed from the time that is left, t_R - t_s = repin_time - t, and the t_R that
// the junction drew last, which is a function of its number of draws: so the state needs no more
// than that of the reference law. (A restart that changes t_R takes the new one at once for this
// decay, within mu_d and mu_new, and leaves the repin time as it is.)
// With mu_new = mu_d nothing decays: the reference law with f_new = f_slip, slow slip off.
#pragma once

#include "junction_law.hpp"

namespace rupture {

class DecayingLaw final : public JunctionLaw<DecayingLaw> {
 public:
  DecayingLaw(const Parameters& p, Junctions& junctions) : JunctionLaw(p, junctions) {
    rate_.setZero(junctions.attachment.rows(), junctions.attachment.cols());
    for (Eigen::Index i = 0; i < rate_.rows(); ++i) {
      for (Eigen::Index j = 0; j < rate_.cols(); ++j) {
        if (is_slipping(junctions.repin_time(i, j))) find_rate(i, j);
      }
    }
  }

  void start_slipping(Eigen::Index i, Eigen::Index j, double t) override {
    JunctionLaw::start_slipping(i, j, t);
    find_rate(i, j);
  }

 private:
  friend JunctionLaw;

  /// Finds the rate of decay from the slipping time that junction j of block i drew last.
  void find_rate(Eigen::Index i, Eigen::Index j) {
    const std::uint32_t draws = junctions_.draws(i, j);
    const double t_R = slipping_time(parameters_, static_cast<std::uint32_t>(i),
                                     static_cast<std::uint32_t>(j), draws > 0 ? draws - 1 : 0);
    rate_(i, j) = t_R > 0.0 ? (parameters_.mu_d[i] - parameters_.mu_new[i]) / t_R : 0.0;
  }
  /// f_slip(t_s) / k_ij.
  double slip_stretch(Eigen::Index i, Eigen::Index j, double w, double t) const {
    const double time_left = junctions_.repin_time(i, j) - t;
    return w * std::clamp(parameters_.mu_new[i] + rate_(i, j) * time_left, parameters_.mu_new[i],
                          parameters_.mu_d[i]);
  }
  void pin(Eigen::Index i, Eigen::Index j, double u, double w) {
    double& a = junctions_.attachment(i, j);
    if (parameters_.repin == Repin::as_is || a == u) return;
    a = u - std::copysign(parameters_.mu_new[i] * w, u - a);
  }
  void trail(Eigen::Index i, double u, double w, double t) {
    for (Eigen::Index j = 0; j < junctions_.attachment.cols(); ++j) {
      if (!is_slipping(junctions_.repin_time(i, j))) continue;
      const double stretch = slip_stretch(i, j, w, t);
      double& a = junctions_.attachment(i, j);
      a = std::clamp(a, u - stretch, u + stretch);
    }
    blocks_.recompute_sum(i);
  }

  RowMajorArray<double> rate_;  // (mu_d - mu_new) / t_R of the last draw [1/s]
};

}  // namespace rupture
