#include "rupture/forces/distance_law.hpp"

#include <limits>

#include "rupture/model/random.hpp"

namespace rupture {

template class JunctionLaw<DistanceLaw>;

DistanceLaw::DistanceLaw(const Parameters& p, Junctions& junctions) : JunctionLaw(p, junctions) {}

void DistanceLaw::start_slipping(const Parameters& p, Junctions& junctions, Eigen::Index i,
                                 Eigen::Index j, double /*t*/) {
  const double d_R = folded_gaussian(p.d_R, p.delta_d_R, p.seed, static_cast<std::uint32_t>(i),
                                     static_cast<std::uint32_t>(j), junctions.draws(i, j)++);
  junctions.slip_left(i, j) = std::max(d_R, std::numeric_limits<double>::min());  // 0: pinned
  junctions.repin_time(i, j) = Junctions::unknown;
}

}  // namespace rupture
