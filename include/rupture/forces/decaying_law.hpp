// The decaying interface law (Fig. S6): the reference law, but for a slipping force that falls with
// time. It stands for another behaviour of single junctions, to show that results do not hinge on
// the reference one.
//
// Valid for any normal force p_i >= 0 and mu_new <= mu_d. Pinned, breaking and without contact as
// in reference_law.hpp. With t_s the time since the junction broke:
//   slipping: x_ij trails the block so that |f| <= f_slip(t_s),
//             f_slip = f_slip^0 - (f_slip^0 - f_new) t_s / t_R,  f_slip^0 = mu_d f_N,
//             f_new = mu_new f_N, all at the current f_N;
//             after t_R pinned where it is, carrying f_new (less if the block has reversed).
// The decay is computed from the time that is left, t_R - t_s = repin_time - t, and the t_R that
// the junction drew last, which is a function of its number of draws: so the state needs no more
// than that of the reference law. (A restart that changes t_R takes the new one at once for this
// decay, within mu_d and mu_new, and leaves the repin time as it is.)
// With mu_new = mu_d nothing decays: the reference law with f_new = f_slip, slow slip off.
#pragma once

#include <vector>

#include "rupture/forces/block_summary.hpp"
#include "rupture/forces/interface_law.hpp"

namespace rupture {

class DecayingLaw final : public InterfaceLaw {
 public:
  /// Works on `junctions`, which must outlive the law.
  DecayingLaw(const Parameters& parameters, Junctions& junctions);

  Changes update(const double* u_x, const double* v_x, const ContactView& contact,
                 double t) override;
  void friction(const double* u_x, const ContactView& contact, double* tau) const override {
    blocks_.friction(u_x, contact, tau);
  }
  const std::vector<std::int32_t>& pinned() const override { return blocks_.pinned(); }

 private:
  double drawn_time(Eigen::Index i, Eigen::Index j) const;
  double decay_rate(double t_R) const;
  double slipping_coefficient(Eigen::Index i, Eigen::Index j, double t) const;
  void trail(Eigen::Index i, double u, double w, double t);
  void update_junctions(Eigen::Index i, double u, double w, double t, Changes& changes);

  const Parameters parameters_;
  Junctions& junctions_;
  BlockSummary blocks_;
  JunctionArray<double> rate_;  // (mu_d - mu_new) / t_R of the last draw [1/s]
};

}  // namespace rupture
