#include "rupture/checkpoint/record.hpp"

#include <algorithm>
#include <limits>

#include "checkpoint/content/context.hpp"
#include "checkpoint/content/record_layout.hpp"
#include "checkpoint/content/state_content.hpp"
#include "checkpoint/files/atomic_write.hpp"
#include "checkpoint/sealed/seal.hpp"
#include "rupture/checkpoint/parameters_content.hpp"

namespace rupture {
namespace {

namespace layout = record_layout;

// Adds the datasets of a table, without rows.
void begin(Content& rows, const auto& table, const auto& row, const Parameters& parameters) {
  layout::for_each(table, [&](const auto& column) {
    const auto& entry = row.*column.member;
    rows[column.path] = {
        column.unit, layout::type_of(entry), layout::shape_of(entry, 0, parameters), {}};
  });
}

void check_size(const std::string& path, const Shape& shape, std::size_t size) {
  const std::uint64_t expected = element_count({shape.begin() + 1, shape.end()});
  if (size == expected) return;
  fail("a sample has {} values of {}; expected {} = {}", size, path.substr(path.rfind('/') + 1),
       shape.size() > 2 ? "Nx Nz" : "Nx", expected);
}

void add_row(Content& rows, const auto& table, const auto& row) {
  layout::for_each(table, [&](const auto& column) {
    check_size(column.path, rows.at(column.path).shape,
               layout::values_of(row.*column.member).size());
  });
  layout::for_each(table, [&](const auto& column) {
    const auto bytes = std::as_bytes(layout::values_of(row.*column.member));
    Dataset& dataset = rows.at(column.path);
    dataset.bytes.insert(dataset.bytes.end(), bytes.begin(), bytes.end());
    ++dataset.shape[0];
  });
}

// Whether there are so many rows of a dataset, or bytes of all.
bool has_reached(const Content& rows, std::size_t most_rows, std::size_t most_bytes) {
  std::size_t most = 0, bytes = 0;
  for (const auto& [path, dataset] : rows) {
    most = std::max<std::size_t>(most, dataset.shape[0]);
    bytes += dataset.bytes.size();
  }
  return most >= most_rows || bytes >= most_bytes;
}

void clear(Content& rows) {
  for (auto& [path, dataset] : rows) {
    dataset.bytes.clear();
    dataset.shape[0] = 0;
  }
}

std::vector<std::byte> piece_of(const std::filesystem::path& part, const Content& rows) {
  return naming(part, [&] { return seal(FileKind::open_record, rows); }).bytes;
}

}  // namespace

std::filesystem::path part_path(const std::filesystem::path& path) {
  return path.string() + ".part";
}

void check_record(const std::filesystem::path& path, const Parameters& parameters,
                  IfExists if_exists) {
  constexpr std::int64_t most = std::numeric_limits<std::uint16_t>::max();
  if (springs_per_block(parameters) > most) {
    throw UsageError(
        "junctions.N_s = {} is too large for a record, which counts up to {} junctions per block",
        parameters.N_s, most);
  }
  check_output(path, if_exists);
  const auto part = part_path(path);
  std::error_code ignored;
  if (if_exists == IfExists::refuse && std::filesystem::is_regular_file(part, ignored)) {
    fail_existing(part, kResume);
  }
  check_output(part, if_exists);
}

RecordWriter::RecordWriter(std::filesystem::path path, const Parameters& parameters,
                           const std::vector<ProvenanceEntry>& provenance, IfExists if_exists,
                           Content rows_before, const RecordParts& parts, std::size_t flush_every)
    : path_(std::move(path)),
      if_exists_(if_exists),
      flush_every_(flush_every),
      part_has_samples_(!rows_before.empty()) {
  check_record(path_, parameters, if_exists);
  begin(rows_, layout::kSeries, Sample{}, parameters);
  begin(rows_, layout::kRuptures, Rupture{}, parameters);
  if (const auto& levels = parts.crossing_levels; !levels.empty()) {
    begin(rows_, layout::kCrossings, Rupture{}, parameters);
    rows_before[layout::kCrossingLevels] = make_array(std::span(levels), {levels.size()}, "1");
  }
  if (parts.fields == Fields::record) begin(rows_, layout::kFields, FieldSample{}, parameters);
  if (parts.run.every_in_spanning_events) {
    begin(held_, layout::kSeries, Sample{}, parameters);
    for (const auto& [name, dataset] : held_) rows_before.emplace(kHeld + name, dataset);
  }
  Content first = std::move(rows_before);  // with what stays as it is
  first.merge(recorded_run_content(parts.run, parts.before));
  first.merge(Content(rows_));  // all datasets are there, even if without rows
  first.merge(parameters_content(parameters));
  first.merge(provenance_content(provenance));
  first.merge(record_positions(parameters, first));
  const auto part = part_path(path_);
  part_ = std::make_unique<GrowingFile>(part, piece_of(part, first), if_exists);
}

RecordWriter::~RecordWriter() = default;

void RecordWriter::append(const Sample& sample) {
  add_row(rows_, layout::kSeries, sample);
  flush_if_full();
}

void RecordWriter::append(std::span<const Rupture> ruptures) {
  for (const Rupture& rupture : ruptures) {
    if (rupture.pinned_below == kRupturedFraction) {
      add_row(rows_, layout::kRuptures, rupture);
    } else {
      add_row(rows_, layout::kCrossings, rupture);
    }
  }
  flush_if_full();
}

void RecordWriter::append(const FieldSample& sample) {
  add_row(rows_, layout::kFields, sample);
  flush_if_full();
}

void RecordWriter::flush_if_full() {
  if (has_reached(rows_, flush_every_, kFlushBytes)) write_rows(rows_, "");
  const bool is_full = keeps_held_ ? has_reached(held_, flush_every_, kFlushBytes)
                                   : has_reached(held_, SIZE_MAX, kMostHeld);
  if (is_full) flush();
}

void RecordWriter::hold(const Sample& sample) {
  add_row(held_, layout::kSeries, sample);
  flush_if_full();
}

void RecordWriter::no_event() {
  if (std::exchange(keeps_held_, false)) return flush();
  clear(held_);
}

void RecordWriter::flush() {
  write_rows(rows_, "");  // first, as a full disk may have no room for the others
  write_rows(held_, kHeld);
}

void RecordWriter::write_rows(Content& rows, const char* prefix) {
  Content piece;
  for (const auto& [path, dataset] : rows) {
    if (dataset.shape[0] > 0) piece[prefix + path] = dataset;
  }
  if (piece.empty()) return;
  const std::string part = part_path(path_).string();
  try {
    part_->append(piece_of(part, piece));  // if this fails, the next one has the rows
  } catch (const Failure& failure) {
    if (!part_has_samples_) throw;
    fail_like(
        failure,
        "{}; what was recorded before is kept: rupture finish {} -o NEW.h5 makes a record of it",
        failure.what(), part);
  }
  part_has_samples_ = true;
  clear(rows);
}

void RecordWriter::sync() {
  flush();
  part_->sync();
}

std::string RecordWriter::finish(const std::vector<ProvenanceEntry>& provenance,
                                 std::optional<std::int64_t> first_step) {
  flush();
  Content content = provenance_content(provenance);
  naming(part_path(path_), [&] {
    ContentFile part = put_together(part_->bytes());
    if (part.ignored_bytes > 0) {
      throw Failure("another program has changed the unfinished record, or the disk damaged it");
    }
    content.merge(with_spanning_events(std::move(part.content)));
    const auto step = record_from({FileKind::record, "", content}).step;
    if (first_step && (step.empty() || step.front() != *first_step)) {
      fail("it does not begin at step {}, as its run did", *first_step);
    }
  });
  std::string checksum = write_content(path_, FileKind::record, content, if_exists_);
  part_->remove();
  return checksum;
}

Record read_record(const std::filesystem::path& path) {
  return read_record_file(path).record;
}

RecordFile read_record_file(const std::filesystem::path& path) {
  ContentFile file = read_file(path, FileKind::record);
  Record record = naming(path, [&] { return record_from(file); });
  return {std::move(record), std::move(file.content), file.ignored_bytes};
}

}  // namespace rupture
