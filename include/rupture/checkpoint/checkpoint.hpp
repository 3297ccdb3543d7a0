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
  std::string alarm = {};                   ///< that stopped the run in this state, if one did
  std::string checksum = {};  ///< of the content of the file that was read; empty if none was
};

/// All datasets of the checkpoint that holds these.
Content checkpoint_content(const Checkpoint& checkpoint);

/// Writes a checkpoint; returns its content checksum. Throws Failure as write_content() does.
std::string write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint,
                             IfExists if_exists);

/// Throws Failure, in one sentence that names the file, unless it is an intact checkpoint.
Checkpoint read_checkpoint(const std::filesystem::path& path);

/// Throws Failure if an alarm stopped a run in the state of this file. `otherwise` goes on with
/// what else one may do.
void refuse_state_of_alarm(const Checkpoint& checkpoint, const std::filesystem::path& path,
                           std::string_view otherwise = "");

/// The checkpoint in a content that was read already. Throws Failure.
Checkpoint checkpoint_from(const Content& content);

}  // namespace rupture
