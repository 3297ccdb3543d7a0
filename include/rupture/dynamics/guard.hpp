// Watches whether the numbers of a run still mean something (docs/guard.md says what, and where the
// limits come from).
#pragma once

#include <set>

#include "rupture/dynamics/simulation.hpp"

namespace rupture {

/// A warning is worth knowing; with an alarm the result is meaningless.
enum class Severity { warning, alarm };

/// Properties of a run that are watched.
enum class Check { time_step, energy, strength, contact, lattice };

/// One thing that was found.
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

/// Looks at a simulation from time to time. Never changes it.
class Guard {
 public:
  /// Opens the energy account.
  explicit Guard(const Simulation& simulation);

  /// The faults now, and in the energy account since the start or the last look. Each check is
  /// reported once per severity.
  std::vector<Finding> look(const Simulation& simulation);

 private:
  /// The energy account at one instant.
  struct Entry {
    std::int64_t step;
    Energies energies;
    Work work;
  };
  static Entry entry_of(const Simulation& simulation);
  std::optional<Finding> energy(const Simulation& simulation, const Entry& from,
                                const Entry& to) const;

  const Entry start_;
  Entry last_;
  std::set<std::pair<Check, Severity>> reported_;
};

}  // namespace rupture
