#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "atomic_write.hpp"
#include "context.hpp"
#include "part_file.hpp"
#include "record_layout.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"

namespace rupture {
namespace {

namespace layout = record_layout;

template <class T>
std::span<const T> values_of(const T& value) {
  return {&value, 1};
}
template <class T>
std::span<const T> values_of(const std::vector<T>& values) {
  return values;
}

// A dataset without rows.
template <class T>
Dataset no_rows(const T& entry, const char* unit, const Parameters& parameters) {
  return {unit, layout::type_of(entry), layout::shape_of(entry, 0, parameters), {}};
}

void check_count_range(const Parameters& parameters) {
  constexpr std::int64_t most = std::numeric_limits<std::uint16_t>::max();
  if (springs_per_block(parameters) > most) {
    throw UsageError(
        fmt::format("junctions.N_s = {} is too large for a record, which counts up to "
                    "{} junctions per block",
                    parameters.N_s, most));
  }
}

// Throws Failure unless this is a record, which begins where its run did.
void check_complete(const Content& content, std::optional<std::int64_t> first_step) {
  const auto step = record_from({FileKind::record, "", "", content}).step;
  if (!first_step || (!step.empty() && step.front() == *first_step)) return;
  fail("it does not begin at step {}, as its run did", *first_step);
}

// Everything a record holds: its rows so far and what stays as it is.
Content first_piece(const Parameters& parameters, const std::vector<ProvenanceEntry>& provenance,
                    Content rows) {
  rows.merge(parameters_content(parameters));
  rows.merge(provenance_content(provenance));
  rows.merge(record_positions(parameters, rows));
  return rows;
}

}  // namespace

// Rows that were appended since the last flush.
class RecordWriter::Buffers {
 public:
  Buffers(const Parameters& parameters, std::size_t flush_every, const RecordParts& parts)
      : flush_every_(flush_every) {
    const auto add = [&](const char* path, const char* unit, const auto& entry) {
      rows_[path] = no_rows(entry, unit, parameters);
    };
    const auto of_rupture = [&](const auto& row) {
      add(row.path, row.unit, Rupture{}.*row.member);
    };
    layout::for_each(layout::kSeries,
                     [&](const auto& row) { add(row.path, row.unit, Sample{}.*row.in_sample); });
    layout::for_each(layout::kRuptures, of_rupture);
    if (!parts.crossing_levels.empty()) layout::for_each(layout::kCrossings, of_rupture);
    if (parts.fields == Fields::omit) return;
    layout::for_each(layout::kFields,
                     [&](const auto& row) { add(row.path, row.unit, FieldSample{}.*row.member); });
  }

  void add(const Sample& sample) {
    layout::for_each(layout::kSeries, [&](const auto& row) {
      check_size(row.path, values_of(sample.*row.in_sample).size());
    });
    layout::for_each(layout::kSeries, [&](const auto& row) {
      append(row.path, std::as_bytes(values_of(sample.*row.in_sample)));
    });
    ++samples_;
  }

  void add(const Rupture& rupture) {
    const auto append_value = [&](const auto& row) {
      append(row.path, std::as_bytes(values_of(rupture.*row.member)));
    };
    if (rupture.pinned_below == kRupturedFraction) {
      layout::for_each(layout::kRuptures, append_value);
    } else {
      layout::for_each(layout::kCrossings, append_value);
    }
    ++ruptures_;
  }

  void add(const FieldSample& sample) {
    layout::for_each(layout::kFields, [&](const auto& row) {
      check_size(row.path, values_of(sample.*row.member).size());
    });
    layout::for_each(layout::kFields, [&](const auto& row) {
      const auto values = std::as_bytes(values_of(sample.*row.member));
      append(row.path, values);
      field_bytes_ += values.size();
    });
  }

  bool empty() const { return samples_ + ruptures_ + field_bytes_ == 0; }
  bool full() const {
    return std::max(samples_, ruptures_) >= flush_every_ || field_bytes_ >= kFlushBytes;
  }

  const Content& content() const { return rows_; }

  void clear() {
    for (auto& [path, dataset] : rows_) {
      dataset.bytes.clear();
      dataset.shape[0] = 0;
    }
    samples_ = ruptures_ = field_bytes_ = 0;
  }

 private:
  void check_size(const std::string& path, std::size_t size) const {
    const Shape& shape = rows_.at(path).shape;
    const std::uint64_t expected = element_count({shape.begin() + 1, shape.end()});
    if (size == expected) return;
    fail("a sample has {} values of {}; expected {} = {}", size, path.substr(path.rfind('/') + 1),
         shape.size() > 2 ? "Nx Nz" : "Nx", expected);
  }

  void append(const char* path, std::span<const std::byte> row) {
    Dataset& dataset = rows_.at(path);
    dataset.bytes.insert(dataset.bytes.end(), row.begin(), row.end());
    ++dataset.shape[0];
  }

  std::size_t flush_every_;
  std::size_t samples_ = 0, ruptures_ = 0, field_bytes_ = 0;
  Content rows_;
};

std::filesystem::path part_path(const std::filesystem::path& path) {
  return path.string() + ".part";
}

bool is_being_written(const std::filesystem::path& part) {
  return is_locked(part);
}

void check_record(const std::filesystem::path& path, const Parameters& parameters,
                  IfExists if_exists) {
  check_count_range(parameters);
  check_output(path, if_exists);
  check_output(part_path(path), if_exists);
}

RecordWriter::RecordWriter(std::filesystem::path path, const Parameters& parameters,
                           const std::vector<ProvenanceEntry>& provenance, IfExists if_exists,
                           Content rows_before, std::size_t flush_every, const RecordParts& parts)
    : path_(std::move(path)), if_exists_(if_exists) {
  check_record(path_, parameters, if_exists);
  buffers_ = std::make_unique<Buffers>(parameters, flush_every, parts);
  if (const auto& levels = parts.crossing_levels; !levels.empty()) {
    rows_before[layout::kCrossingLevels] = make_array(std::span(levels), {levels.size()}, "1");
  }
  rows_before.merge(recorded_run_content(parts.run));
  rows_before.merge(Content(buffers_->content()));  // all datasets are there, even if without rows
  part_ = std::make_unique<PartFile>(
      part_path(path_), first_piece(parameters, provenance, std::move(rows_before)), if_exists);
}

RecordWriter::~RecordWriter() = default;

void RecordWriter::append(const Sample& sample) {
  buffers_->add(sample);
  if (buffers_->full()) flush();
}

void RecordWriter::append(std::span<const Rupture> ruptures) {
  for (const Rupture& rupture : ruptures) buffers_->add(rupture);
  if (buffers_->full()) flush();
}

void RecordWriter::append(const FieldSample& sample) {
  buffers_->add(sample);
  if (buffers_->full()) flush();
}

void RecordWriter::flush() {
  if (buffers_->empty()) return;
  Content rows = buffers_->content();
  buffers_->clear();
  std::erase_if(rows, [](const auto& entry) { return entry.second.bytes.empty(); });
  part_->append(rows);
}

void RecordWriter::sync() {
  flush();
  part_->sync();
}

std::string RecordWriter::finish(const std::vector<ProvenanceEntry>& provenance, SumFile sum,
                                 std::optional<std::int64_t> first_step) {
  flush();
  Content content = provenance_content(provenance);
  content.merge(part_->content());
  naming(part_path(path_), [&] { check_complete(content, first_step); });
  std::string checksum = write_content(path_, FileKind::record, content, if_exists_, sum);
  part_->remove();
  return checksum;
}

}  // namespace rupture
