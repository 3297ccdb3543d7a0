// The loop: advance a simulation and let observers look at it at the steps they ask for.
#pragma once

#include <functional>
#include <limits>

#include "rupture/dynamics/simulation.hpp"

namespace rupture {

/// Looks at a simulation at chosen steps; never changes it.
class Observer {
 public:
  static constexpr std::int64_t no_step = std::numeric_limits<std::int64_t>::max();

  virtual ~Observer() = default;
  /// The next step at which observe() is to be called.
  virtual std::int64_t next_step() const = 0;
  virtual void observe(const Simulation& simulation) = 0;
};

struct StopRule {
  std::int64_t last_step = 0;  ///< latest step, always in force
  /// Also stop at the step at which a block ruptures. The rest is looked at every kQuietCheck
  /// steps from step 0, so that the answer does not depend on what else pauses the run. A run that
  /// may end early also ends at rest, where that can no longer come, as a condition always can.
  EarlyEnd early = {};
  /// Also stop where an observer has found this to be true, if it is given.
  std::function<bool()> condition_holds = {};
  /// Also stop once this is true, if it is given; asked some ten times a second.
  std::function<bool()> interrupted = {};
};
inline constexpr std::int64_t kQuietCheck = 100;

enum class Ending { last_step, quiet, spanned, ruptured, condition, at_rest, interrupted };

/// Whether a run has come to its end in this state, interruptions apart.
std::optional<Ending> ending_at(const State& state, const RunSoFar& run, const StopRule& rule);

/// Advances until the stop rule says so. Observers see the state at each step they ask for, the
/// step at which the run starts and the one at which it ends included.
Ending run(Simulation& simulation, const StopRule& rule, const std::vector<Observer*>& observers);

}  // namespace rupture
