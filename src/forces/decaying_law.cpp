#include "rupture/forces/decaying_law.hpp"

#include <algorithm>
#include <cmath>

#include "rupture/model/random.hpp"

namespace rupture {

DecayingLaw::DecayingLaw(const Parameters& p, Junctions& junctions)
    : parameters_(p), junctions_(junctions), blocks_(p, junctions) {
  rate_.setZero(junctions.attachment.rows(), junctions.attachment.cols());
  for (Eigen::Index i = 0; i < rate_.rows(); ++i) {
    for (Eigen::Index j = 0; j < rate_.cols(); ++j) {
      if (is_slipping(junctions.repin_time(i, j))) rate_(i, j) = decay_rate(drawn_time(i, j));
    }
  }
}

InterfaceLaw::Changes DecayingLaw::update(const double* u_x, const double* /*v_x*/,
                                          const ContactView& contact, double t) {
  Changes changes;
  for (Eigen::Index i = 0; i < junctions_.attachment.rows(); ++i) {
    const double u = u_x[i], w = contact.w[i];
    if (!blocks_.is_quiet(i, u, w, t)) {
      update_junctions(i, u, w, t, changes);
      blocks_.refresh(i);
    } else if (blocks_.is_slipping_anywhere(i)) {
      trail(i, u, w, t);
      blocks_.recompute_sum(i);
    }
  }
  return changes;
}

/// The slipping time that junction j of block i drew last [s].
double DecayingLaw::drawn_time(Eigen::Index i, Eigen::Index j) const {
  const std::uint32_t draws = junctions_.draws(i, j);
  return slipping_time(parameters_, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j),
                       draws > 0 ? draws - 1 : 0);
}

double DecayingLaw::decay_rate(double t_R) const {
  return t_R > 0.0 ? (parameters_.mu_d - parameters_.mu_new) / t_R : 0.0;
}

/// f_slip(t_s) / f_N.
double DecayingLaw::slipping_coefficient(Eigen::Index i, Eigen::Index j, double t) const {
  const double time_left = junctions_.repin_time(i, j) - t;
  return std::clamp(parameters_.mu_new + rate_(i, j) * time_left, parameters_.mu_new,
                    parameters_.mu_d);
}

void DecayingLaw::trail(Eigen::Index i, double u, double w, double t) {
  for (Eigen::Index j = 0; j < junctions_.attachment.cols(); ++j) {
    if (!is_slipping(junctions_.repin_time(i, j))) continue;
    const double stretch = slipping_coefficient(i, j, t) * w;
    double& a = junctions_.attachment(i, j);
    a = std::clamp(a, u - stretch, u + stretch);
  }
}

void DecayingLaw::update_junctions(Eigen::Index i, double u, double w, double t, Changes& changes) {
  if (!(w > 0.0)) junctions_.attachment.row(i) = u;
  trail(i, u, w, t);
  for (Eigen::Index j = 0; j < junctions_.attachment.cols(); ++j) {
    double& a = junctions_.attachment(i, j);
    double& repin_time = junctions_.repin_time(i, j);
    if (is_slipping(repin_time)) {
      if (t < repin_time) continue;
      repin_time = Junctions::never;
      ++changes.repinned;
    } else if (std::abs(u - a) > parameters_.mu_s * w) {
      const double stretch = parameters_.mu_d * w;
      a = u > a ? u - stretch : u + stretch;
      ++junctions_.draws(i, j);
      const double t_R = drawn_time(i, j);
      rate_(i, j) = decay_rate(t_R);
      repin_time = t + t_R;
      ++changes.broken;
    }
  }
}

}  // namespace rupture
