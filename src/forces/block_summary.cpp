#include "rupture/forces/block_summary.hpp"

#include <algorithm>

namespace rupture {

BlockSummary::BlockSummary(const Parameters& p, Junctions& junctions)
    : mu_s_(p.mu_s),
      N_s_(static_cast<std::int32_t>(p.N_s)),
      junctions_(junctions),
      sum_(static_cast<std::size_t>(p.Nx)),
      lowest_(sum_),
      highest_(sum_),
      next_repin_(sum_),
      pinned_(sum_.size()) {
  for (Eigen::Index i = 0; i < p.Nx; ++i) refresh(i);
}

void BlockSummary::trail(Eigen::Index i, double lower, double upper) {
  sum_[static_cast<std::size_t>(i)] = kernels().trail(
      N_s_, lower, upper, &junctions_.repin_time(i, 0), &junctions_.attachment(i, 0));
}

void BlockSummary::refresh(Eigen::Index i) {
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

void BlockSummary::friction(const double* u_x, const ContactView& contact, double* tau) const {
  const auto N_s = static_cast<double>(N_s_);
  for (std::size_t i = 0; i < sum_.size(); ++i) {
    tau[i] = contact.k_ij[i] * (N_s * u_x[i] - sum_[i]);
  }
}

}  // namespace rupture
