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

}  // namespace rupture
