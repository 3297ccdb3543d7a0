#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/model/error.hpp"

namespace rupture {
namespace {

constexpr std::string_view kGroup = "/parameters/";

/// Parameters that came after the first files of this schema: these files do without.
constexpr std::array<std::string_view, 4> kAddedLater = {"slider.support", "junctions.law",
                                                         "junctions.mu_new", "junctions.v_slow"};

bool may_be_missing(const ParameterInfo& info) {
  return std::find(kAddedLater.begin(), kAddedLater.end(), info.name) != kAddedLater.end();
}

std::string dataset_path(const ParameterInfo& info) {
  std::string name(info.name);
  std::replace(name.begin(), name.end(), '.', '/');
  return std::string(kGroup) + name;
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

void refuse_unknown(const Content& content) {
  std::set<std::string> known;
  for (const ParameterInfo& info : parameter_table()) known.insert(dataset_path(info));
  for (const auto& [path, dataset] : content) {
    if (path.starts_with(kGroup) && !known.contains(path)) {
      throw Failure(fmt::format("{} is no parameter of this build: use a newer rupture", path));
    }
  }
}

}  // namespace

Content parameters_content(const Parameters& parameters) {
  Content content;
  for (const ParameterInfo& info : parameter_table()) {
    content[dataset_path(info)] = parameter_dataset(parameters, info);
  }
  return content;
}

Parameters read_parameters(const Content& content) {
  refuse_unknown(content);
  Parameters parameters;
  try {
    for (const ParameterInfo& info : parameter_table()) {
      if (may_be_missing(info) && !content.contains(dataset_path(info))) continue;
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
