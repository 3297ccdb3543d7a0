// Finding out where an interrupted run can be taken up.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "run/interval.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/dynamics/run.hpp"

namespace rupture::tools {

/// The files that a run leaves on its way.
struct RunFiles {
  std::filesystem::path output;                 ///< its checkpoints are OUT-tT.h5
  std::optional<std::filesystem::path> record;  ///< or its .part
  Interval record_every;
  IfExists if_exists = IfExists::refuse;      ///< what is not of the run
  std::vector<double> crossings = {};         ///< levels of the record, ascending
  std::optional<Interval> fields_every = {};  ///< none: the record has no fields
};

/// OUT-tT.h5 beside OUT.h5, for the checkpoint at time t [s].
std::filesystem::path path_at(const std::filesystem::path& output, double t);

/// Name of the run that begins with `start`: SHA-256 of which tool began it, from which content,
/// with which parameters and at which step. Every file of the run has it, resumed or not.
std::string id_of_run(const Checkpoint& start);

/// By which its record is known.
RecordedRun recorded_run(const Checkpoint& start, const RunFiles& files);

/// A run as it was at one of its checkpoints.
struct Resumption {
  Checkpoint checkpoint;
  std::filesystem::path file;                           ///< that it was read from
  Content rows;                                         ///< of its record up to there
  std::vector<ProvenanceEntry> record_provenance = {};  ///< the record begins where the run did
};

/// Files of an interrupted run.
struct Remains {
  /// The run at its newest checkpoint that is intact, not beyond its end, and that its record
  /// reaches; none if there is no such checkpoint. It may be that of the run's end.
  std::optional<Resumption> newest;
  bool is_complete = false;  ///< it is that one, and the record is finished, too
  /// That checkpoint and those of later times that are of the run or damaged: it may replace them.
  /// That of its end only if it is the one that it will write.
  std::set<std::filesystem::path> replaceable;
};

/// Reads each file once. Throws Failure if there is a record that is not this run's.
Remains find_remains(const Checkpoint& start, const StopRule& rule, const RunFiles& files);

/// True if `path`, a checkpoint, may be written by the run that begins with `start` when
/// it is resumed, as things are now: there is nothing, or a checkpoint of this run, or a damaged
/// one.
bool may_write(const std::filesystem::path& path, const Checkpoint& start);

/// The step of the last sample of a group in these rows of a record; -1 if there is none.
inline constexpr const char* kSeriesGroup = "/series";
inline constexpr const char* kFieldsGroup = "/fields";
std::int64_t last_sample(const Content& rows, const std::string& group);

}  // namespace rupture::tools
