// What a run remembers, as datasets under /run.
#pragma once

#include <optional>

#include "rupture/checkpoint/content.hpp"
#include "rupture/model/run_so_far.hpp"

namespace rupture {

Content run_content(const RunSoFar& run);

/// None if there is no /run, as in files that are not of a run or of schema 1. Throws Failure if it
/// is incomplete or contradicts the step that the state is at.
std::optional<RunSoFar> read_run(const Content& content, std::int64_t step);

}  // namespace rupture
