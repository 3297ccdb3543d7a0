// parameters: what --set and --config take.
#include "rupture/model/parameters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

#include "cli/command_line.hpp"
#include "cli/report.hpp"
#include "cli/text.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/laws.hpp"

namespace rupture::tools {
namespace {

using Rows = std::vector<ParameterInfo>;

bool is_of_group(const ParameterInfo& info, std::string_view group) {
  return info.name.substr(0, info.name.find('.')) == group;
}

/// The parameter of this name, or those of this group. Throws UsageError if there is none.
Rows rows_called(const std::string& name) {
  Rows rows;
  for (const auto& info : parameter_table()) {
    if (is_of_group(info, name)) rows.push_back(info);
  }
  return rows.empty() ? Rows{find_parameter(name)} : rows;
}

Rows rows_called(const std::vector<std::string>& names) {
  Rows all;
  for (const auto& name : names) {
    const Rows rows = rows_called(name);
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

std::string text_of(const ParameterInfo& info) {
  const auto words = info.valid.words;
  const bool is_number = words.empty();
  std::string text = fmt::format("{}\n  {}\n", info.name, info.help);
  const auto add = [&](std::string_view what, std::string_view value) {
    text += fmt::format("  {:<8} {}\n", what, value);
  };
  if (info.symbol != "-") add("symbol", info.symbol);
  if (is_number) add("unit", info.unit);
  add("default", parameter_text(Parameters{}, info));
  add("value", is_number ? range_text(info) : fmt::format("{}", fmt::join(words, " or ")));
  add("laws", fmt::format("{}", fmt::join(law_names(info.laws), ", ")));
  if (info.restart == Restart::must_keep) add("restart", "cannot change it");
  return text;
}

void print_text(const Rows& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    say("{}{}", i > 0 ? "\n" : "", text_of(rows[i]));
  }
}

int print_parameters(const Parsed& parsed) {
  const bool are_named = parsed.values.count("parameter") > 0;
  const Rows rows = are_named
                        ? rows_called(parsed.values["parameter"].as<std::vector<std::string>>())
                        : parameter_table();
  if (parsed.values.count("json") > 0) {
    say("{}\n", json_text({{"parameters", tools::json_of(rows)}}));
  } else if (are_named) {
    print_text(rows);
  } else {
    say("Parameters: name, default, unit, meaning (symbol)\n{}", parameter_help());
  }
  return kDone;
}

}  // namespace

extern const Command parameters_command;
constinit const Command parameters_command = {
    "parameters [NAME...]",
    "parameter",
    "units, defaults, ranges and meanings of the parameters",
    "Lists all parameters. With names, or a group such as junctions, prints units, defaults,\n"
    "ranges and meanings of these, and the laws that use them.",
    {add_json_option},
    print_parameters};

}  // namespace rupture::tools
