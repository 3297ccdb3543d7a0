// What a record holds.
#pragma once

#include "rupture/checkpoint/provenance.hpp"
#include "rupture/model/field.hpp"
#include "rupture/model/rupture.hpp"

namespace rupture {

/// One line of the series; the vectors have one value per interface block, Nx in all.
struct Sample {
  double time = 0;  ///< [s]
  std::int64_t step = 0;
  double F_T = 0;                     ///< driving force [N]
  double x_drive = 0;                 ///< position of the driving point [m]
  std::vector<std::uint16_t> pinned;  ///< number of pinned junctions
  std::vector<double> p;              ///< normal force on the block [N]
  std::vector<double> tau;            ///< friction force, > 0 where it pushes towards -x [N]
  std::vector<double> u_x;            ///< displacement [m]
};

/// Displacement of all blocks from the undeformed lattice, row by row from the interface, Nx Nz
/// values each. float32 has seven digits, some 1e-11 m here: enough for pictures, half the size.
struct FieldSample {
  double time = 0;  ///< [s]
  std::int64_t step = 0;
  std::vector<float> u_x, u_z;  ///< [m]
};

/// Whether a record holds the displacement of all blocks.
enum class Fields { omit, record };
/// By which --resume recognises a record; not part of the content checksum.
struct RecordedRun {
  std::string id = {};                         ///< that all files of the run share; empty: unknown
  double every = 0;                            ///< sampling interval [s]
  std::optional<double> fields_every = {};     ///< that of the fields, if there are any [s]
  std::optional<double> every_in_events = {};  ///< of both while an event is under way [s]
  std::optional<double> quiet_time = {};       ///< that separates events then; none: 5 t_R [s]
  std::optional<double> every_in_spanning_events = {};  ///< of series, if it spans [s]

  bool operator==(const RecordedRun&) const = default;
};
/// What a record may hold besides series and ruptures.
struct RecordParts {
  std::vector<double> crossing_levels = {};  ///< pinned fractions, ascending; none: no crossings
  Fields fields = Fields::omit;
  RecordedRun run = {};
  LatestEvent before = {};  ///< the latest event before the record begins
};

struct Record {
  Parameters parameters;
  std::vector<ProvenanceEntry> provenance;  ///< oldest first
  RecordedRun run;
  LatestEvent before;        ///< the latest event before the first sample
  std::vector<double> time;  ///< one value per sample [s]
  std::vector<std::int64_t> step;
  std::vector<double> F_T;              ///< [N]
  std::vector<double> x_drive;          ///< [m]
  RowMajorArray<std::uint16_t> pinned;  ///< [samples][Nx]
  RowMajorArray<double> p, tau;         ///< [samples][Nx] [N]
  RowMajorArray<double> u_x;            ///< [samples][Nx] [m]
  std::vector<Rupture> ruptures;
  std::vector<double> crossing_levels;   ///< other pinned fractions, ascending,
  std::vector<Rupture> crossings;        ///< and when blocks fell below them
  std::vector<std::int64_t> field_step;  ///< of the samples of the fields, whose values are /fields
};

/// The record in a file that was read already. Throws Failure.
Record record_from(const ContentFile& file);

/// When blocks' pinned fractions fell below `fraction`: the ruptures, or the crossings of this
/// level; first those of the latest event before the first sample, with its last one. Of these,
/// the record holds when blocks fell below kRupturedFraction. Whether they had fallen below another
/// fraction, its first sample tells: not yet if they are above it and ruptured less than t_R/2 ago.
/// Throws Failure if the record does not hold the level.
std::vector<Rupture> ruptures_below(const Record& record, double fraction);

/// A record, and its datasets as they are in the file.
struct RecordFile {
  Record record;
  Content content;
  std::uint64_t ignored_bytes = 0;  ///< see ContentFile
};

/// The samples, ruptures, crossings and fields of a record up to and including a step, with which
/// another one can begin.
Content rows_until(const Content& record, std::int64_t step);

/// Before the path of a dataset of a .part: samples of it that RecordWriter holds.
inline constexpr const char* kHeld = "/held";
inline constexpr const char* kHeldSteps = "/held/series/step";

/// An unfinished record in which the samples that RecordWriter holds are in their places if their
/// event spans, as far as its ruptures tell, and else are gone.
Content with_spanning_events(Content record);

/// The datasets of an unfinished record up to its last sample, with this provenance, as a finished
/// record holds them. There must be a sample.
Content finished_content(const RecordFile& part, const std::vector<ProvenanceEntry>& provenance);

}  // namespace rupture
