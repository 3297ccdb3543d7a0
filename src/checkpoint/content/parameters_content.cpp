#include "rupture/checkpoint/parameters_content.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "checkpoint/content/layout.hpp"
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

// In an array, words stand by their number.
template <class T>
using InArray = std::conditional_t<is_number<T>, T, std::int64_t>;

template <class T>
Dataset dataset_of(const ParameterInfo& info, const Parameters& parameters, T value) {
  if constexpr (is_number<T>) {
    return make_scalar(value, info.unit);
  } else {
    return make_text(parameter_text(parameters, info));
  }
}

// One value, or an array with that of each block.
template <class T>
Dataset dataset_of(const ParameterInfo& info, const Parameters& parameters,
                   const AlongX<T>& values) {
  if (!values.varies()) return dataset_of(info, parameters, values[0]);
  std::vector<InArray<T>> stored;
  for (const T value : values.blocks()) stored.push_back(static_cast<InArray<T>>(value));
  return make_array(std::span<const InArray<T>>(stored), {stored.size()}, info.unit);
}

Dataset parameter_dataset(const Parameters& parameters, const ParameterInfo& info) {
  return std::visit([&](auto member) { return dataset_of(info, parameters, parameters.*member); },
                    info.member);
}

// The stored value as text, so that the table's own rules decide whether it is valid.
template <class T>
std::string stored_text(const Content& content, const ParameterInfo& info, const T&) {
  if constexpr (is_number<T>) {
    return fmt::format("{}", read_scalar<T>(content, dataset_path(info)));
  } else {
    return read_text(content, dataset_path(info));
  }
}

template <class T>
std::string stored_text(const Content& content, const ParameterInfo& info, const AlongX<T>&) {
  const std::string path = dataset_path(info);
  const auto found = content.find(path);
  if (found == content.end() || found->second.shape.size() != 1) {
    return stored_text(content, info, T{});
  }
  std::string text;
  for (const auto value : read_array<InArray<T>>(content, path, found->second.shape)) {
    if (!text.empty()) text += ',';
    if constexpr (is_number<T>) {
      text += fmt::format("{}", value);
    } else {
      const auto word = static_cast<std::size_t>(value);
      text += word < info.valid.words.size() ? info.valid.words[word] : fmt::format("{}", value);
    }
  }
  return text;
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
      const std::string text = std::visit(
          [&](auto member) { return stored_text(content, info, parameters.*member); }, info.member);
      set_parameter(parameters, info.name, text);
    }
    validate(parameters);
    expect_as_written(content, parameters_content(parameters));
  } catch (const UsageError& error) {
    throw Failure(error.what());
  }
  return parameters;
}

DatasetInfos parameter_datasets() {
  DatasetInfos all;
  for (const ParameterInfo& info : parameter_table()) {
    const Dataset scalar = parameter_dataset({}, info);
    all.push_back({dataset_path(info), type_name(scalar.type), "", scalar.unit});
    if (may_vary_along_x(info)) all.back().lengths = "|[Nx]";
  }
  return all;
}

}  // namespace rupture
