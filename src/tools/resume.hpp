// Finding out where an interrupted run can be taken up.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "rupture/checkpoint/checkpoint.hpp"

namespace rupture::tools {

/// What a run leaves on its way.
struct RunFiles {
  std::filesystem::path output;                 ///< its checkpoints are OUT-tT.h5
  std::optional<std::filesystem::path> record;  ///< or its .part
  std::int64_t record_every = 1;                ///< [steps]
};

/// OUT-tT.h5 beside OUT.h5, for the checkpoint at time t [s].
std::filesystem::path path_at(const std::filesystem::path& output, double t);

/// A run as it was at one of its checkpoints.
struct Resumption {
  Checkpoint checkpoint;
  std::filesystem::path file;  ///< that it was read from
  Content rows;                ///< of its record up to there
};

/// True if `checkpoint` lies on the run that begins with `start`: the same parameters, beginning
/// and first tools.
bool is_of_run(const Checkpoint& checkpoint, const Checkpoint& start);

/// The run at its newest checkpoint that is intact and that its record reaches; none if there is no
/// such checkpoint. Throws Failure if the record in place is not of this run.
std::optional<Resumption> find_resumption(const Checkpoint& start, const RunFiles& files);

}  // namespace rupture::tools
