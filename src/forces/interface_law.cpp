#include "rupture/forces/interface_law.hpp"

#include "decaying_law.hpp"
#include "distance_law.hpp"
#include "reference_law.hpp"
#include "rupture/model/laws.hpp"
#include "simplified_law.hpp"

namespace rupture {

std::unique_ptr<InterfaceLaw> make_law(const Parameters& parameters, Junctions& junctions) {
  switch (parameters.law) {
    case Law::reference:
      break;
    case Law::simplified:
      return std::make_unique<SimplifiedLaw>(parameters, junctions);
    case Law::decaying:
      return std::make_unique<DecayingLaw>(parameters, junctions);
    case Law::distance:
      return std::make_unique<DistanceLaw>(parameters, junctions);
  }
  return std::make_unique<ReferenceLaw>(parameters, junctions);
}

void change_law(const Parameters& before, const Parameters& after, double t, Junctions& junctions) {
  const LawInfo &old_law = law_info(before.law), &new_law = law_info(after.law);
  const bool both_at_a_drawn_time = !old_law.memory && !new_law.memory;
  if (before.law == after.law || both_at_a_drawn_time) return;
  if (old_law.memory) (junctions.*old_law.memory->array).resize(0, 0);
  if (new_law.memory) (junctions.*new_law.memory->array).setZero(after.Nx, junctions.draws.cols());
  const auto law = make_law(after, junctions);
  for (Eigen::Index i = 0; i < junctions.repin_time.rows(); ++i) {
    for (Eigen::Index j = 0; j < junctions.repin_time.cols(); ++j) {
      if (is_slipping(junctions.repin_time(i, j))) law->start_slipping(i, j, t);
    }
  }
}

}  // namespace rupture
