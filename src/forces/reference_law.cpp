#include "rupture/forces/reference_law.hpp"

#include <algorithm>
#include <cmath>

#include "rupture/model/random.hpp"

namespace rupture {

void break_junction(const Parameters& p, Junctions& junctions, Eigen::Index i, Eigen::Index j,
                    double u, double w, double t) {
  const double f_slip_stretch = p.mu_d * w;
  double& a = junctions.attachment(i, j);
  a = u > a ? u - f_slip_stretch : u + f_slip_stretch;
  const std::uint32_t n = junctions.draws(i, j)++;
  junctions.repin_time(i, j) =
      t + slipping_time(p, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), n);
}

ReferenceLaw::ReferenceLaw(const Parameters& p, Junctions& junctions)
    : parameters_(p), junctions_(junctions), blocks_(p, junctions) {}

InterfaceLaw::Changes ReferenceLaw::update(const double* u_x, const double* /*v_x*/,
                                           const ContactView& contact, double t) {
  Changes changes;
  for (Eigen::Index i = 0; i < junctions_.attachment.rows(); ++i) {
    const double u = u_x[i], w = contact.w[i];
    if (!blocks_.is_quiet(i, u, w, t)) {
      update_junctions(i, u, w, t, changes);
      blocks_.refresh(i);
    } else if (blocks_.is_slipping_anywhere(i)) {
      const double f_slip_stretch = parameters_.mu_d * w;
      blocks_.trail(i, u - f_slip_stretch, u + f_slip_stretch);
    }
  }
  return changes;
}

void ReferenceLaw::update_junctions(Eigen::Index i, double u, double w, double t,
                                    Changes& changes) {
  const double f_thres_stretch = parameters_.mu_s * w;
  const double f_slip_stretch = parameters_.mu_d * w;
  const bool contact = w > 0.0;
  for (Eigen::Index j = 0; j < junctions_.attachment.cols(); ++j) {
    double& a = junctions_.attachment(i, j);
    double& repin_time = junctions_.repin_time(i, j);
    if (!contact) a = u;
    if (is_slipping(repin_time)) {
      a = std::clamp(a, u - f_slip_stretch, u + f_slip_stretch);
      if (t >= repin_time) {
        repin_time = Junctions::never;
        if (parameters_.f_new == NewForce::zero) a = u;
        ++changes.repinned;
      }
    } else if (std::abs(u - a) > f_thres_stretch) {
      break_junction(parameters_, junctions_, i, j, u, w, t);
      ++changes.broken;
    }
  }
}

}  // namespace rupture
