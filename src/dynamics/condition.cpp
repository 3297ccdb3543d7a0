#include "rupture/dynamics/condition.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include "rupture/model/error.hpp"
#include "rupture/model/user_text.hpp"

namespace rupture {
namespace {

using S = Simulation;
using Block = std::int64_t;

/// With the value that a sample of a record has, for each block if there is an `index`.
struct Quantity {
  std::string_view name, index, unit;
  double (*of)(const S&, Block block);
};

double pinned_fraction_of(const S& s, Block block) {
  return pinned_fraction(s.state().junctions, block);
}

constexpr std::array kQuantities = {
    Quantity{"t", "", "s", [](const S& s, Block) { return s.time(); }},
    Quantity{"time", "", "s", [](const S& s, Block) { return s.time(); }},
    Quantity{"F_T", "", "N", [](const S& s, Block) { return s.F_T(); }},
    Quantity{"x_drive", "", "m", [](const S& s, Block) { return s.x_drive(); }},
    Quantity{"pinned_fraction", "[BLOCK]", "1", pinned_fraction_of},
    Quantity{"p", "[BLOCK]", "N", [](const S& s, Block i) { return s.p().begin()[i]; }},
    Quantity{"tau", "[BLOCK]", "N", [](const S& s, Block i) { return s.tau().begin()[i]; }},
    Quantity{"u_x", "[BLOCK]", "m", [](const S& s, Block i) { return s.state().u_x(0, i); }},
};

/// That of "F_T", or of "p[28]" whatever is in the brackets.
const Quantity& quantity_of(std::string_view text) {
  const std::string_view name = text.substr(0, text.find('['));
  std::vector<std::string> names;
  for (const auto& row : kQuantities) {
    if (row.name == name && row.index.empty() == (name == text)) return row;
    names.push_back(fmt::format("{}{}", row.name, row.index));
  }
  throw UsageError("a condition cannot be about '{}': write {}", text, alternatives(names));
}

/// The number in "p[28]".
Block block_of(std::string_view text, const Parameters& p) {
  const auto begin = text.find('[') + 1;
  const auto block = number_in(text.substr(begin, text.size() - begin - 1), "1").value_or(-1.0);
  if (text.ends_with(']') && block >= 0.0 && block <= static_cast<double>(p.Nx - 1) &&
      block == std::floor(block)) {
    return static_cast<Block>(block);
  }
  throw UsageError("there is no '{}': blocks are 0, at the driven side, to {}", text, p.Nx - 1);
}

/// Says what is true, if it is. Between words are single blanks.
std::function<std::string(const S&)> comparison(std::string_view text, const Parameters& p) {
  const auto at = text.find_first_of("<>");
  if (at == text.npos) {
    throw UsageError("'{}' compares nothing by < <= > or >=: write F_T < 300 or t > 0.5s", text);
  }
  const std::string sign(text.substr(at, text.substr(at + 1).starts_with('=') ? 2 : 1));
  std::string name(text.substr(0, at));
  if (name.ends_with(' ')) name.pop_back();
  std::string_view number = text.substr(at + sign.size());
  if (number.starts_with(' ')) number.remove_prefix(1);
  const Quantity& row = quantity_of(name);
  const Block block = row.index.empty() ? 0 : block_of(name, p);
  const double limit = number_in(number, row.unit).value_or(NAN);
  if (!std::isfinite(limit)) {
    throw UsageError("in '{}', '{}' is not a finite number{}", text, number, units_taken(row.unit));
  }
  const std::string unit = row.unit == "1" ? "" : fmt::format(" {}", row.unit);
  return [=, &row](const S& now) {
    const double value = row.of(now, block);
    const bool is_true =
        value == limit ? sign.ends_with('=') : (value < limit) == sign.starts_with('<');
    if (!is_true) return std::string();
    return fmt::format("{} = {:.9g}{} {} {}{}", name, value, unit, sign, limit, unit);
  };
}

}  // namespace

bool is_condition(std::string_view text) {
  return text.find_first_of("<>=") != text.npos;
}

Condition::Condition(const std::string& text, const Parameters& p) {
  std::istringstream words(text);
  std::string one;
  alternatives_.emplace_back();
  for (std::string word; words >> word;) {
    if (word != "and" && word != "or") {
      one += (one.empty() ? "" : " ") + word;
      continue;
    }
    alternatives_.back().push_back(comparison(std::exchange(one, ""), p));
    if (word == "or") alternatives_.emplace_back();
  }
  alternatives_.back().push_back(comparison(one, p));
}

std::string Condition::what_holds(const Simulation& now) const {
  for (const auto& comparisons : alternatives_) {
    std::vector<std::string> found;
    for (const auto& comparison : comparisons) found.push_back(comparison(now));
    if (std::ranges::count(found, "") == 0) return fmt::format("{}", fmt::join(found, " and "));
  }
  return "";
}

}  // namespace rupture
