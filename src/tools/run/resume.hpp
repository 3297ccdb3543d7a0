// Finding out where an interrupted run can be taken up.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "run/files.hpp"
#include "rupture/dynamics/run.hpp"

namespace rupture::tools {

/// A run as it was at one of its checkpoints.
struct Resumption {
  Checkpoint checkpoint;
  std::filesystem::path file;  ///< that it was read from
  Content rows;                ///< of its record up to there
};

/// Files of an interrupted run.
struct Found {
  /// The run at its newest checkpoint that is intact, not beyond its end, and that its record
  /// reaches; none if there is no such checkpoint. It may be that of the run's end.
  std::optional<Resumption> newest;
  bool is_complete = false;  ///< it is that one, and the record is finished, too
  /// That checkpoint and those of later times that are of the run or damaged: it may replace them.
  /// That of its end only if it is the one that it will write.
  std::set<std::filesystem::path> replaceable;
};

/// Reads each file once. Throws Failure if there is a record that is not this run's.
Found find_run(const Checkpoint& start, const StopRule& rule, const RunFiles& files);

/// True if `path`, a checkpoint, may be written by the run that begins with `start` when
/// it is resumed, as things are now: there is nothing, or a checkpoint of this run, or a damaged
/// one.
bool may_write(const std::filesystem::path& path, const Checkpoint& start);

/// The step of the last sample of a group in these rows of a record; -1 if there is none.
inline constexpr const char* kSeriesGroup = "/series";
inline constexpr const char* kFieldsGroup = "/fields";
std::int64_t last_sample(const Content& rows, const std::string& group);

}  // namespace rupture::tools
