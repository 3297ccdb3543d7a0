// Records: time series that grow during a run.
//
// Until the run ends they are in `<path>.part`, which can be read at any time up to its last
// flush; finish() turns it into `<path>`, sealed like a checkpoint. If the run is interrupted the
// .part stays, and another run can begin with what it holds.
#pragma once

#include <memory>

#include "rupture/checkpoint/file.hpp"
#include "rupture/checkpoint/record_content.hpp"

namespace rupture {

class GrowingFile;

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
  static constexpr std::size_t kMostHeld = 32'000'000;  ///< of an event that may span [bytes]

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

  /// Appends a sample that is dropped unless the event that is under way spans: until that is known
  /// it stays in memory, or from kMostHeld on apart in the .part file. With
  /// RecordedRun::every_in_spanning_events only.
  void hold(const Sample& sample);
  void event_spans() { keeps_held_ = true; }  ///< the one that is under way
  void no_event();                            ///< is under way

  /// Brings everything appended and held so far to the .part file.
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
  void write_rows(Content& rows, const char* prefix);

  std::filesystem::path path_;
  IfExists if_exists_;
  std::size_t flush_every_;
  Content rows_;             // that were appended since the last flush,
  Content held_;             // and held
  bool keeps_held_ = false;  // whether the event spans
  std::unique_ptr<GrowingFile> part_;
  bool part_has_samples_;
};

/// Reads a finished record or a .part, which ends at its last flush, or before the first one that
/// is damaged. Throws Failure.
Record read_record(const std::filesystem::path& path);

/// Reads a finished record or a .part with which another one can begin. Throws Failure.
RecordFile read_record_file(const std::filesystem::path& path);

}  // namespace rupture
