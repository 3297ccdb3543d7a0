// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

#include "cli/option_values.hpp"

#include <fmt/format.h>

#include <boost/any.hpp>
#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <cmath>
#include <sstream>

#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

/// The values given for an option that takes one text or several.
std::vector<std::string> words_of(const po::variable_value& value) {
  if (const auto* words = boost::any_cast<std::vector<std::string>>(&value.value())) return *words;
  return {value.as<std::string>()};
}

double time_in(const std::string& text, const std::string& option) {
  double t = 0.0;
  if (boost::conversion::try_lexical_convert(text, t)) return t;
  throw UsageError(fmt::format("--{} {}: give the time in seconds as a plain number, such as 0.01",
                               option, text));
}

/// The value, which `given` holds for the option, if it is a pinned fraction.
template <class Given>
double pinned_fraction(double value, const Given& given, const std::string& option) {
  if (value > 0.0 && value <= 1.0) return value;
  throw UsageError(fmt::format("--{} {} makes no sense: a pinned fraction is above 0 and at most 1",
                               option, given));
}

template <class T>
class DescribedValue : public po::typed_value<T>, public ValueKind {
 public:
  explicit DescribedValue(ValueKind declared)
      : po::typed_value<T>(nullptr), ValueKind(std::move(declared)) {
    const bool has_unit = !unit.empty() && unit != "1";
    this->value_name(has_unit ? fmt::format("{} [{}]", name, unit) : name);
  }
};

template <class T>
po::typed_value<T>* described(ValueKind kind) {
  return new DescribedValue<T>(std::move(kind));
}

}  // namespace

po::typed_value<std::string>* seconds() {
  return described<std::string>({"number", "T", "s"});
}

po::typed_value<std::vector<std::string>>* list_of_seconds() {
  return described<std::vector<std::string>>({"number", "T...", "s"})->multitoken();
}

po::typed_value<double>* number(const std::string& name, const std::string& unit) {
  return described<double>({"number", name, unit});
}

po::typed_value<int>* integer(const std::string& name) {
  return described<int>({"integer", name, "1"});
}

po::typed_value<std::string>* seed() {
  return described<std::string>({"integer", "N", "1"});
}

po::typed_value<std::string>* one_of(const std::string& words) {
  return described<std::string>({"choice", words});
}

po::typed_value<std::string>* text(const std::string& name) {
  return described<std::string>({"text", name});
}

po::typed_value<std::vector<std::string>>* assignments() {
  return described<std::vector<std::string>>({"parameter", "NAME=VALUE"})->composing();
}

po::typed_value<std::string>* input_file(const std::string& holds) {
  return described<std::string>({"input file", "FILE", "", holds});
}

po::typed_value<std::string>* output_file(const std::string& holds) {
  return described<std::string>({"output file", "FILE", "", holds});
}

const ValueKind* kind_of(const po::option_description& option) {
  return dynamic_cast<const ValueKind*>(option.semantic().get());
}

std::vector<double> times(const po::variables_map& values, const std::string& option) {
  std::vector<double> result;
  for (const std::string& word : words_of(values[option])) result.push_back(time_in(word, option));
  return result;
}

double time_from_zero(const po::variables_map& values, const std::string& option) {
  return non_negative(times(values, option).front(), option);
}

std::optional<double> optional_time(const po::variables_map& values, const std::string& option) {
  if (values.count(option) == 0) return std::nullopt;
  return time_from_zero(values, option);
}

double non_negative(const po::variables_map& values, const std::string& option) {
  return non_negative(values[option].as<double>(), option);
}

double non_negative(double value, const std::string& option) {
  if (std::isfinite(value) && value >= 0.0) return value;
  throw UsageError(
      fmt::format("--{} {} makes no sense: give a number of at least 0", option, value));
}

std::optional<double> optional_non_negative(const po::variables_map& values,
                                            const std::string& option) {
  if (values.count(option) == 0) return std::nullopt;
  return non_negative(values, option);
}

double fraction(const po::variables_map& values, const std::string& option) {
  const auto value = values[option].as<double>();
  return pinned_fraction(value, value, option);
}

std::vector<double> fractions(const po::variables_map& values, const std::string& option) {
  const auto& text = values[option].as<std::string>();
  std::vector<double> result;
  std::istringstream list(text + ",");  // so that an empty text is refused as well
  for (std::string word; std::getline(list, word, ',');) {
    double value = 0.0;
    if (!boost::conversion::try_lexical_convert(word, value)) value = 0.0;  // no fraction
    result.push_back(pinned_fraction(value, text, option));
  }
  return result;
}

}  // namespace rupture::tools
