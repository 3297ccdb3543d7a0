// Values of parameters as text, and back to the same bits.
#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/parameters.hpp"
#include "rupture/model/user_text.hpp"

namespace rupture {
namespace {

/// A whole number may have any notation: 1000, 1e3 or 1000.0. Doubles hold all that are valid.
double parse_number(const ParameterInfo& info, std::string_view text, bool whole) {
  const auto number = number_in(text, info.unit);
  if (!number || (whole && std::trunc(*number) != *number)) {
    throw UsageError("{} = '{}' is not a {}number{}", info.name, text, whole ? "whole " : "",
                     units_taken(info.unit));
  }
  const auto& [minimum, maximum, minimum_excluded, words] = info.valid;
  const bool large_enough = minimum_excluded ? *number > minimum : *number >= minimum;
  if (!large_enough || !(*number <= maximum)) {
    throw UsageError("{} must be {}{}{} (got {})", info.name, minimum_excluded ? "" : "from ",
                     range_text(info), info.unit == "1" ? "" : fmt::format(" {}", info.unit), text);
  }
  return *number;
}

std::ptrdiff_t parse_word(const ParameterInfo& info, std::string_view text) {
  const auto& words = info.valid.words;
  const auto found = std::ranges::find(words, text);
  if (found == words.end()) {
    throw UsageError("{} must be {} (got '{}')", info.name, alternatives(words), text);
  }
  return found - words.begin();
}

template <class T>
T parse_value(const ParameterInfo& info, std::string_view text) {
  if constexpr (std::is_enum_v<T>) {
    return static_cast<T>(parse_word(info, text));
  } else {
    return static_cast<T>(parse_number(info, text, std::is_integral_v<T>));
  }
}

template <class T>
std::string value_text(const ParameterInfo& info, T value) {
  if constexpr (std::is_enum_v<T>) {
    return std::string(info.valid.words[static_cast<std::size_t>(value)]);
  } else {
    return fmt::format("{}", value);
  }
}

constexpr std::string_view kFrom = " from ", kTo = " to ";

double parse_x(const ParameterInfo& info, std::string_view text) {
  const auto x = number_in(text, "m");
  if (x) return *x;
  throw UsageError("{}: '{}' is not a position along x{}", info.name, text, units_taken("m"));
}

/// "VALUE from X to X": the blocks there have this value, the others keep theirs.
template <class T>
AlongX<T> with_patch(const Parameters& p, const ParameterInfo& info, const AlongX<T>& before,
                     std::string_view text) {
  const auto from = text.find(kFrom), to = text.find(kTo, from);
  if (to == std::string_view::npos) {
    throw UsageError("{} = '{}' has no end: write {}=VALUE from X to X", info.name, text,
                     info.name);
  }
  const T value = parse_value<T>(info, text.substr(0, from));
  const double x_from = parse_x(info, text.substr(from + kFrom.size(), to - from - kFrom.size()));
  const double x_to = parse_x(info, text.substr(to + kTo.size()));
  const double rounding = 1e-6 * block_spacing(p);
  validate_lengths(p);
  if (x_from > x_to || x_from < -rounding || x_to > p.L + rounding) {
    throw UsageError(
        "{} = '{}': expected a part of the slider, from 0 to {:g} m, the lower x first", info.name,
        text, p.L);
  }
  std::vector<T> blocks;
  int inside = 0;
  for (const double x : block_positions(p)) {
    const bool is_inside = x >= x_from - rounding && x <= x_to + rounding;
    blocks.push_back(is_inside ? value : before[std::ssize(blocks)]);
    inside += is_inside ? 1 : 0;
  }
  if (inside == 0) {
    throw UsageError("{} = '{}': no block is there; blocks are {:g} m apart", info.name, text,
                     block_spacing(p));
  }
  return AlongX<T>(std::move(blocks));
}

/// The value of each block, as parameter_text() writes them: 28x0.4,6x0.6,23x0.4.
template <class T>
AlongX<T> parse_blocks(const Parameters& p, const ParameterInfo& info, std::string_view text) {
  std::vector<T> blocks;
  const bool has_counts = text.find('x') != std::string_view::npos;
  for (bool more = has_counts || std::ranges::count(text, ',') + 1 == p.Nx; more;) {
    const auto comma = text.find(',');
    std::string_view part = text.substr(0, comma);
    more = comma != std::string_view::npos;
    if (more) text.remove_prefix(comma + 1);
    std::int64_t count = 1;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), count);
    const auto digits = static_cast<std::size_t>(end - part.data());
    if (error == std::errc{} && part.substr(digits).starts_with('x')) {
      part.remove_prefix(digits + 1);
    } else {
      count = 1;
    }
    if (count < 1 || count > p.Nx - std::ssize(blocks)) break;
    blocks.insert(blocks.end(), static_cast<std::size_t>(count), parse_value<T>(info, part));
    if (!more && std::ssize(blocks) == p.Nx) return AlongX<T>(std::move(blocks));
  }
  throw UsageError("{} takes one value or {}, one for each block; decimals need a point", info.name,
                   p.Nx);
}

