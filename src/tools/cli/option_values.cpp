#include "cli/option_values.hpp"

#include <fmt/format.h>

#include <boost/any.hpp>
#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <cmath>

#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

/// The values given for an option that takes one text or several.
std::vector<std::string> words_of(const po::variable_value& value) {
  if (const auto* words = boost::any_cast<std::vector<std::string>>(&value.value())) return *words;
  return {value.as<std::string>()};
}

double seconds(const std::string& text, const std::string& option) {
  double t = 0.0;
  if (boost::conversion::try_lexical_convert(text, t)) return t;
  throw UsageError(fmt::format("--{} {}: give the time in seconds as a plain number, such as 0.01",
                               option, text));
}

}  // namespace

std::vector<double> times(const po::variables_map& values, const std::string& option) {
  std::vector<double> result;
  for (const std::string& word : words_of(values[option])) result.push_back(seconds(word, option));
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

}  // namespace rupture::tools
