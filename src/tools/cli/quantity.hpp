// One row per quantity that a command reports: its key in JSON, unit, meaning and value, and
// whether CSV and the table in the text show it. JSON, CSV, text and `analyze quantities` come from
// the rows.
#pragma once

#include <cstdint>
#include <functional>
#include <variant>

#include "cli/option_values.hpp"

namespace rupture::tools {

struct Quantity;
using Quantities = std::vector<Quantity>;

/// Quantities under one key.
struct Group {
  Quantities rows;
  bool present = true;  ///< JSON has null in its place otherwise
};

/// Objects with the same quantities.
struct List {
  Quantities kind;  ///< of an element, also where there is none; its values do not count
  std::vector<Quantities> elements;
};

using Numbers = std::vector<std::optional<double>>;
using Counts = std::vector<std::optional<std::vector<std::int64_t>>>;
using Value = std::variant<std::optional<double>, std::int64_t, bool, std::string,
                           std::vector<double>, Numbers, Counts, Group, List>;

enum class Csv { no, yes };

/// A right-aligned column of the table in the text. What has no value is shown as "-".
struct TextColumn {
  std::size_t width;
  std::string format = "{}";  ///< of numbers
  std::string heading = {};   ///< that of CSV if empty
  double scale = 1.0;         ///< of the unit in the heading
};

/// In CSV and text, lists are columns with a line per element, and numbers are columns with one
/// line, or one per element of the List that they are in.
struct Quantity {
  std::string key;   ///< in JSON; empty if only the text shows the quantity
  std::string unit;  ///< SI; "1" where a number has none, empty for texts and truth values
  std::string help;
  Value value;
  Csv csv = Csv::no;
  std::optional<TextColumn> text = {};
  std::string heading = {};  ///< in CSV; "key [unit]" if empty
};

/// The value, or null.
inline Value if_known(bool known, Value value) {
  return known ? std::move(value) : std::optional<double>();
}

/// The same, also in CSV, and in the text if there is a column; of a group all its rows, under
/// "group.key".
Quantity in_csv(Quantity quantity, const std::optional<TextColumn>& text = {});

/// A row that the table in the text shows, and nothing else.
Quantity text_only(Value value, const TextColumn& column);

/// Positions of blocks, also in CSV and text.
Quantity positions(Value x);

/// One number of each element: a member, or what `of` makes of it.
Numbers each(const auto& elements, auto of) {
  Numbers numbers;
  for (const auto& element : elements) numbers.emplace_back(std::invoke(of, element));
  return numbers;
}

Quantities join(const std::vector<Quantities>& lists);

void add_json_option(po::options_description& options);
void add_format_options(po::options_description& options);

/// What a command prints: rows, and what stands around their table in the text.
struct Report {
  Quantities rows;
  std::string closing;
  std::string opening = {};
};

/// Prints the form that was asked for to standard output: one JSON object, CSV, or text; kDone.
/// Throws UsageError for two forms at once.
int print(const Report& report, const po::variables_map& values);

void print_json(const Quantities& rows);

}  // namespace rupture::tools
