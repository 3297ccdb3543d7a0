// What checkpoints and records hold of the run that wrote them, as datasets under /run.
#pragma once

#include <optional>

#include "rupture/checkpoint/record.hpp"
#include "rupture/model/rupture.hpp"

namespace rupture {

Content run_content(const RunSoFar& run);

/// None if there is no /run, as in files that are not of a run or of schema 1. Throws Failure if it
/// is incomplete or contradicts the step that the state is at.
std::optional<RunSoFar> read_run(const Content& content, const Parameters& p, std::int64_t step);

/// The same of a record. Empty if there is none, as in files of earlier builds.
Content recorded_run_content(const RecordedRun& run);
RecordedRun read_recorded_run(const Content& content);

}  // namespace rupture
