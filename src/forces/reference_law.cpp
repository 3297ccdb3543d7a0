#include "rupture/forces/reference_law.hpp"

#include "rupture/model/random.hpp"

namespace rupture {

template class JunctionLaw<ReferenceLaw>;

ReferenceLaw::ReferenceLaw(const Parameters& p, Junctions& junctions) : JunctionLaw(p, junctions) {}

void ReferenceLaw::start_slipping(const Parameters& p, Junctions& junctions, Eigen::Index i,
                                  Eigen::Index j, double t) {
  const std::uint32_t n = junctions.draws(i, j)++;
  junctions.repin_time(i, j) =
      t + slipping_time(p, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), n);
}

}  // namespace rupture
