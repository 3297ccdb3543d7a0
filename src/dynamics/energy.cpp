#include "rupture/dynamics/energy.hpp"

#include <algorithm>
#include <cmath>

namespace rupture {

Work& Work::operator+=(const Work& more) {
  driving += more.driving;
  damping += more.damping;
  junctions += more.junctions;
  return *this;
}

Work operator-(const Work& a, const Work& b) {
  return {a.driving - b.driving, a.damping - b.damping, a.junctions - b.junctions};
}

Work integrate(const Power& before, const Power& now, double dt) {
  const double half_dt = 0.5 * dt;
  return {half_dt * (before.driving + now.driving), half_dt * (before.damping + now.damping),
          half_dt * (before.junctions + now.junctions)};
}

double EnergyBalance::relative_error(double least_scale) const {
  const double scale =
      std::max({std::abs(supplied), std::abs(stored), std::abs(taken()), least_scale});
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