template <class T>
T parse(const Parameters&, const ParameterInfo& info, const T&, std::string_view text) {
  if (text.find(kFrom) != std::string_view::npos) {
    throw UsageError("{} cannot vary along x", info.name);
  }
  return parse_value<T>(info, text);
}

template <class T>
AlongX<T> parse(const Parameters& p, const ParameterInfo& info, const AlongX<T>& before,
                std::string_view text) {
  if (!is_along_x(text)) return parse_value<T>(info, text);
  const bool is_patch = text.find(kFrom) != std::string_view::npos;
  return is_patch ? with_patch(p, info, before, text) : parse_blocks<T>(p, info, text);
}

template <class T>
std::string text_of(const ParameterInfo& info, const T& value) {
  return value_text(info, value);
}

template <class T>
std::string text_of(const ParameterInfo& info, const AlongX<T>& values) {
  if (!values.varies()) return value_text(info, values[0]);
  std::string text;
  const auto& blocks = values.blocks();
  for (auto first = blocks.begin(); first != blocks.end();) {
    const auto last = std::find_if(first, blocks.end(), [&](T value) { return value != *first; });
    if (!text.empty()) text += ',';
    if (last - first > 1) text += fmt::format("{}x", last - first);
    text += value_text(info, *first);
    first = last;
  }
  return text;
}

/// Weights that are 1 on average, so that the load stays F_N.
AlongX<double> as_weights(const AlongX<double>& given) {
  if (!given.varies()) return 1.0;
  std::vector<double> weights = given.blocks();
  double sum = 0.0;
  for (const double weight : weights) sum += weight;
  const double mean = sum / static_cast<double>(weights.size());
  constexpr double rounding = 1e-12;
  if (std::abs(mean - 1.0) < rounding) return given;
  for (double& weight : weights) weight /= mean;
  return AlongX(std::move(weights));
}

}  // namespace

void set_parameter(Parameters& parameters, std::string_view name, std::string_view text) {
  const ParameterInfo& info = find_parameter(name);
  std::visit(
      [&](auto member) { parameters.*member = parse(parameters, info, parameters.*member, text); },
      info.member);
  parameters.load = as_weights(parameters.load);
}

std::string parameter_text(const Parameters& parameters, const ParameterInfo& info) {
  return std::visit([&](auto member) { return text_of(info, parameters.*member); }, info.member);
}

AlongX<double> values_along_x(const Parameters& p, const ParameterInfo& info,
                              std::string_view text) {
  return parse(p, info, AlongX<double>(0.0), text);
}

std::string along_x_text(const AlongX<double>& values) {
  return text_of(find_parameter("slider.load"), values);
}

bool is_along_x(std::string_view text) {
  return text.find(kFrom) != std::string_view::npos || text.find(',') != std::string_view::npos;
}

}  // namespace rupture
