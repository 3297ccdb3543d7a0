// Checkpoints: everything that determines the rest of a run, in one file.
#pragma once

#include "rupture/checkpoint/file.hpp"
#include "rupture/checkpoint/parameters_content.hpp"
#include "rupture/checkpoint/provenance.hpp"
#include "rupture/model/rupture.hpp"
#include "rupture/model/state.hpp"

namespace rupture {

struct Checkpoint {
  Parameters parameters;
  State state;
  std::vector<ProvenanceEntry> provenance;  ///< oldest first
  std::optional<RunSoFar> run = {};         ///< of the run that wrote it, if it was a run
  std::string checksum = {};  ///< of the content of the file that was read; empty if none was
};

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

/// All datasets of the checkpoint that holds these.
Content checkpoint_content(const Checkpoint& checkpoint);

/// Writes a checkpoint; returns its content checksum. Throws Failure as write_content() does.
std::string write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint,
                             IfExists if_exists);

/// Throws Failure, in one sentence that names the file, unless it is an intact checkpoint.
Checkpoint read_checkpoint(const std::filesystem::path& path);

/// The checkpoint in a content that was read already. Throws Failure.
Checkpoint checkpoint_from(const Content& content);

}  // namespace rupture
