#include "checkpoint/content/layout.hpp"

#include <algorithm>

namespace rupture {

std::vector<DatasetInfo> datasets_of(FileKind kind) {
  DatasetInfos all;
  const auto add = [&](const DatasetInfos& some) {
    all.insert(all.end(), some.begin(), some.end());
  };
  add(parameter_datasets());
  add(provenance_datasets());
  add(run_datasets(kind));
  add(kind == FileKind::checkpoint ? state_datasets() : record_datasets());
  std::ranges::sort(all, {}, &DatasetInfo::path);
  return all;
}

}  // namespace rupture
