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
constexpr std::size_t kLargest = 10'000'000;  // bytes of a table

using Column = Profile::Column;
using Row = Profile::Row;

/// The number of a cell of a column with `unit` in the unit of SI. Throws UsageError.
double number_of(const std::string& cell, const std::string& unit, std::string_view in) {
  const auto number = number_in(cell + unit, in);
  if (number && std::isfinite(*number)) return *number;
  throw UsageError("'{}' is not a number: write decimals with a point, and units in the heading",
                   cell);
}

/// The next line; it may end as on Unix, Windows or an old Macintosh.
bool next_line(std::istream& text, std::string& line) {
  line.clear();
  for (char c = 0; text.get(c);) {
    if (c == '\r' && text.peek() == '\n') text.get(c);
    if (c == '\r' || c == '\n') return true;
    line += c;
  }
  return !line.empty();
}

std::string trimmed(const std::string& text) {
  const auto first = std::min(text.find_first_not_of(' '), text.size());
  return text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

/// The cells of a line of a table (docs/runs.md), without blanks around them and empty ones at the
/// end; none of a comment. As table_in() of recipes/sweeps/values.py.
std::vector<std::string> cells_of(std::string line) {
  std::ranges::replace(line, '\t', ' ');
  std::vector<std::string> cells = {""};
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    std::string& cell = cells.back();
    if (line[i] == '"' && is_quoted && line.substr(i + 1, 1) == "\"") {
      cell += line[i++];
    } else if (line[i] == '"' && (is_quoted || cell.empty())) {
      is_quoted = !is_quoted;
    } else if (line[i] == ',' && !is_quoted) {
      cells.emplace_back();
    } else if (line[i] != ' ' || is_quoted || !cell.empty()) {
      cell += line[i];
    }
  }
  std::ranges::transform(cells, cells.begin(), trimmed);
  if (cells.front().starts_with('#')) return {};
  while (!cells.empty() && cells.back().empty()) cells.pop_back();
  return cells;
}

/// "junctions.t_R [ms]". Throws UsageError unless it is something that may vary along x.
Column column_of(const std::string& heading) {
  const auto bracket = heading.find('[');
  Column column = {trimmed(heading.substr(0, bracket)), ""};
  if (column.name.empty()) {
    throw UsageError("each column needs a heading: write the table without row numbers");
  }
  if (bracket != std::string::npos) {
    if (!heading.ends_with(']')) {
      throw UsageError("'{}' is not a heading: write NAME or NAME [UNIT]", heading);
    }
    column.unit = trimmed(heading.substr(bracket + 1, heading.size() - bracket - 2));
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
  bool is_number = true;
  if (std::ranges::count(kOfPrepare, column.name) == 0) {
    Parameters any;
    set_parameter(any, column.name, cell + column.unit);
    is_number = find_parameter(column.name).valid.words.empty();
  }
  if (is_number) number_of(cell, "", "1");
}

}  // namespace

void add_profile_option(po::options_description& options) {
  options.add_options()("profile", input_file("table of properties along x"),
                        "CSV table of properties along the interface: a column x, and one for each "
                        "parameter that varies, such as junctions.mu_s, or in prepare also tau-bar "
                        "and sigma-bar; units in the heading; up to 10 MB");
}

Profile::Profile(const Parsed& parsed) : parsed_(parsed) {
  if (parsed.values.count("profile") == 0) return;
  path_ = parsed.values["profile"].as<std::string>();
  std::istringstream text(text_of_file(path_, "profile", "CSV table", kLargest));
  std::string line;
  for (int number = 1; next_line(text, line); ++number) {
    auto cells = cells_of(line);
    if (cells.empty()) continue;
    try {
      if (columns_.empty()) {
        read_headings(cells);
      } else {
        read_row(std::move(cells), number);
      }
    } catch (const UsageError& error) {
      throw UsageError("{}:{}: {}", path_, number, error.what());
    }
  }
  if (rows_.empty()) throw UsageError("{}: a profile needs a heading and a row", path_);
}

bool Profile::has(std::string_view column) const {
  return std::ranges::count(columns_, column, &Column::name) > 0;
}

void Profile::read_headings(const std::vector<std::string>& cells) {
  for (const auto& heading : cells) {
    const Column column = column_of(heading);
    if (has(column.name)) throw UsageError("{} has two columns", column.name);
    columns_.push_back(column);
  }
  if (columns_.front().name == "x" && columns_.size() > 1) return;
  throw UsageError("the first column must be x, and one must follow (got '{}')",
                   fmt::join(cells, ","));
}

