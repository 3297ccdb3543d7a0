#include "rupture/forces/decaying_law.hpp"

#include "rupture/model/random.hpp"

namespace rupture {

DecayingLaw::DecayingLaw(const Parameters& p, Junctions& junctions) : JunctionLaw(p, junctions) {
  rate_.setZero(junctions.attachment.rows(), junctions.attachment.cols());
  for (Eigen::Index i = 0; i < rate_.rows(); ++i) {
    for (Eigen::Index j = 0; j < rate_.cols(); ++j) {
      if (is_slipping(junctions.repin_time(i, j))) has_broken(i, j);
    }
  }
}

/// Finds the rate of decay from the slipping time that junction j of block i drew last.
void DecayingLaw::has_broken(Eigen::Index i, Eigen::Index j) {
  const std::uint32_t draws = junctions_.draws(i, j);
  const double t_R = slipping_time(parameters_, static_cast<std::uint32_t>(i),
                                   static_cast<std::uint32_t>(j), draws > 0 ? draws - 1 : 0);
  rate_(i, j) = t_R > 0.0 ? (parameters_.mu_d - parameters_.mu_new) / t_R : 0.0;
}

/// f_slip(t_s) / k_ij.
double DecayingLaw::slip_stretch(Eigen::Index i, Eigen::Index j, double w, double t) const {
  const double time_left = junctions_.repin_time(i, j) - t;
  return w * std::clamp(parameters_.mu_new + rate_(i, j) * time_left, parameters_.mu_new,
                        parameters_.mu_d);
}

void DecayingLaw::trail(Eigen::Index i, double u, double w, double t) {
  for (Eigen::Index j = 0; j < junctions_.attachment.cols(); ++j) {
    if (!is_slipping(junctions_.repin_time(i, j))) continue;
    const double stretch = slip_stretch(i, j, w, t);
    double& a = junctions_.attachment(i, j);
    a = std::clamp(a, u - stretch, u + stretch);
  }
  blocks_.recompute_sum(i);
}

template class JunctionLaw<DecayingLaw>;

}  // namespace rupture
