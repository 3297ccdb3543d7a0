#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <type_traits>
#include <utility>

#include "context.hpp"
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

// Cuts the datasets of a group to the rows whose step is at most `last`.
void cut(Content& rows, const std::string& group, std::int64_t last) {
  const std::string steps = group + "step";
  const auto step = read_array<std::int64_t>(rows, steps, {rows_in(rows, steps)});
  const auto length =
      static_cast<std::uint64_t>(std::upper_bound(step.begin(), step.end(), last) - step.begin());
  for (auto& [path, dataset] : rows) {
    if (!path.starts_with(group) || step.empty()) continue;
    dataset.bytes.resize(dataset.bytes.size() / step.size() * length);
    dataset.shape[0] = length;
  }
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

void read_series(const Content& content, Record& record) {
  const std::uint64_t n = rows_in(content, layout::kSeriesGroup + std::string("time"));
  layout::for_each(layout::kSeries, [&](const auto& row) {
    read(content, row.path, n, record.parameters.Nx, record.*row.in_record);
  });
  const auto misplaced = std::adjacent_find(record.step.begin(), record.step.end(),
                                            [](auto a, auto b) { return a >= b; });
  if (misplaced != record.step.end()) {
    throw Failure(fmt::format("{}step holds {} and then {}; expected ascending steps",
                              layout::kSeriesGroup, misplaced[0], misplaced[1]));
  }
}

std::vector<Rupture> read_ruptures(const Content& content, std::int64_t Nx) {
  std::vector<Rupture> ruptures;
  const std::uint64_t n = rows_in(content, layout::kRupturesGroup + std::string("time"));
  layout::for_each(layout::kRuptures, [&](const auto& row) {
    using T = std::remove_reference_t<decltype(ruptures[0].*row.member)>;
    const auto values = read_array<T>(content, row.path, {n});
    ruptures.resize(n);
    for (std::size_t i = 0; i < n; ++i) ruptures[i].*row.member = values[i];
  });
  for (std::size_t i = 0; i < n; ++i) {
    if (const std::int64_t block = ruptures[i].block; block < 0 || block >= Nx) {
      throw Failure(fmt::format("{}block holds {} at index {}; expected a block from 0 to {}",
                                layout::kRupturesGroup, block, i, Nx - 1));
    }
  }
  return ruptures;
}

void refuse_unknown(const Content& content) {
  std::set<std::string> known;
  const auto add = [&](const auto& row) { known.insert(row.path); };
  layout::for_each(layout::kSeries, add);
  layout::for_each(layout::kRuptures, add);
  for (const auto& [path, dataset] : content) {
    const bool elsewhere = path.starts_with("/parameters/") || path.starts_with("/provenance/");
    if (!elsewhere && !known.contains(path)) {
      throw Failure(fmt::format("{} is not part of a record: use a newer rupture", path));
    }
  }
}

Record record_from_content(const Content& content, Complete complete) {
  refuse_unknown(content);
  Record record;
  record.complete = complete;
  record.parameters = read_parameters(content);
  record.provenance = read_provenance(content);
  read_series(content, record);
  record.ruptures = read_ruptures(content, record.parameters.Nx);
  return record;
}

}  // namespace

Record record_from(const ContentFile& file) {
  return record_from_content(file.content,
                             file.kind == FileKind::open_record ? Complete::no : Complete::yes);
}

Content rows_until(const Content& record, std::int64_t step) {
  Content rows;
  std::copy_if(record.begin(), record.end(), std::inserter(rows, rows.end()),
               [](const auto& entry) {
                 return entry.first.starts_with(layout::kSeriesGroup) ||
                        entry.first.starts_with(layout::kRupturesGroup);
               });
  cut(rows, layout::kSeriesGroup, step);
  cut(rows, layout::kRupturesGroup, step);
  return rows;
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
  return {std::move(record), std::move(file.content)};
}

}  // namespace rupture
