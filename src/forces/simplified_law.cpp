#include "rupture/forces/simplified_law.hpp"

#include <algorithm>
#include <cmath>

namespace rupture {

void SimplifiedLaw::break_spring(const Parameters& p, Junctions& junctions, Eigen::Index i,
                                 Eigen::Index j, double u, double w, double t) {
  double& a = junctions.attachment(i, j);
  const double direction = u > a ? 1.0 : -1.0;
  a = u - direction * p.mu_d * w;
  junctions.slow_until(i, j) = direction * (t + p.t_R);
  junctions.repin_time(i, j) = Junctions::unknown;
}

SimplifiedLaw::SimplifiedLaw(const Parameters& p, Junctions& junctions)
    : parameters_(p), junctions_(junctions) {
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    pinned_.push_back(is_slipping(junctions.repin_time(i, 0)) ? 0 : 1);
  }
}

InterfaceLaw::Changes SimplifiedLaw::update(const double* u_x, const double* v_x,
                                            const ContactView& contact, double t) {
  Changes changes;
  for (Eigen::Index i = 0; i < junctions_.attachment.rows(); ++i) {
    update_spring(i, u_x[i], v_x[i], contact.w[i], t, changes);
  }
  return changes;
}

/// Stretches are compared with mu w, w = f_N / k_ij = p_i / k_i.
void SimplifiedLaw::update_spring(Eigen::Index i, double u, double v, double w, double t,
                                  Changes& changes) {
  double& a = junctions_.attachment(i, 0);
  double& repin_time = junctions_.repin_time(i, 0);
  const double slow_until = junctions_.slow_until(i, 0);
  const double slip_stretch = parameters_.mu_d * w;
  if (t < std::abs(slow_until)) a += std::copysign(parameters_.v_slow * parameters_.dt, slow_until);
  if (!(w > 0.0)) a = u;
  if (is_slipping(repin_time)) {
    a = std::clamp(a, u - slip_stretch, u + slip_stretch);
    const bool moves_on = slow_until > 0.0 ? v > 0.0 : v < 0.0;
    if (!moves_on) {
      repin_time = Junctions::never;
      pinned_[static_cast<std::size_t>(i)] = 1;
      ++changes.repinned;
    }
  } else if (std::abs(u - a) > parameters_.mu_s * w) {
    break_spring(parameters_, junctions_, i, 0, u, w, t);
    pinned_[static_cast<std::size_t>(i)] = 0;
    ++changes.broken;
  }
}

void SimplifiedLaw::friction(const double* u_x, const ContactView& contact, double* tau) const {
  const auto N_s = static_cast<double>(parameters_.N_s);
  for (Eigen::Index i = 0; i < junctions_.attachment.rows(); ++i) {
    tau[i] = N_s * contact.k_ij[i] * (u_x[i] - junctions_.attachment(i, 0));
  }
}

}  // namespace rupture
