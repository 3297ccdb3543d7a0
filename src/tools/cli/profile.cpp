#include "cli/profile.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "cli/text.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/user_text.hpp"

namespace rupture::tools {
namespace {

constexpr std::array<std::string_view, 2> kOfPrepare = {"tau-bar", "sigma-bar"};

struct Column {
  std::string name, unit;  ///< as in the heading
};

struct Row {
  std::string where;  ///< "profile.csv:3: "
  double x = 0;       ///< [m]
  std::vector<std::string> cells;
};

struct Table {
  std::vector<Column> columns;  ///< x is the first
  std::vector<Row> rows;
};

/// The number of a cell of a column with `unit` in the unit of SI. Throws UsageError.
double number_in(const std::string& cell, const std::string& unit, std::string_view in) {
  const auto text = in_unit(cell + unit, in);
  const double number = text ? std::strtod(text->c_str(), nullptr) : std::nan("");
  if (std::isfinite(number)) return number;
  throw UsageError("'{}' is not a number; write decimals with a point", cell);
}

/// "junctions.t_R [ms]". Throws UsageError unless it is something that may vary along x.
Column column_of(const std::string& heading) {
  const auto bracket = heading.find(" [");
  Column column = {heading.substr(0, bracket), ""};
  if (bracket != std::string::npos && heading.ends_with(']')) {
    column.unit = heading.substr(bracket + 2, heading.size() - bracket - 3);
  }
  if (column.unit == "1") column.unit.clear();
  std::string_view unit = column.name == "x" ? "m" : "1";
  if (column.name != "x" && std::ranges::count(kOfPrepare, column.name) == 0) {
    const ParameterInfo& info = find_parameter(column.name);
    if (!may_vary_along_x(info)) throw UsageError("{} cannot vary along x", info.name);
    unit = info.unit;
  }
  if (in_unit("1" + column.unit, unit)) return column;
  throw UsageError("{} cannot be in '{}'{}", column.name, column.unit, units_taken(unit));
}

/// Throws UsageError unless a parameter can have this value.
void check(const Column& column, const std::string& cell) {
  if (std::ranges::count(kOfPrepare, column.name) > 0) {
    number_in(cell, column.unit, "1");
    return;
  }
  Parameters any;
  set_parameter(any, column.name, cell + column.unit);
}

void add_heading(const std::vector<std::string>& cells, Table& table) {
  for (const auto& heading : cells) table.columns.push_back(column_of(heading));
  if (table.columns.front().name == "x" && table.columns.size() > 1) return;
  throw UsageError("the first column must be x, and one must follow (got '{}')",
                   fmt::join(cells, ","));
}

void add_row(std::vector<std::string> cells, const std::string& where, Table& table) {
  const auto& columns = table.columns;
  if (cells.size() != columns.size()) {
    throw UsageError("{} values, but the heading names {}; write decimals with a point",
                     cells.size(), columns.size());
  }
  const double x = number_in(cells.front(), columns.front().unit, "m");
  for (std::size_t c = 1; c < columns.size(); ++c) check(columns[c], cells[c]);
  if (!table.rows.empty() && x < table.rows.back().x) {
    throw UsageError("x falls: sort the rows by x");
  }
  table.rows.push_back({where, x, std::move(cells)});
}

Table read_table(const std::string& path) {
  std::istringstream lines(text_of_file(path, "profile", "CSV table"));
  Table table;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty()) continue;
    const std::string where = fmt::format("{}:{}: ", path, number);
    const auto cells = split(line + ",", ',');  // a last empty cell counts
    try {
      table.columns.empty() ? add_heading(cells, table) : add_row(cells, where, table);
    } catch (const UsageError& error) {
      throw UsageError(where + error.what());
    }
  }
  if (table.rows.empty()) throw UsageError("{}: a profile needs a heading and a row", path);
  return table;
}

/// Linear between rows; at a step, where two rows have one x, the later row counts.
std::string value_at(const Table& table, std::size_t column, std::string_view unit, double x,
                     double rounding) {
  const auto& rows = table.rows;
  const auto after = std::ranges::upper_bound(rows, x + rounding, {}, &Row::x);
  const Row& left = after == rows.begin() ? rows.front() : *(after - 1);
  const Row& right = after == rows.end() ? rows.back() : *after;
  const double part =
      right.x > left.x ? std::clamp((x - left.x) / (right.x - left.x), 0.0, 1.0) : 0;
  const auto number = [&](const Row& row) {
    return number_in(row.cells[column], table.columns[column].unit, unit);
  };
  if (const auto& nearest = part < 0.5 ? left : right; !in_unit(nearest.cells[column], "1")) {
    return nearest.cells[column];  // a word
  }
  return fmt::format("{}", number(left) + part * (number(right) - number(left)));
}

/// As set_parameter() takes them.
std::string values_of(const Table& table, std::size_t column, std::string_view unit,
                      const Parameters& p) {
  const double rounding = 1e-6 * block_spacing(p);
  for (const Row& row : table.rows) {
    if (row.x >= -rounding && row.x <= p.L + rounding) continue;
    throw UsageError("{}x = {:g} m is outside the slider, 0 to {:g} m", row.where, row.x, p.L);
  }
  std::vector<std::string> values;
  for (const double x : block_positions(p)) {
    values.push_back(value_at(table, column, unit, x, rounding));
  }
  return fmt::format("{}", fmt::join(values, ","));
}

}  // namespace

void add_profile_option(po::options_description& options) {
  options.add_options()("profile", input_file("table of properties along x"),
                        "CSV table of properties along the interface: a column x, and one for each "
                        "parameter that varies, such as junctions.mu_s; units in the heading");
}

void apply(const Parsed& parsed, Parameters& p) {
  ParameterChanges plain, parts;
  for (const auto& change : parsed.parameters) {
    (is_along_x(change.value) ? parts : plain).push_back(change);
  }
  set_parameters(plain, p);
  if (parsed.values.count("profile") > 0) {
    const Table table = read_table(parsed.values["profile"].as<std::string>());
    for (std::size_t c = 1; c < table.columns.size(); ++c) {
      const std::string& name = table.columns[c].name;
      if (std::ranges::count(kOfPrepare, name) > 0) {
        if (parsed.values.count(kOfPrepare.back().data()) > 0) continue;  // it has a default there
        throw UsageError("{} is for prepare: leave the column out", name);
      }
      set_parameter(p, name, values_of(table, c, find_parameter(name).unit, p));
    }
  }
  set_parameters(parts, p);
}

AlongX<double> along_x(const Parsed& parsed, const Parameters& p, const std::string& option) {
  const std::string name = "--" + option;
  const ParameterInfo info = {.name = name,
                              .symbol = "",
                              .unit = "1",
                              .member = &Parameters::load,
                              .valid = {-1e9, 1e9},
                              .help = ""};
  const bool given = parsed.values.count(option) > 0 && !parsed.values[option].defaulted();
  if (parsed.values.count("profile") > 0) {
    const Table table = read_table(parsed.values["profile"].as<std::string>());
    const auto found = std::ranges::find(table.columns, option, &Column::name);
    if (found != table.columns.end()) {
      if (given) throw UsageError("the profile has {}: leave --{} out", option, option);
      return values_along_x(
          p, info,
          values_of(table, static_cast<std::size_t>(found - table.columns.begin()), "1", p));
    }
  }
  if (parsed.values.count(option) == 0) {
    throw UsageError("--{} is missing: give it, or a --profile with this column", option);
  }
  return values_along_x(p, info, parsed.values[option].as<std::string>());
}

}  // namespace rupture::tools
