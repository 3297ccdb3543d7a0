// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

#include "cli/text.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "rupture/model/laws.hpp"
#include "rupture/model/nearest.hpp"
#include "rupture/model/parameters.hpp"

namespace rupture::tools {
namespace {

/// "; simplified law" or "; reference and decaying laws"; nothing if all laws use the parameter.
std::string laws_text(const ParameterInfo& info) {
  if (info.laws.empty()) return "";
  const auto words = law_names(info.laws);
  return fmt::format("; {} law{}", fmt::join(words, " and "), words.size() > 1 ? "s" : "");
}

}  // namespace

std::string parameter_help() {
  std::string text;
  const Parameters defaults;
  for (const auto& info : parameter_table()) {
    const auto words = choices(info);
    const std::string unit =
        words.empty() ? fmt::format("[{}]", info.unit) : fmt::format("[{}]", fmt::join(words, "|"));
    text +=
        fmt::format("  {:<26} {:>10} {:<22} {} ({}{})\n", info.name, parameter_text(defaults, info),
                    unit, info.help, info.symbol, laws_text(info));
  }
  return text;
}

std::string unknown_option_text(const std::string& option,
                                const boost::program_options::options_description& known,
                                const std::string& tool) {
  std::vector<std::string> names;
  for (const auto& description : known.options()) {
    names.push_back("--" + description->long_name());
  }
  return fmt::format("unknown option '{}': did you mean '{}'? See rupture {} --help", option,
                     nearest(option, {names.begin(), names.end()}), tool);
}

std::string in_one_line(std::string message) {
  const auto control = [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; };
  std::replace_if(message.begin(), message.end(), control, '?');
  return message;
}

}  // namespace rupture::tools
