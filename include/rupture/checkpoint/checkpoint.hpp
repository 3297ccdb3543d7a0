// Checkpoints: everything that determines the rest of a run, in one file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rupture/checkpoint/content.hpp"
#include "rupture/checkpoint/file.hpp"
#include "rupture/checkpoint/provenance.hpp"
#include "rupture/model/parameters.hpp"
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

/// The parameters as datasets: row "slider.L" of the table becomes /parameters/slider/L.
Content parameters_content(const Parameters& parameters);

/// The parameters of a content as they count in its checksum (docs/schema.md): one that the law
/// does not use with its default, and one of Since::later only where it differs from that. Other
/// tables than that of this build are for tests.
Content counted_parameters(const Content& content,
                           const std::vector<ParameterInfo>& table = parameter_table());

/// The same for files up to schema 2: as they are stored, without those of Since::later.
Content parameters_of_schema_2(const Content& content);

/// Throws Failure if the content has a parameter that this build does not know.
void refuse_unknown_parameters(const Content& content);

/// Throws Failure if a parameter is missing, unknown or out of range, or if they make no sense
/// together. Parameters that older builds did not have may be missing: they take their default,
/// which is how those builds behaved.
Parameters read_parameters(const Content& content);

/// The state as datasets under /state (docs/schema.md).
Content state_content(const State& state);

/// Throws Failure if a dataset is missing or does not fit the parameters, or if the junctions
/// contradict themselves.
State read_state(const Content& content, const Parameters& parameters);

/// Checksum of the checkpoint that holds these, without writing it.
std::string content_checksum(const Parameters& parameters, const State& state);

/// All datasets of the checkpoint that holds these.
Content checkpoint_content(const Checkpoint& checkpoint);

/// Writes a checkpoint and, on request, its .sum; returns its content checksum. Throws Failure as
/// write_content() does.
std::string write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint,
                             IfExists if_exists, SumFile sum = SumFile::omit);

/// Throws Failure, in one sentence that names the file, unless it is an intact checkpoint.
Checkpoint read_checkpoint(const std::filesystem::path& path);

/// The checkpoint in a content that was read already. Throws Failure.
Checkpoint checkpoint_from(const Content& content);

}  // namespace rupture
