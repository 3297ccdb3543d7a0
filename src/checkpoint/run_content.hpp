// The memory of a run (model/run_so_far.hpp), as datasets under /run.
#pragma once

#include <optional>
#include <string>

#include "rupture/checkpoint/content.hpp"
#include "rupture/model/run_so_far.hpp"

namespace rupture {

/// Without `id` if that is empty.
Content run_content(const RunSoFar& run, const std::string& id);

/// None if there is no /run, as in files that are not of a run or of schema 1. Throws Failure if it
/// is incomplete or contradicts the step that the state is at.
std::optional<RunSoFar> read_run(const Content& content, const Parameters& p, std::int64_t step);

/// Empty if there is none, as in files of earlier builds.
std::string read_run_id(const Content& content);

}  // namespace rupture
