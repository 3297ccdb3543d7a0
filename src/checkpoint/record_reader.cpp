// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <type_traits>
#include <utility>

#include "context.hpp"
#include "record_labels.hpp"
#include "record_layout.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/model/error.hpp"

namespace rupture {
namespace {

namespace layout = record_layout;

// Rows that a dataset has; 0 if it is missing or no array, which reading it will complain about.
std::uint64_t rows_in(const Content& content, const std::string& path) {
  const auto found = content.find(path);
  return found == content.end() || found->second.shape.empty() ? 0 : found->second.shape[0];
}

// Copies the rows of a table whose step is at most `last`.
template <class Table>
void copy_rows(const Content& from, const std::string& group, const Table& table, std::int64_t last,
               Content& to) {
  const std::string steps = group + "step";
  const auto step = read_array<std::int64_t>(from, steps, {rows_in(from, steps)});
  const auto length =
      static_cast<std::uint64_t>(std::upper_bound(step.begin(), step.end(), last) - step.begin());
  layout::for_each(table, [&](const auto& row) {
    Dataset& dataset = to[row.path] = from.at(row.path);
    if (step.empty()) return;
    dataset.bytes.resize(dataset.bytes.size() / step.size() * length);
    dataset.shape[0] = length;
  });
}

template <class T>
void read(const Content& content, const char* path, std::uint64_t rows, std::int64_t,
          std::vector<T>& values) {
  values = read_array<T>(content, path, {rows});
}

template <class Array>
void read(const Content& content, const char* path, std::uint64_t rows, std::int64_t Nx,
          Array& values) {
  constexpr DataType type = DataTypeOf<typename Array::Scalar>::value;
  const Shape shape = {rows, static_cast<std::uint64_t>(Nx)};
  expect(content, path, type, shape);
  values.resize(static_cast<Eigen::Index>(rows), Nx);
  read_array_bytes(
      content, path, type, shape,
      std::as_writable_bytes(std::span(values.data(), static_cast<std::size_t>(values.size()))));
}

void check_ascending(const char* group, const std::vector<std::int64_t>& step) {
  const auto misplaced =
      std::adjacent_find(step.begin(), step.end(), [](auto a, auto b) { return a >= b; });
  if (misplaced == step.end()) return;
  throw Failure(fmt::format("{}step holds {} and then {}; expected ascending steps", group,
                            misplaced[0], misplaced[1]));
}

void read_series(const Content& content, Record& record) {
  const std::uint64_t n = rows_in(content, layout::kSeriesGroup + std::string("time"));
  layout::for_each(layout::kSeries, [&](const auto& row) {
    read(content, row.path, n, record.parameters.Nx, record.*row.in_record);
  });
  check_ascending(layout::kSeriesGroup, record.step);
}

template <class Table>
std::vector<Rupture> read_ruptures(const Content& content, const std::string& group,
                                   const Table& table, std::int64_t Nx) {
  std::vector<Rupture> ruptures(rows_in(content, group + "time"));
  layout::for_each(table, [&](const auto& row) {
    using T = std::remove_reference_t<decltype(ruptures[0].*row.member)>;
    const auto values = read_array<T>(content, row.path, {ruptures.size()});
    for (std::size_t i = 0; i < ruptures.size(); ++i) ruptures[i].*row.member = values[i];
  });
  for (std::size_t i = 0; i < ruptures.size(); ++i) {
    if (const std::int64_t block = ruptures[i].block; block < 0 || block >= Nx) {
      throw Failure(fmt::format("{}block holds {} at index {}; expected a block from 0 to {}",
                                group, block, i, Nx - 1));
    }
  }
  return ruptures;
}

// Whether the record holds a part that it may lack; one is there or not as a whole.
bool has(const Content& content, const char* group) {
  return std::any_of(content.begin(), content.end(),
                     [&](const auto& entry) { return entry.first.starts_with(group); });
}

void read_crossings(const Content& content, Record& record) {
  if (!has(content, layout::kCrossingsGroup)) return;
  const char* const levels = layout::kCrossingLevels;
  record.crossing_levels = read_array<double>(content, levels, {rows_in(content, levels)});
  record.crossings =
      read_ruptures(content, layout::kCrossingsGroup, layout::kCrossings, record.parameters.Nx);
}

// Their values stay where they are: they are for other programs.
void read_fields(const Content& content, Record& record) {
  if (!has(content, layout::kFieldsGroup)) return;
  const std::string steps = layout::kFieldsGroup + std::string("step");
  const std::uint64_t n = rows_in(content, steps);
  const FieldSample empty;
  layout::for_each(layout::kFields, [&](const auto& row) {
    const auto& entry = empty.*row.member;
    expect(content, row.path, layout::type_of(entry),
           layout::shape_of(entry, n, record.parameters));
  });
  record.fields = Fields::record;
  record.field_step = read_array<std::int64_t>(content, steps, {n});
  check_ascending(layout::kFieldsGroup, record.field_step);
}

void refuse_unknown(const Content& content) {
  std::set<std::string> known = {layout::kCrossingLevels};
  const auto add = [&](const auto& row) { known.insert(row.path); };
  layout::for_each(layout::kSeries, add);
  layout::for_each(layout::kRuptures, add);
  layout::for_each(layout::kCrossings, add);
  layout::for_each(layout::kFields, add);
  layout::for_each(layout::kPositions, add);
  for (const auto& [path, dataset] : content) {
    const bool elsewhere = path.starts_with("/parameters/") || path.starts_with("/provenance/");
    if (!elsewhere && !known.contains(path)) {
      throw Failure(
          fmt::format("{} is not part of a record: use a newer rupture, or remove it if another "
                      "program added it",
                      path));
    }
  }
}

Record record_from_content(const Content& content, Complete complete) {
  refuse_unknown(content);
  Record record;
  record.complete = complete;
  record.parameters = read_parameters(content);
  expect_as_written(content, record_positions(record.parameters, content));
  record.provenance = read_provenance(content);
  read_series(content, record);
  record.ruptures =
      read_ruptures(content, layout::kRupturesGroup, layout::kRuptures, record.parameters.Nx);
  read_crossings(content, record);
  read_fields(content, record);
  return record;
}

}  // namespace

Record record_from(const ContentFile& file) {
  return record_from_content(file.content,
                             file.kind == FileKind::open_record ? Complete::no : Complete::yes);
}

Content rows_until(const Content& record, std::int64_t step) {
  Content rows;
  copy_rows(record, layout::kSeriesGroup, layout::kSeries, step, rows);
  copy_rows(record, layout::kRupturesGroup, layout::kRuptures, step, rows);
  if (has(record, layout::kFieldsGroup)) {
    copy_rows(record, layout::kFieldsGroup, layout::kFields, step, rows);
  }
  if (has(record, layout::kCrossingsGroup)) {
    copy_rows(record, layout::kCrossingsGroup, layout::kCrossings, step, rows);
  }
  return rows;
}

Content finished_content(const RecordFile& part, const std::vector<ProvenanceEntry>& provenance) {
  Content whole = provenance_content(provenance);
  whole.merge(rows_until(part.content, part.record.step.back()));
  whole.merge(Content(part.content));  // what has no rows
  return whole;
}

std::vector<Rupture> ruptures_below(const Record& record, double fraction) {
  if (fraction == kRupturedFraction) return record.ruptures;
  const auto& levels = record.crossing_levels;
  if (std::find(levels.begin(), levels.end(), fraction) == levels.end()) {
    std::vector<double> held = levels;
    held.push_back(kRupturedFraction);
    throw Failure(fmt::format(
        "the record does not tell when blocks fell below a pinned fraction of {}, only of {}: "
        "record it with --crossings {}",
        fraction, fmt::join(held, ", "), fraction));
  }
  std::vector<Rupture> ruptures;
  std::copy_if(record.crossings.begin(), record.crossings.end(), std::back_inserter(ruptures),
               [&](const Rupture& crossing) { return crossing.pinned_below == fraction; });
  return ruptures;
}

Record read_record(const std::filesystem::path& path) {
  return read_record_file(path).record;
}

RecordFile read_record_file(const std::filesystem::path& path) {
  if (identify(path) == FileKind::checkpoint) {
    throw Failure(fmt::format("{} is a checkpoint; expected a record", path.string()));
  }
  ContentFile file = read_file(path);
  Record record = naming(path, [&] { return record_from(file); });
  return {std::move(record), std::move(file.content), file.ignored_bytes};
}

}  // namespace rupture
