// The decaying interface law (Fig. S6): the reference law, but for a slipping force that falls with
// time. It stands for another behaviour of single junctions, to show that results do not hinge on
// the reference one.
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

#include "rupture/forces/junction_law.hpp"
#include "rupture/forces/reference_law.hpp"

namespace rupture {

class DecayingLaw final : public JunctionLaw<DecayingLaw> {
 public:
  /// Works on `junctions`, which must outlive the law.
  DecayingLaw(const Parameters& parameters, Junctions& junctions);

  /// As under the reference law.
  static void start_slipping(const Parameters& parameters, Junctions& junctions, Eigen::Index i,
                             Eigen::Index j, double t) {
    ReferenceLaw::start_slipping(parameters, junctions, i, j, t);
  }

 private:
  friend JunctionLaw;
  void pin(Eigen::Index i, Eigen::Index j, double u, double w) {
    double& a = junctions_.attachment(i, j);
    if (parameters_.repin == Repin::as_is || a == u) return;
    a = u - std::copysign(parameters_.mu_new * w, u - a);
  }
  double slip_stretch(Eigen::Index i, Eigen::Index j, double w, double t) const;
  void has_broken(Eigen::Index i, Eigen::Index j);
  void trail(Eigen::Index i, double u, double w, double t);

  JunctionArray<double> rate_;  // (mu_d - mu_new) / t_R of the last draw [1/s]
};

extern template class JunctionLaw<DecayingLaw>;

}  // namespace rupture
