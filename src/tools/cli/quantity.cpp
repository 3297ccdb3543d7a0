#include "cli/quantity.hpp"

#include <algorithm>

#include "cli/report.hpp"
#include "cli/text.hpp"

namespace rupture::tools {
namespace {

std::string heading_of(const Quantity& quantity) {
  if (!quantity.heading.empty()) return quantity.heading;
  const bool has_unit = !quantity.unit.empty() && quantity.unit != "1";
  return has_unit ? fmt::format("{} [{}]", quantity.key, quantity.unit) : quantity.key;
}

// --- JSON

Json json_of(const Quantities& rows);

struct ToJson {
  Json operator()(const auto& value) const { return value; }
  template <class T>
  Json operator()(const std::optional<T>& value) const {
    return value ? Json(*value) : Json();
  }
  template <class T>
  Json operator()(const std::vector<std::optional<T>>& values) const {
    Json array = Json::array();
    for (const auto& value : values) array.push_back((*this)(value));
    return array;
  }
  Json operator()(const Group& group) const { return group.present ? json_of(group.rows) : Json(); }
  Json operator()(const List& list) const {
    Json array = Json::array();
    for (const auto& element : list.elements) array.push_back(json_of(element));
    return array;
  }
};

Json json_of(const Quantities& rows) {
  Json json = Json::object();
  for (const auto& row : rows) {
    if (!row.key.empty()) json[row.key] = std::visit(ToJson{}, row.value);
  }
  return json;
}

// --- CSV and the table in the text

enum class Form { csv, text };

/// How a row is shown, if it is.
std::optional<TextColumn> layout_of(const Quantity& row, Form form) {
  auto layout = row.text;
  if (form == Form::csv) layout = row.csv == Csv::yes ? std::optional(TextColumn{0}) : std::nullopt;
  if (layout && layout->heading.empty()) layout->heading = heading_of(row);
  return layout;
}

/// The rows themselves, and those of their groups.
std::vector<const Quantity*> leaves(const Quantities& rows) {
  std::vector<const Quantity*> found;
  for (const auto& row : rows) {
    const auto* const group = std::get_if<Group>(&row.value);
    const auto below = group != nullptr ? leaves(group->rows) : std::vector{&row};
    found.insert(found.end(), below.begin(), below.end());
  }
  return found;
}

using Cells = std::vector<std::string>;

struct ToCells {
  const TextColumn& layout;
  const char* none;

  Cells operator()(const auto& value) const { return {fmt::format("{}", value)}; }
  Cells operator()(const std::optional<double>& number) const {
    return {number ? fmt::format(fmt::runtime(layout.format), *number * layout.scale) : none};
  }
  template <class T>
  Cells operator()(const std::vector<T>& numbers) const {
    Cells cells;
    for (const auto& number : numbers) cells.push_back((*this)(std::optional(number)).front());
    return cells;
  }
  Cells operator()(const Counts&) const { return {}; }
  Cells operator()(const Group&) const { return {}; }
  Cells operator()(const List&) const { return {}; }
};

/// Columns with their headings: those of the List if there is one.
std::vector<Cells> columns_of(const Quantities& rows, Form form) {
  const auto listed = std::ranges::find_if(
      rows, [](const Quantity& row) { return std::holds_alternative<List>(row.value); });
  const List list = listed == rows.end() ? List{rows, {rows}} : std::get<List>(listed->value);
  std::vector<Cells> columns;
  for (const Quantity* const row : leaves(list.kind)) {
    const auto layout = layout_of(*row, form);
    if (layout) columns.push_back({fmt::format("{:>{}}", layout->heading, layout->width)});
  }
  for (const auto& element : list.elements) {
    auto column = columns.begin();
    for (const Quantity* const row : leaves(element)) {
      const auto layout = layout_of(*row, form);
      if (!layout) continue;
      const ToCells to_cells = {*layout, form == Form::csv ? "" : "-"};
      for (const auto& cell : std::visit(to_cells, row->value)) {
        column->push_back(fmt::format("{:>{}}", cell, layout->width));
      }
      ++column;
    }
  }
  return columns;
}

std::string table(const Quantities& rows, Form form) {
  const auto columns = columns_of(rows, form);
  const std::size_t lines = columns.empty() ? 0 : columns.front().size();
  std::string text;
  for (std::size_t line = 0; line < lines; ++line) {
    for (const Cells& column : columns) {
      if (form == Form::csv && &column != &columns.front()) text += ",";
      text += column[line];
    }
    text += "\n";
  }
  return text;
}

}  // namespace

Quantity in_csv(Quantity quantity, const std::optional<TextColumn>& text) {
  quantity.csv = Csv::yes;
  quantity.text = text;
  if (auto* const group = std::get_if<Group>(&quantity.value)) {
    for (Quantity& row : group->rows) {
      row.csv = Csv::yes;
      row.heading = quantity.key + "." + heading_of(row);
    }
  }
  return quantity;
}

Quantity text_only(Value value, const TextColumn& column) {
  return {"", "", "", std::move(value), Csv::no, column};
}

Quantity positions(Value x) {
  return {"x", "m", "position of each block", std::move(x), Csv::yes, TextColumn{9, "{:.4f}"}};
}

Quantities join(const std::vector<Quantities>& lists) {
  Quantities all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

void add_json_option(po::options_description& options) {
  options.add_options()("json", "print one JSON object");
}

void add_format_options(po::options_description& options) {
  add_json_option(options);
  options.add_options()("csv", "print the series as CSV");
}

int print(const Report& report, const po::variables_map& values) {
  const bool json = values.count("json") > 0, csv = values.count("csv") > 0;
  if (json && csv) throw UsageError("--json and --csv cannot be combined: give one of them");
  if (json) {
    print_json(report.rows);
  } else if (csv) {
    say("{}", table(report.rows, Form::csv));
  } else {
    say("{}{}{}", report.opening, table(report.rows, Form::text), report.closing);
  }
  return kDone;
}

void print_json(const Quantities& rows) {
  say("{}\n", json_text(json_of(rows)));
}

}  // namespace rupture::tools
