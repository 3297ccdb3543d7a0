// Sums and bounds over the many junctions of each block, by which untouched blocks cost nothing.
//
// Everything here follows from the junctions, to the last bit and whatever happened before: a run
// that is split has the same summary.
#pragma once

#include <algorithm>

#include "rupture/forces/kernels.hpp"
#include "rupture/model/state.hpp"

namespace rupture {

class BlockSummary {
 public:
  /// Reads `junctions`, which must outlive the summary.
  BlockSummary(const Parameters& p, Junctions& junctions)
      : N_s_(static_cast<std::int32_t>(p.N_s)),
        junctions_(junctions),
        sum_(static_cast<std::size_t>(p.Nx)),
        lowest_(sum_),
        highest_(sum_),
        next_repin_(sum_),
        pinned_(sum_.size()) {
    for (Eigen::Index i = 0; i < p.Nx; ++i) {
      mu_s_.push_back(p.mu_s[i]);
      refresh(i);
    }
  }

  /// True if no junction of block i can break, be pinned again or lose contact at time t [s], with
  /// the block at u [m]; w: see ContactView.
  bool is_quiet(Eigen::Index i, double u, double w, double t) const {
    const auto b = static_cast<std::size_t>(i);
    const double f_thres_stretch = mu_s_[b] * w;
    return w > 0.0 && u - lowest_[b] <= f_thres_stretch && highest_[b] - u <= f_thres_stretch &&
           t < next_repin_[b];
  }
  bool is_slipping_anywhere(Eigen::Index i) const {
    return pinned_[static_cast<std::size_t>(i)] < N_s_;
  }

  /// Clamps the attachment points of block i's slipping junctions to [lower, upper] [m].
  void trail(Eigen::Index i, double lower, double upper) {
    sum_[static_cast<std::size_t>(i)] = kernels().trail(
        N_s_, lower, upper, &junctions_.repin_time(i, 0), &junctions_.attachment(i, 0));
  }
  /// To be called after attachment points of slipping junctions of block i have changed.
  void recompute_sum(Eigen::Index i) { trail(i, -Junctions::never, Junctions::never); }
  /// To be called after any junction of block i has changed.
  void refresh(Eigen::Index i) {
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
    recompute_sum(i);
  }

  /// Friction force on each block, tau_i = sum_j k_ij (x_i - x_ij), positive towards -x [N].
  void friction(const double* u_x, const ContactView& contact, double* tau) const {
    const auto N_s = static_cast<double>(N_s_);
    for (std::size_t i = 0; i < sum_.size(); ++i) {
      tau[i] = contact.k_ij[i] * (N_s * u_x[i] - sum_[i]);
    }
  }

  const std::vector<std::int32_t>& pinned() const { return pinned_; }

 private:
  const std::int32_t N_s_;
  Junctions& junctions_;
  std::vector<double> mu_s_;              // threshold coefficient of each block
  std::vector<double> sum_;               // of all attachment points [m]
  std::vector<double> lowest_, highest_;  // attachment points of pinned junctions [m]
  std::vector<double> next_repin_;        // earliest repin time [s]
  std::vector<std::int32_t> pinned_;
};

}  // namespace rupture
