#include <fmt/core.h>

#include "rupture/dynamics/simulation.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/laws.hpp"

namespace rupture {
namespace {

/// One spring per block cannot become many, nor the other way round.
void refuse_other_springs(const Parameters& before, const Parameters& after) {
  const LawInfo &old_law = law_info(before.law), &new_law = law_info(after.law);
  if (old_law.springs == new_law.springs) return;
  const bool had_one = old_law.springs == SpringsPerBlock::one;
  throw UsageError(fmt::format(
      "junctions.law cannot change from {} to {} in a restart: the {} law has one spring per "
      "block; start with load --set junctions.law={}",
      old_law.name, new_law.name, had_one ? old_law.name : new_law.name, new_law.name));
}

void refuse_changes_of_kept(const Parameters& before, const Parameters& after) {
  for (const ParameterInfo* info : differing(before, after)) {
    if (info->restart == Restart::may_change) continue;
    throw UsageError(fmt::format("{} cannot change in a restart: the state was made with {}",
                                 info->name, parameter_text(before, *info)));
  }
}

}  // namespace

State continued(State state, const Parameters& after) {
  const Parameters before = state.made_with;
  refuse_changes_of_kept(before, after);
  refuse_other_springs(before, after);
  validate(after);
  change_law(before, after, time(before, state), state.junctions);
  change_pace(before, after, state);
  state.made_with = after;
  return state;
}

}  // namespace rupture
