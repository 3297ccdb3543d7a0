// Records: time series that grow during a run.
//
// Until the run ends they are in `<path>.part`, which can be read at any time up to its last
// flush; finish() turns it into `<path>`, sealed like a checkpoint. If the run is interrupted the
// .part stays, and another run can begin with what it holds.
#pragma once

#include <memory>

#include "rupture/checkpoint/file.hpp"
#include "rupture/checkpoint/provenance.hpp"
#include "rupture/model/field.hpp"
#include "rupture/model/rupture.hpp"

namespace rupture {

class GrowingFile;

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

/// `<path>.part`, where the record lives until it is finished.
std::filesystem::path part_path(const std::filesystem::path& path);

/// Throws unless a run with these parameters may write this record: Failure as check_output(), also
/// of its .part; UsageError if N_s does not fit the 16 bits of a pinned count.
void check_record(const std::filesystem::path& path, const Parameters& parameters,
                  IfExists if_exists);

/// Writes one record. append() only copies into buffers; after `flush_every` rows, or kFlushBytes,
/// they go to the .part file.
class RecordWriter {
 public:
  static constexpr std::size_t kFlushEvery = 256;
  static constexpr std::size_t kFlushBytes = 1U << 20U;

  /// Begins with `rows_before`, of rows_until(). There are no datasets for `parts` that the record
  /// does not have. Throws as check_record(), and Failure if the .part cannot be written.
  RecordWriter(std::filesystem::path path, const Parameters& parameters,
               const std::vector<ProvenanceEntry>& provenance, IfExists if_exists,
               Content rows_before = {}, const RecordParts& parts = {},
               std::size_t flush_every = kFlushEvery);
  ~RecordWriter();
  RecordWriter& operator=(RecordWriter&&) = delete;

  /// Throws Failure if the disk is full or a number is not finite, which is seen at the next flush;
  /// the rows then are kept for another one.
  void append(const Sample& sample);
  /// Ruptures, and crossings of the record's levels.
  void append(std::span<const Rupture> ruptures);
  void append(const FieldSample& sample);

  /// Brings everything appended so far to the .part file.
  void flush();
  /// The same, and the file to the disk.
  void sync();

  /// Flushes, seals, renames to the final path and returns the content checksum. Nothing may be
  /// appended afterwards. Throws Failure, also if the record does not begin at `first_step` or its
  /// steps do not ascend; the .part then stays. A `provenance` that is given replaces that of the
  /// .part, which could not know how the run ends.
  std::string finish(const std::vector<ProvenanceEntry>& provenance = {},
                     std::optional<std::int64_t> first_step = {});

 private:
  void flush_if_full();

  std::filesystem::path path_;
  IfExists if_exists_;
  std::size_t flush_every_;
  Content rows_;  // that were appended since the last flush
  std::unique_ptr<GrowingFile> part_;
  bool part_has_samples_;
};

/// Reads a finished record or a .part, which ends at its last flush, or before the first one that
/// is damaged. Throws Failure.
Record read_record(const std::filesystem::path& path);

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

/// Reads a finished record or a .part with which another one can begin. Throws Failure.
RecordFile read_record_file(const std::filesystem::path& path);

/// The samples, ruptures, crossings and fields of a record up to and including a step, with which
/// another one can begin.
Content rows_until(const Content& record, std::int64_t step);

/// The datasets of an unfinished record up to its last sample, with this provenance, as a finished
/// record holds them. There must be a sample.
Content finished_content(const RecordFile& part, const std::vector<ProvenanceEntry>& provenance);

}  // namespace rupture
