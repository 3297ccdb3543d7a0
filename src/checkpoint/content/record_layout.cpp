#include "checkpoint/content/record_layout.hpp"

#include <algorithm>

#include "checkpoint/content/layout.hpp"
namespace rupture {
namespace {

namespace layout = record_layout;

// The scales along which a dataset goes, slowest dimension first: time, time and x.
std::vector<std::string> axes_of(const std::string& path, const Shape& shape) {
  const std::string group = path.substr(0, path.rfind('/') + 1);
  for (const char* scale : {"time", "z", "x", "levels"}) {
    if (path == group + scale) return {path};
  }
  if (shape.size() == 1) return {group + "time"};
  if (shape.size() == 2) return {group + "time", group + "x"};
  return {group + "time", group + "z", group + "x"};
}

}  // namespace

Content record_positions(const Parameters& parameters, const Content& record) {
  Content positions;
  layout::for_each(layout::kScales, [&](const layout::Scale& row) {
    const std::string path = row.path;
    if (!row.of || !record.contains(path.substr(0, path.rfind('/')) + "/time")) return;
    const std::vector<double> values = row.of(parameters);
    positions[path] = make_array(std::span(values), {values.size()}, row.unit);
  });
  return positions;
}

Labels record_labels(const Content& record) {
  Labels labels;
  const auto is_there = [&](const std::string& path) { return record.contains(path); };
  layout::for_each_dataset([&](const auto& row) {
    if (!is_there(row.path)) return;
    auto axes = axes_of(row.path, record.at(row.path).shape);
    if (!std::all_of(axes.begin(), axes.end(), is_there)) axes.clear();  // reading will complain
    labels[row.path] = {row.long_name, std::move(axes)};
  });
  return labels;
}

DatasetInfos record_datasets() {
  DatasetInfos all;
  const auto add = [&](const char* rows, const auto& table, const auto& entry) {
    layout::for_each(table, [&](const auto& row) {
      const auto& values = entry.*row.member;
      const std::size_t dimensions = layout::shape_of(values, 0, {}).size();
      const char* blocks = dimensions == 1 ? "" : dimensions == 2 ? "[Nx]" : "[Nz][Nx]";
      all.push_back({row.path, type_name(layout::type_of(values)),
                     fmt::format("{}{}", rows, blocks), row.unit});
    });
  };
  add("[n]", layout::kSeries, Sample{});
  add("[r]", layout::kRuptures, Rupture{});
  add("[c]", layout::kCrossings, Rupture{});
  add("[m]", layout::kFields, FieldSample{});
  layout::for_each(layout::kScales, [&](const layout::Scale& row) {
    const std::string path = row.path;
    const char* length = path.ends_with("/z") ? "[Nz]" : path.ends_with("/x") ? "[Nx]" : "[k]";
    all.push_back({path, "float64", length, row.unit});
  });
  return all;
}

}  // namespace rupture
