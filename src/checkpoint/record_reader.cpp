#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
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
void cut(Content& rows, const std::string& group, const char* steps, std::int64_t last) {
  const auto step = read_array<std::int64_t>(rows, steps, {rows_in(rows, steps)});
  const auto length =
      static_cast<std::uint64_t>(std::upper_bound(step.begin(), step.end(), last) - step.begin());
  for (auto& [path, dataset] : rows) {
    if (!path.starts_with(group) || step.empty()) continue;
    dataset.bytes.resize(dataset.bytes.size() / step.size() * length);
    dataset.shape[0] = length;
  }
}

template <class Array>
Array read_per_block(const Content& content, const char* path, std::uint64_t samples,
                     std::int64_t Nx) {
  using T = typename Array::Scalar;
  expect(content, path, DataTypeOf<T>::value, {samples, static_cast<std::uint64_t>(Nx)});
  Array array(static_cast<Eigen::Index>(samples), Nx);
  read_array_bytes(
      content, path, DataTypeOf<T>::value, {samples, static_cast<std::uint64_t>(Nx)},
      std::as_writable_bytes(std::span(array.data(), static_cast<std::size_t>(array.size()))));
  return array;
}

void read_series(const Content& content, Record& record) {
  const std::uint64_t n = rows_in(content, layout::kTime);
  const std::int64_t Nx = record.parameters.Nx;
  record.time = read_array<double>(content, layout::kTime, {n});
  record.step = read_array<std::int64_t>(content, layout::kStep, {n});
  const auto misplaced = std::adjacent_find(record.step.begin(), record.step.end(),
                                            [](auto a, auto b) { return a >= b; });
  if (misplaced != record.step.end()) {
    throw Failure(fmt::format("{} holds {} and then {}; expected ascending steps", layout::kStep,
                              misplaced[0], misplaced[1]));
  }
  record.F_T = read_array<double>(content, layout::kDrivingForce, {n});
  record.x_drive = read_array<double>(content, layout::kDrivePosition, {n});
  record.pinned = read_per_block<Record::Counts>(content, layout::kPinned, n, Nx);
  record.p = read_per_block<RowMajorArray>(content, layout::kNormalForce, n, Nx);
  record.tau = read_per_block<RowMajorArray>(content, layout::kFriction, n, Nx);
  record.u_x = read_per_block<RowMajorArray>(content, layout::kDisplacement, n, Nx);
}

std::vector<Rupture> read_ruptures(const Content& content, std::int64_t Nx) {
  const std::uint64_t n = rows_in(content, layout::kRuptureTime);
  const auto step = read_array<std::int64_t>(content, layout::kRuptureStep, {n});
  const auto time = read_array<double>(content, layout::kRuptureTime, {n});
  const auto block = read_array<std::int64_t>(content, layout::kRuptureBlock, {n});
  std::vector<Rupture> ruptures;
  for (std::size_t i = 0; i < n; ++i) {
    if (block[i] < 0 || block[i] >= Nx) {
      throw Failure(fmt::format("{} holds {} at index {}; expected a block from 0 to {}",
                                layout::kRuptureBlock, block[i], i, Nx - 1));
    }
    ruptures.push_back({step[i], time[i], block[i]});
  }
  return ruptures;
}

void refuse_unknown(const Content& content) {
  const std::set<std::string> known = {
      layout::kTime,        layout::kStep,        layout::kDrivingForce, layout::kDrivePosition,
      layout::kPinned,      layout::kNormalForce, layout::kFriction,     layout::kDisplacement,
      layout::kRuptureStep, layout::kRuptureTime, layout::kRuptureBlock};
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
  cut(rows, layout::kSeriesGroup, layout::kStep, step);
  cut(rows, layout::kRupturesGroup, layout::kRuptureStep, step);
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
