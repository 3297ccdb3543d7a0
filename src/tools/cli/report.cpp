#include "cli/report.hpp"

#include <fmt/core.h>

#include <variant>

#include "cli/text.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

std::string cell(const Column& column, std::size_t row) {
  if (!column.texts.empty()) return column.texts[row];
  const auto& value = column.values[row];
  return value ? fmt::format("{}", *value) : "";
}

void print_csv(const std::vector<Column>& series) {
  for (std::size_t c = 0; c < series.size(); ++c) {
    say("{}{}", c == 0 ? "" : ",", series[c].name);
  }
  say("\n");
  const std::size_t rows = series.empty() ? 0 : series.front().size();
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < series.size(); ++c) {
      say("{}{}", c == 0 ? "" : ",", cell(series[c], r));
    }
    say("\n");
  }
}

}  // namespace

Column column(std::string name, const std::vector<double>& values) {
  return {std::move(name), {values.begin(), values.end()}};
}

void add_format_options(po::options_description& options) {
  options.add_options()("json", "print one JSON object")("csv", "print the series as CSV");
}

void print(const Report& report, const po::variables_map& values) {
  const bool json = values.count("json") > 0, csv = values.count("csv") > 0;
  if (json && csv) throw UsageError("--json and --csv exclude each other: give one");
  if (json) {
    say("{}\n", json_text(report.json));
  } else if (csv) {
    print_csv(report.series);
  } else {
    say("{}", report.text);
  }
}

std::string json_text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json json_of(const Parameters& parameters, const ParameterInfo& info) {
  if (!choices(info).empty()) return parameter_text(parameters, info);
  return std::visit([&](auto member) { return Json(parameters.*member); }, info.member);
}

Json json_of(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json json_of(const std::vector<std::optional<double>>& values) {
  Json array = Json::array();
  for (const auto& value : values) array.push_back(json_of(value));
  return array;
}

std::string text_of(const std::optional<double>& value, double unit) {
  return value ? fmt::format("{:.4g}", *value / unit) : "-";
}

}  // namespace rupture::tools