void Profile::read_row(std::vector<std::string> cells, int line) {
  if (cells.size() > columns_.size()) {
    throw UsageError("{} values, but the heading names {}; write decimals with a point",
                     cells.size(), columns_.size());
  }
  cells.resize(columns_.size());
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    if (cells[c].empty()) throw UsageError("{} has no value", columns_[c].name);
  }
  const double x = number_of(cells.front(), columns_.front().unit, "m");
  for (std::size_t c = 1; c < columns_.size(); ++c) check(columns_[c], cells[c]);
  if (!rows_.empty() && x < rows_.back().x) throw UsageError("x falls: sort the rows by x");
  rows_.push_back({line, x, std::move(cells)});
}

/// Linear between rows. The row nearest to x, if one is within `rounding`, gives its own value; at
/// a step, where two rows have one x, the later one.
std::string Profile::value_at(std::size_t column, std::string_view unit, double x,
                              double rounding) const {
  const auto from = std::ranges::lower_bound(rows_, x - rounding, {}, &Row::x);
  const auto after = std::ranges::upper_bound(rows_, x + rounding, {}, &Row::x);
  auto nearest = from;
  for (auto row = from; row != after; ++row) {
    if (std::abs(row->x - x) <= std::abs(nearest->x - x)) nearest = row;
  }
  const bool is_at_row = from != after;
  const Row& left = is_at_row || from == rows_.begin() ? *nearest : *(from - 1);
  const Row& right = is_at_row || after == rows_.end() ? left : *after;
  const double part = right.x > left.x ? (x - left.x) / (right.x - left.x) : 0.0;
  if (const Row& row = part < 0.5 ? left : right; !in_unit(row.cells[column], "1")) {
    return row.cells[column];  // a word
  }
  const auto number = [&](const Row& row) {
    return number_of(row.cells[column], columns_[column].unit, unit);
  };
  return fmt::format("{}", number(left) + part * (number(right) - number(left)));
}

/// As set_parameter() takes them.
std::string Profile::values_of(std::size_t column, std::string_view unit,
                               const Parameters& p) const {
  const double rounding = 1e-3 * block_spacing(p);  // positions are written with few digits
  for (const Row& row : rows_) {
    if (row.x >= -rounding && row.x <= p.L + rounding) continue;
    throw UsageError("{}:{}: x = {:g} m is outside the slider, 0 to {:g} m", path_, row.line, row.x,
                     p.L);
  }
  std::vector<std::string> values;
  for (const double x : block_positions(p)) values.push_back(value_at(column, unit, x, rounding));
  return fmt::format("{}", fmt::join(values, ","));
}

void Profile::apply(Parameters& p) const {
  ParameterChanges plain, parts;
  for (const auto& change : parsed_.parameters) {
    const bool is_part = is_along_x(change.value), is_in_file = !change.where.empty();
    if (!has(change.name) || (is_part && !is_in_file)) {
      (is_part ? parts : plain).push_back(change);
    } else if (is_part) {
      throw UsageError("{}the profile has {}: give a part of it with --set", change.where,
                       change.name);
    } else if (!is_in_file) {
      throw UsageError("the profile has {}: leave --set out", change.name);
    }
  }
  const auto loads = std::ranges::count(parts, "slider.load", &ParameterChange::name);
  if (loads > 1 || (loads == 1 && has("slider.load"))) {
    throw UsageError(
        "slider.load is given for two parts, but becomes 1 on average after each: use --profile");
  }
  set_parameters(plain, p);
  for (std::size_t c = 1; c < columns_.size(); ++c) {
    const std::string& name = columns_[c].name;
    if (std::ranges::count(kOfPrepare, name) == 0) {
      set_parameter(p, name, values_of(c, find_parameter(name).unit, p));
    } else if (parsed_.values.count(kOfPrepare.back().data()) == 0) {  // it has a default there
      throw UsageError("{} is for prepare: leave the column out", name);
    }
  }
  set_parameters(parts, p);
}

AlongX<double> Profile::along_x(const Parameters& p, const std::string& option) const {
  const std::string name = "--" + option;
  const ParameterInfo info = {.name = name,
                              .symbol = "",
                              .unit = "1",
                              .member = &Parameters::load,
                              .valid = {-1e9, 1e9},
                              .help = ""};
  const po::variable_value& given = parsed_.values[option];
  const auto column = std::ranges::find(columns_, option, &Column::name);
  if (column != columns_.end()) {
    if (!given.empty() && !given.defaulted()) {
      throw UsageError("the profile has {}: leave {} out", option, name);
    }
    const auto place = static_cast<std::size_t>(column - columns_.begin());
    return values_along_x(p, info, values_of(place, "1", p));
  }
  if (given.empty()) {
    throw UsageError("{} is missing: give it, or a --profile with this column", name);
  }
  return values_along_x(p, info, given.as<std::string>());
}

}  // namespace rupture::tools
