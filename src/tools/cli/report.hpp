// A report in three forms: text for people, one JSON object, or CSV columns.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "rupture/model/parameters.hpp"

namespace rupture::tools {

using Json = nlohmann::ordered_json;

/// A column of a table; its name carries the unit, e.g. "x [m]".
struct Column {
  std::string name;
  std::vector<std::optional<double>> values;
  std::vector<std::string> texts = {};  ///< in place of `values` where they are no numbers

  std::size_t size() const { return values.size() + texts.size(); }
};

Column column(std::string name, const std::vector<double>& values);

/// Everything a command has to say.
struct Report {  // NOLINT(bugprone-exception-escape): Json's move, which throws nothing
  std::string text;
  Json json;
  std::vector<Column> series;  ///< what --csv prints: columns of equal length
};

/// Adds --json and --csv.
void add_format_options(po::options_description& options);

/// Prints the form that was asked for to standard output. Throws UsageError for both forms at once.
void print(const Report& report, const po::variables_map& values);

/// The JSON in one line. Bytes that are no UTF-8, as file names may hold, become U+FFFD.
std::string json_text(const Json& json);

/// The value of a parameter: a number, or the word that was chosen.
Json json_of(const Parameters& parameters, const ParameterInfo& info);

/// null where there is no value.
Json json_of(const std::optional<double>& value);
Json json_of(const std::vector<std::optional<double>>& values);

/// "-" where there is no value.
std::string text_of(const std::optional<double>& value, double unit = 1.0);

}  // namespace rupture::tools
