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
    : parameters_(p),
      junctions_(junctions),
      sum_(static_cast<std::size_t>(p.Nx)),
      lowest_(sum_),
      highest_(sum_),
      next_repin_(sum_),
      pinned_(sum_.size()) {
  for (Eigen::Index i = 0; i < p.Nx; ++i) refresh(i);
}

ReferenceLaw::Changes ReferenceLaw::update(const double* u_x, const ContactView& contact,
                                           double t) {
  Changes changes;
  const auto N_s = static_cast<std::int32_t>(parameters_.N_s);
  for (Eigen::Index i = 0; i < junctions_.attachment.rows(); ++i) {
    const auto b = static_cast<std::size_t>(i);
    const double w = contact.w[i];
    if (!is_quiet(i, u_x[i], w, t)) {
      update_junctions(i, u_x[i], w, t, changes);
      refresh(i);
    } else if (pinned_[b] < N_s) {
      const double f_slip_stretch = parameters_.mu_d * w;
      sum_[b] = kernels().trail(N_s, u_x[i] - f_slip_stretch, u_x[i] + f_slip_stretch,
                                &junctions_.repin_time(i, 0), &junctions_.attachment(i, 0));
    }
  }
  return changes;
}

void ReferenceLaw::friction(const double* u_x, const ContactView& contact, double* tau) const {
  const auto N_s = static_cast<double>(parameters_.N_s);
  for (std::size_t i = 0; i < sum_.size(); ++i) {
    tau[i] = contact.k_ij[i] * (N_s * u_x[i] - sum_[i]);
  }
}

/// True if no junction of block i can break, be pinned again or lose contact now.
bool ReferenceLaw::is_quiet(Eigen::Index i, double u, double w, double t) const {
  const auto b = static_cast<std::size_t>(i);
  const double f_thres_stretch = parameters_.mu_s * w;
  return w > 0.0 && u - lowest_[b] <= f_thres_stretch && highest_[b] - u <= f_thres_stretch &&
         t < next_repin_[b];
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

void ReferenceLaw::refresh(Eigen::Index i) {
  const auto b = static_cast<std::size_t>(i);
  lowest_[b] = Junctions::never;
  highest_[b] = -Junctions::never;
  next_repin_[b] = Junctions::never;
  pinned_[b] = 0;
  for (Eigen::Index j = 0; j < junctions_.attachment.cols(); ++j) {
    const double repin_time = junctions_.repin_time(i, j);
    if (is_slipping(repin_time)) {
      next_repin_[b] = std::min(next_repin_[b], repin_time);
    } else {
      lowest_[b] = std::min(lowest_[b], junctions_.attachment(i, j));
      highest_[b] = std::max(highest_[b], junctions_.attachment(i, j));
      ++pinned_[b];
    }
  }
  sum_[b] = kernels().trail(junctions_.attachment.cols(), -Junctions::never, Junctions::never,
                            &junctions_.repin_time(i, 0), &junctions_.attachment(i, 0));
}

}  // namespace rupture
