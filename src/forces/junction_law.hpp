// The common part of all interface laws with N_s junctions per block: the loop over the junctions.
//
// Valid for any normal force p_i >= 0. With f_N = p_i / N_s at the current p_i and k_ij =
// sqrt(kappa f_N), a junction carries f = k_ij (x_i - x_ij):
//   pinned:   x_ij is fixed; breaks when |f| > f_thres = mu_s f_N, then |f| = mu_d f_N with its
//             sign;
//   slipping: x_ij trails the block so that |f| does not exceed the slipping force, until the law
//             pins the junction again;
//   p_i = 0:  no friction; attachment points follow the block. With junctions.without_contact =
//             break, its pinned junctions break; one that the law pins before the block is pressed
//             again breaks anew.
// All comparisons are made on stretches x_i - x_ij against mu w, where w = f_N / k_ij.
// A law has a file of its own, with what is its own: slipping force, end of slipping, force of the
// newly pinned junction.
#pragma once

#include <cmath>

#include "block_summary.hpp"
#include "rupture/forces/interface_law.hpp"
#include "rupture/model/random.hpp"

namespace rupture {

/// The law `Own`, which derives from this. Its own, unless those of the reference law, which stand
/// here, will do, are start_slipping(), slip_stretch(), is_over(), pin() and trail().
template <class Own>
class JunctionLaw : public InterfaceLaw {
 public:
  Changes update(const double* u_x, const double* /*v_x*/, const ContactView& contact,
                 double t) final {
    Changes changes;
    for (Eigen::Index i = 0; i < junctions_.attachment.rows(); ++i) {
      const double u = u_x[i], w = contact.w[i];
      if (!blocks_.is_quiet(i, u, w, t)) {
        update_block(i, u, w, t, changes);
        blocks_.refresh(i);
      } else if (blocks_.is_slipping_anywhere(i)) {
        own().trail(i, u, w, t);
      }
    }
    return changes;
  }

  void friction(const double* u_x, const ContactView& contact, double* tau) const final {
    blocks_.friction(u_x, contact, tau);
  }
  const std::vector<std::int32_t>& pinned() const final { return blocks_.pinned(); }

  void break_spring(Eigen::Index i, Eigen::Index j, double u, double w, double t) final {
    const double stretch = parameters_.mu_d[i] * w;
    double& a = junctions_.attachment(i, j);
    a = u > a ? u - stretch : u + stretch;
    start_slipping(i, j, t);
  }
  /// For a time that is drawn.
  void start_slipping(Eigen::Index i, Eigen::Index j, double t) override {
    const std::uint32_t n = junctions_.draws(i, j)++;
    junctions_.repin_time(i, j) = t + slipping_time(parameters_, static_cast<std::uint32_t>(i),
                                                    static_cast<std::uint32_t>(j), n);
  }

  /// Works on `junctions`, which must outlive the law.
  JunctionLaw(const Parameters& p, Junctions& junctions)
      : parameters_(p), junctions_(junctions), blocks_(p, junctions) {}

 protected:
  /// Slipping force / k_ij of a junction at time t [m].
  double slip_stretch(Eigen::Index i, Eigen::Index /*j*/, double w, double /*t*/) const {
    return parameters_.mu_d[i] * w;
  }
  /// Whether a junction is pinned again at time t, after sliding by another `slid` [m].
  bool is_over(Eigen::Index i, Eigen::Index j, double /*slid*/, double t) const {
    return t >= junctions_.repin_time(i, j);
  }
  /// Makes of it a pinned one, with the block at u [m] and w as in ContactView.
  void pin(Eigen::Index i, Eigen::Index j, double u, double /*w*/) {
    if (parameters_.f_new[i] == NewForce::zero) junctions_.attachment(i, j) = u;
  }
  /// Lets the slipping junctions of a block trail in which nothing breaks or is pinned.
  void trail(Eigen::Index i, double u, double w, double /*t*/) {
    const double stretch = parameters_.mu_d[i] * w;
    blocks_.trail(i, u - stretch, u + stretch);
  }

  const Parameters parameters_;
  const bool breaks_without_contact_ = parameters_.without_contact == WithoutContact::break_all;
  Junctions& junctions_;
  BlockSummary blocks_;

 private:
  Own& own() { return static_cast<Own&>(*this); }

  void update_block(Eigen::Index i, double u, double w, double t, Changes& changes) {
    const double f_thres_stretch = parameters_.mu_s[i] * w;
    const bool contact = w > 0.0;
    for (Eigen::Index j = 0; j < junctions_.attachment.cols(); ++j) {
      double& a = junctions_.attachment(i, j);
      if (!contact) a = u;
      if (is_slipping(junctions_.repin_time(i, j))) {
        const double before = a, stretch = own().slip_stretch(i, j, w, t);
        a = std::clamp(a, u - stretch, u + stretch);
        if (!own().is_over(i, j, std::abs(a - before), t)) continue;
        junctions_.repin_time(i, j) = Junctions::never;
        own().pin(i, j, u, w);
        ++changes.repinned;
      } else if (std::abs(u - a) > f_thres_stretch || (!contact && breaks_without_contact_)) {
        break_spring(i, j, u, w, t);
        ++changes.broken;
      }
    }
  }
};

}  // namespace rupture
