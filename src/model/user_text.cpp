#include "rupture/model/user_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <limits>
#include <utility>

namespace rupture {
namespace {

/// A multiple of a unit: what stands in front of its symbol, and its power of ten.
struct Multiple {
  std::string_view prefix;
  int exponent;
};

constexpr std::array kMultiples = {Multiple{"", 0},   Multiple{"G", 9},  Multiple{"M", 6},
                                   Multiple{"k", 3},  Multiple{"m", -3}, Multiple{"u", -6},
                                   Multiple{"n", -9}, Multiple{"µ", -6}, Multiple{"μ", -6}};
constexpr std::size_t kNamed = 7;  // the others are u, too: U+00B5 and U+03BC

/// Lengths and times have no large multiples: whoever writes 10Ms does not mean megaseconds.
bool takes(std::string_view unit, const Multiple& multiple) {
  return multiple.exponent <= 0 || !(unit.starts_with('s') || unit.starts_with('m'));
}

/// The unit without the prefix that kg has of itself.
std::string_view symbol_of(std::string_view unit) {
  return unit == "kg" ? unit.substr(1) : unit;
}

/// The power of ten of what stands behind a number; none if it is not of this unit.
std::optional<int> exponent_of(std::string_view word, std::string_view unit) {
  const std::string_view symbol = symbol_of(unit);
  const int own = symbol == unit ? 0 : 3;
  if (unit == "1" || !word.ends_with(symbol)) return std::nullopt;
  word.remove_suffix(symbol.size());
  for (const Multiple& multiple : kMultiples) {
    if (word == multiple.prefix && takes(unit, multiple)) return multiple.exponent - own;
  }
  return std::nullopt;
}

/// The decimal number times a power of ten.
std::string shifted(std::string_view number, int by) {
  const std::size_t e = number.find_first_of("eE");
  if (by == 0) return std::string(number);
  if (e == std::string_view::npos) return fmt::format("{}e{}", number, by);
  std::string_view digits = number.substr(e + 1);
  if (digits.starts_with('+')) digits.remove_prefix(1);
  std::int64_t exponent = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  constexpr std::int64_t most = 1'000'000;  // far beyond all doubles
  if (error != std::errc{} || exponent > most || exponent < -most) return std::string(number);
  return fmt::format("{}e{}", number.substr(0, e), exponent + by);
}

/// Twice the number of single-character edits that turn a into b; one of case alone counts half.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = 2 * j;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], 2 * (i + 1));
    for (std::size_t j = 0; j < b.size(); ++j) {
      const bool same_letter = lower(a[i]) == lower(b[j]);
      const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : same_letter ? 1 : 2);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substituted, diagonal + 2, row[j] + 2});
    }
  }
  return row.back();
}

/// Another group, or none, counts as one edit.
std::size_t distance(std::string_view word, std::string_view candidate) {
  const auto leaf = candidate.substr(candidate.find('.') + 1);
  const auto group = candidate.substr(0, candidate.size() - leaf.size());
  const auto own_leaf = word.substr(word.find('.') + 1);
  return std::min(edit_distance(word, candidate),
                  edit_distance(own_leaf, leaf) + (word.starts_with(group) ? 0 : 2));
}

}  // namespace

std::optional<std::string> in_unit(std::string_view text, std::string_view unit) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double ignored = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), ignored);
  if (error == std::errc::invalid_argument) return std::nullopt;
  const auto length = static_cast<std::size_t>(end - text.data());
  const std::string_view number = text.substr(0, length);
  std::string_view word = text.substr(length);
  if (word.empty()) return std::string(number);
  word.remove_prefix(std::min(word.find_first_not_of(' '), word.size()));
  const auto exponent = exponent_of(word, unit);
  if (!exponent) return std::nullopt;
  return shifted(number, *exponent);
}

std::optional<double> number_in(std::string_view text, std::string_view unit) {
  const auto plain = in_unit(text, unit);
  if (!plain) return std::nullopt;
  double number = 0.0;
  const auto* end = plain->data() + plain->size();
  const auto [stop, error] = std::from_chars(plain->data(), end, number);
  if (stop != end || error == std::errc::invalid_argument) return std::nullopt;
  return error == std::errc{} ? number : std::numeric_limits<double>::infinity();
}

std::string units_taken(std::string_view unit) {
  if (unit == "1") return "";
  std::vector<std::string> taken = {std::string(unit)};
  for (std::size_t n = 0; n < kNamed; ++n) {
    const std::string word = fmt::format("{}{}", kMultiples[n].prefix, symbol_of(unit));
    if (word != unit && takes(unit, kMultiples[n])) taken.push_back(word);
  }
  return fmt::format(" (unit {})", alternatives(taken));
}

std::string unknown_text(std::string_view what, std::string_view word,
                         const std::vector<std::string_view>& candidates, std::string_view see) {
  const auto distance_to = [&](std::string_view candidate) { return distance(word, candidate); };
  const std::string_view near = *std::ranges::min_element(candidates, {}, distance_to);
  const std::size_t length = word.size() - (word.find('.') + 1);  // of the name without its group
  if (distance_to(near) > std::max<std::size_t>(length, 3))       // V or v is driving.V, nx Nx
    return fmt::format("unknown {} '{}'; see {}", what, word, see);
  return fmt::format("unknown {} '{}': did you mean '{}'?", what, word, near);
}

}  // namespace rupture
