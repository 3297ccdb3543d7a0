// The table of datasets, of which each part stands where it is written and read.
#pragma once

#include "rupture/checkpoint/layout.hpp"

namespace rupture {

/// A dataset with elements, or one value, of type T.
template <class T>
struct Row {
  const char* path;
  const char* unit;
  const char* lengths = "";  ///< as in DatasetInfo

  operator DatasetInfo() const { return {path, type_name(kDataTypeOf<T>), lengths, unit}; }
};

template <class T>
void put(Content& content, const Row<T>& row, T value) {
  content[row.path] = make_scalar(value, row.unit);
}

template <class T>
T value_of(const Content& content, const Row<T>& row) {
  return read_scalar<T>(content, row.path);
}

using DatasetInfos = std::vector<DatasetInfo>;
DatasetInfos parameter_datasets();
DatasetInfos provenance_datasets();
DatasetInfos state_datasets();
DatasetInfos run_datasets(FileKind kind);
DatasetInfos record_datasets();

}  // namespace rupture
