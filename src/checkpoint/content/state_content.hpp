// What a checkpoint, and for /run also a record, holds besides parameters and provenance.
#pragma once

#include "rupture/checkpoint/record_content.hpp"
#include "rupture/model/state.hpp"

namespace rupture {

/// The state as datasets under /state (docs/schema.md).
Content state_content(const State& state);

/// Throws Failure if a dataset is missing or does not fit the parameters, or if the junctions
/// contradict themselves.
State read_state(const Content& content, const Parameters& parameters);

/// The memory of a run as datasets under /run.
Content run_content(const RunSoFar& run);

/// None if there is no /run, as in files that are not of a run. Throws Failure if it
/// is incomplete or contradicts the step that the state is at.
std::optional<RunSoFar> read_run(const Content& content, const Parameters& p, std::int64_t step);

/// The latest event in /run of either kind of file; not known if it is not there. Throws Failure.
LatestEvent read_event(const Content& content, const Parameters& p);

/// What a record holds of its run and of the event before its first sample, as datasets under /run.
/// Empty if there is none, as in files of earlier builds.
Content recorded_run_content(const RecordedRun& run, const LatestEvent& before);
RecordedRun read_recorded_run(const Content& content);

}  // namespace rupture
