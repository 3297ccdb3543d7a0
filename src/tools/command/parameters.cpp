// parameters: what --set and --config take.
#include "rupture/model/parameters.hpp"

#include <algorithm>

#include "cli/report.hpp"
#include "run/output.hpp"
#include "rupture/model/laws.hpp"
#include "rupture/model/user_text.hpp"

namespace rupture::tools {
namespace {

using Rows = std::vector<ParameterInfo>;

/// The parameters of these names, and those of these groups. Throws UsageError if there is none.
Rows rows_called(const std::vector<std::string>& names) {
  Rows rows;
  for (const auto& name : names) {
    const std::size_t before = rows.size();
    for (const auto& info : parameter_table()) {
      if (info.name.substr(0, info.name.find('.')) == name) rows.push_back(info);
    }
    if (rows.size() == before) rows.push_back(find_parameter(name));
  }
  return rows;
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
  add("value", is_number ? range_text(info) : alternatives(words));
  add("laws", fmt::format("{}", fmt::join(law_names(info.laws), ", ")));
  if (info.restart == Restart::must_keep) add("restart", "cannot change it");
  return text;
}

/// "; law: simplified" or "; laws: reference, decaying"; nothing if all laws use the parameter.
std::string laws_text(const ParameterInfo& info) {
  if (info.laws.empty()) return "";
  const auto words = law_names(info.laws);
  return fmt::format("; law{}: {}", words.size() > 1 ? "s" : "", fmt::join(words, ", "));
}

/// One line per parameter: name, default, unit, meaning.
std::string list_of_all() {
  std::string text;
  const Parameters defaults;
  for (const auto& info : parameter_table()) {
    const auto words = info.valid.words;
    const std::string unit =
        words.empty() ? fmt::format("[{}]", info.unit) : fmt::format("[{}]", fmt::join(words, "|"));
    text +=
        fmt::format("  {:<26} {:>10} {:<22} {} ({}{})\n", info.name, parameter_text(defaults, info),
                    unit, info.help, info.symbol, laws_text(info));
  }
  return text;
}

int print_parameters(const Parsed& parsed) {
  const bool are_named = parsed.values.count("parameter") > 0;
  const Rows rows = are_named
                        ? rows_called(parsed.values["parameter"].as<std::vector<std::string>>())
                        : parameter_table();
  if (parsed.values.count("json") > 0) {
    say("{}\n", json_text({{"parameters", tools::json_of(rows)}}));
  } else if (are_named) {
    std::vector<std::string> texts;
    std::ranges::transform(rows, std::back_inserter(texts), text_of);
    say("{}", fmt::join(texts, "\n"));
  } else {
    say("Parameters: name, default, unit, meaning (symbol)\n{}", list_of_all());
  }
  return kDone;
}

}  // namespace

constinit const Command parameters_command = {
    "parameters [NAME...]",
    "parameter",
    "list the parameters with their units, defaults, ranges and meanings",
    "Lists all parameters. With names, or a group such as junctions, prints units, defaults,\n"
    "ranges and meanings of these, and the laws that use them.",
    {add_json_option},
    print_parameters};

}  // namespace rupture::tools
