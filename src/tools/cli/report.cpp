#include "cli/report.hpp"

#include <algorithm>
#include <boost/any.hpp>

#include "cli/text.hpp"
#include "rupture/model/laws.hpp"

namespace rupture::tools {
namespace {

const ValueKind kFlag = {"flag", ""};

const ValueKind& kind_or_flag(const po::option_description& option) {
  if (const auto* kind = dynamic_cast<const ValueKind*>(option.semantic().get())) return *kind;
  if (option.semantic()->max_tokens() == 0) return kFlag;
  throw std::logic_error("the value of --" + option.long_name() + " has no kind");
}

Json default_of(const po::option_description& option) {
  boost::any value;
  if (!option.semantic()->apply_default(value)) return nullptr;
  if (const auto* real = boost::any_cast<double>(&value)) return *real;
  if (const auto* whole = boost::any_cast<int>(&value)) return *whole;
  return boost::any_cast<std::string>(value);
}

Json option_json(const po::option_description& option) {
  const ValueKind& kind = kind_or_flag(option);
  const auto name = option.canonical_display_name(po::command_line_style::allow_dash_for_short);
  const Json short_name = name.starts_with("-") ? Json(name.substr(1)) : Json();
  Json json = {{"name", option.long_name()},  {"short", short_name},
               {"kind", kind.kind},           {"value", kind.name},
               {"unit", kind.unit},           {"default", default_of(option)},
               {"help", option.description()}};
  if (kind.kind == "choice") json["words"] = split(kind.name, '|');
  if (!kind.holds.empty()) json["holds"] = kind.holds;
  return json;
}

/// Groups of options: one of each group must be given.
Json needed_json(const Command& command, const po::options_description& options) {
  Json groups = Json::array();
  Json needed = Json::array();
  for (const char* const option : command.one_needed) {
    if (option != nullptr) needed.push_back(option);
  }
  if (!needed.empty()) groups.push_back(needed);
  for (const auto& option : options.options()) {
    if (option->semantic()->is_required()) groups.push_back(Json::array({option->long_name()}));
  }
  return groups;
}

/// A program that writes no file prints a report.
Json outputs_json(const po::options_description& options) {
  Json outputs = Json::array();
  for (const auto& option : options.options()) {
    const ValueKind& kind = kind_or_flag(*option);
    if (kind.kind == "output file") outputs.push_back(kind.holds);
  }
  return outputs.empty() ? Json::array({"report"}) : outputs;
}

template <class T>
Json value_json(const ParameterInfo& info, const T& value) {
  if constexpr (std::is_enum_v<T>) {
    return info.valid.words[static_cast<std::size_t>(value)];
  } else {
    return value;
  }
}

/// A value, or that of each block.
template <class T>
Json value_json(const ParameterInfo& info, const AlongX<T>& values) {
  if (!values.varies()) return value_json(info, values[0]);
  Json blocks = Json::array();
  for (const T value : values.blocks()) blocks.push_back(value_json(info, value));
  return blocks;
}

}  // namespace

std::string json_text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json json_of(const Parameters& parameters, const ParameterInfo& info) {
  return std::visit([&](auto member) { return value_json(info, parameters.*member); }, info.member);
}

Json json_of(const ProvenanceEntry& entry) {
  return {{"tool", entry.tool},         {"version", entry.version},
          {"commit", entry.commit},     {"command_line", entry.command_line},
          {"compiler", entry.compiler}, {"parent_checksum", entry.parent_checksum},
          {"rebuild", entry.rebuild}};
}

Json json_of(const std::vector<ParameterInfo>& rows) {
  Json list = Json::array();
  for (const auto& info : rows) {
    const auto& [minimum, maximum, minimum_excluded, words] = info.valid;
    Json row = {{"name", info.name},
                {"symbol", info.symbol},
                {"unit", words.empty() ? info.unit : ""},
                {"default", json_of(Parameters{}, info)},
                {"help", info.help},
                {"laws", law_names(info.laws)},
                {"restart_may_change", info.restart == Restart::may_change}};
    if (words.empty()) {
      row["minimum"] = minimum;
      row["minimum_excluded"] = minimum_excluded;
      row["maximum"] = maximum;
    } else {
      row["words"] = words;
    }
    list.push_back(row);
  }
  return list;
}

Json description(const Command& command, const po::options_description& options) {
  std::string purpose = command.purpose;
  std::ranges::replace(purpose, '\n', ' ');
  Json json = {{"name", command.name()},
               {"synopsis", command.synopsis()},
               {"purpose", purpose},
               {"input", *command.input == '\0' ? Json() : Json(command.input)},
               {"outputs", outputs_json(options)},
               {"parameters", command.uses_parameters == UsesParameters::yes},
               {"one_needed", needed_json(command, options)},
               {"options", Json::array()},
               {"summary", command.summary}};
  for (const auto& option : options.options()) json["options"].push_back(option_json(*option));
  return json;
}

}  // namespace rupture::tools
