#include "rupture/dynamics/energy.hpp"

#include <algorithm>
#include <cmath>

namespace rupture {

double EnergyBalance::relative_error() const {
  const double scale = std::max({std::abs(supplied), std::abs(stored), std::abs(taken())});
  return scale > 0.0 ? std::abs(error()) / scale : 0.0;
}

EnergyBalance energy_balance(const Energies& before, const Energies& after, const Work& work) {
  const double work_of_load = before.load - after.load;
  EnergyBalance balance;
  balance.supplied = work.driving + work_of_load;
  balance.stored = (after.total() - after.load) - (before.total() - before.load);
  balance.damping = work.damping;
  balance.junctions = work.junctions;
  return balance;
}

}  // namespace rupture
