// Watches whether the numbers of a run still mean something (docs/guard.md says what, and where the
// limits come from).
#pragma once

#include <cstdint>
#include <set>

#include "rupture/dynamics/simulation.hpp"

namespace rupture {

/// A warning is worth knowing; with an alarm the result is meaningless.
enum class Severity { warning, alarm };

enum class Check { time_step, energy, strength, contact, lattice };

struct Finding {
  Check check;
  Severity severity;
  std::string sentence;  ///< when and where, what was found, the limit, what to do
};

/// Largest error of the energy account over `steps` steps, relative to what it accounts for. The
/// error is the change of sum dt^2/(8m) (G^2 - 2 F G) between two instants, which does not grow
/// with the number of steps, but less flows in a short time.
inline double energy_tolerance(std::int64_t steps) {
  return 0.01 * (1.0 + 1000.0 / static_cast<double>(steps));
}

/// The step after this one at which a run is looked at: one look costs a few steps.
inline std::int64_t next_look(std::int64_t step) {
  constexpr std::int64_t every = 5000;
  return (step / every + 1) * every;
}

/// The energy account at one instant.
struct AccountEntry {
  explicit AccountEntry(const Simulation& simulation)
      : step(simulation.state().step), energies(simulation.energies()), work(simulation.work()) {}

  std::int64_t step;
  Energies energies;
  Work work;
};

/// Looks at a simulation from time to time. Never changes it.
class Guard {
 public:
  explicit Guard(const Simulation& simulation) : start_(simulation), last_(start_) {}

  /// The faults now, and in the energy account since the start or the last look. Each check is
  /// reported once per severity.
  std::vector<Finding> look(const Simulation& simulation);

 private:
  const AccountEntry start_;
  AccountEntry last_;
  std::set<std::pair<Check, Severity>> reported_;
};

}  // namespace rupture
