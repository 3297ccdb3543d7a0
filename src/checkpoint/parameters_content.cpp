#include "rupture/checkpoint/parameters_content.hpp"

#include <algorithm>
#include <iterator>

namespace rupture {
namespace {

constexpr std::string_view kParametersGroup = "/parameters/";

std::string dataset_path(const ParameterInfo& info) {
  std::string name(info.name);
  std::replace(name.begin(), name.end(), '.', '/');
  return std::string(kParametersGroup) + name;
}

template <class T>
constexpr bool is_number = std::is_same_v<T, double> || std::is_same_v<T, std::int64_t>;

Dataset parameter_dataset(const Parameters& parameters, const ParameterInfo& info) {
  return std::visit(
      [&]<class T>(T Parameters::*member) {
        if constexpr (is_number<T>) {
          return make_scalar(parameters.*member, info.unit);
        } else {
          return make_text(parameter_text(parameters, info));
        }
      },
      info.member);
}

// The stored value as text, so that the table's own rules decide whether it is valid.
std::string stored_text(const Content& content, const ParameterInfo& info) {
  return std::visit(
      [&]<class T>(T Parameters::*member) {
        if constexpr (is_number<T>) {
          Parameters holder;
          holder.*member = read_scalar<T>(content, dataset_path(info));
          return parameter_text(holder, info);
        } else {
          return read_text(content, dataset_path(info));
        }
      },
      info.member);
}

// The interface law of a content: the default if it names none. A name of no law is refused later.
Law law_of(const Content& content) {
  const ParameterInfo& info = find_parameter("junctions.law");
  const auto stored = content.find(dataset_path(info));
  const auto names = info.valid.words;
  for (std::size_t law = 0; stored != content.end() && law < names.size(); ++law) {
    if (stored->second.bytes == make_text(names[law]).bytes) return static_cast<Law>(law);
  }
  return Parameters{}.law;
}

}  // namespace

Content counted_parameters(const Content& content, const std::vector<ParameterInfo>& table) {
  const Law law = law_of(content);
  Content counted;
  std::copy_if(content.begin(), content.end(), std::inserter(counted, counted.end()),
               [](const auto& entry) { return entry.first.starts_with(kParametersGroup); });
  for (const ParameterInfo& info : table) {
    const std::string path = dataset_path(info);
    const Dataset by_default = parameter_dataset({}, info);
    if (!is_used(info, law)) counted[path] = by_default;
    if (info.since == Since::original) continue;
    counted.try_emplace(path, by_default);
    if (is_same(counted.at(path), by_default)) counted.erase(path);
  }
  return counted;
}

void refuse_unknown_parameters(const Content& content) {
  refuse_others(content, kParametersGroup, parameters_content({}),
                "is not a parameter of this version: use a newer rupture");
}

Content parameters_content(const Parameters& parameters) {
  Content content;
  for (const ParameterInfo& info : parameter_table()) {
    content[dataset_path(info)] = parameter_dataset(parameters, info);
  }
  return content;
}

Parameters read_parameters(const Content& content) {
  refuse_unknown_parameters(content);
  Parameters parameters;
  try {
    for (const ParameterInfo& info : parameter_table()) {
      if (info.since == Since::later && !content.contains(dataset_path(info))) continue;
      set_parameter(parameters, info.name, stored_text(content, info));
    }
    validate(parameters);
    expect_as_written(content, parameters_content(parameters));
  } catch (const UsageError& error) {
    throw Failure(error.what());
  }
  return parameters;
}

}  // namespace rupture
