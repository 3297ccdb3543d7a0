#include "rupture/forces/interface_law.hpp"

#include "rupture/forces/decaying_law.hpp"
#include "rupture/forces/reference_law.hpp"
#include "rupture/forces/simplified_law.hpp"

namespace rupture {

std::unique_ptr<InterfaceLaw> make_law(const Parameters& parameters, Junctions& junctions) {
  switch (parameters.law) {
    case Law::simplified:
      return std::make_unique<SimplifiedLaw>(parameters, junctions);
    case Law::decaying:
      return std::make_unique<DecayingLaw>(parameters, junctions);
    case Law::reference:
      break;
  }
  return std::make_unique<ReferenceLaw>(parameters, junctions);
}

void break_by_law(const Parameters& parameters, Junctions& junctions, Eigen::Index i,
                  Eigen::Index j, double u, double w, double t) {
  switch (parameters.law) {
    case Law::simplified:
      return break_spring(parameters, junctions, i, u, w, t);
    case Law::reference:
    case Law::decaying:
      return break_junction(parameters, junctions, i, j, u, w, t);
  }
}

}  // namespace rupture
