#include "rupture/dynamics/condition.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "rupture/model/error.hpp"
#include "rupture/model/user_text.hpp"

namespace rupture {
namespace {

using S = Simulation;
using Block = std::size_t;

/// With the value that a sample of a record has: of each block, if there is an `index`.
struct SampledQuantity {
  std::string_view name, unit, index;
  double (*of)(const S&, Block);
};

double time_of(const S& now, Block) {
  return now.time();
}
double pinned_fraction_of(const S& now, Block i) {
  return pinned_fraction(now.state().junctions, static_cast<Eigen::Index>(i));
}

constexpr std::array kQuantities = {
    SampledQuantity{"t", "s", "", time_of},
    SampledQuantity{"time", "s", "", time_of},
    SampledQuantity{"F_T", "N", "", [](const S& now, Block) { return now.F_T(); }},
    SampledQuantity{"x_drive", "m", "", [](const S& now, Block) { return now.x_drive(); }},
    SampledQuantity{"pinned_fraction", "1", "[BLOCK]", pinned_fraction_of},
    SampledQuantity{"p", "N", "[BLOCK]", [](const S& now, Block i) { return now.p()[i]; }},
    SampledQuantity{"tau", "N", "[BLOCK]", [](const S& now, Block i) { return now.tau()[i]; }},
    SampledQuantity{"u_x", "m", "[BLOCK]",
                    [](const S& now, Block i) { return now.state().u_x.row(0)[i]; }},
};

struct Order {
  std::string_view sign;
  bool (*holds)(double, double);
};
constexpr std::array kOrders = {  // of two that begin alike, the longer one first
    Order{"<=", [](double a, double b) { return a <= b; }},
    Order{">=", [](double a, double b) { return a >= b; }},
    Order{"<", [](double a, double b) { return a < b; }},
    Order{">", [](double a, double b) { return a > b; }}};

std::string_view trimmed(std::string_view text) {
  const auto first = std::min(text.find_first_not_of(' '), text.size());
  return text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

/// The parts between the words, of which there is at least one.
std::vector<std::string_view> split_at(std::string_view word, std::string_view text) {
  std::vector<std::string_view> parts;
  for (auto at = text.find(word); at != text.npos; at = text.find(word)) {
    parts.push_back(text.substr(0, at));
    text.remove_prefix(at + word.size());
  }
  parts.push_back(text);
  return parts;
}

const SampledQuantity& quantity_named(std::string_view name) {
  const auto* const found = std::ranges::find(kQuantities, name, &SampledQuantity::name);
  if (found != kQuantities.end()) return *found;
  std::vector<std::string> names;
  for (const auto& row : kQuantities) names.push_back(fmt::format("{}{}", row.name, row.index));
  throw UsageError("a condition cannot be about '{}': write {}", name, alternatives(names));
}

/// The block of an index such as "[28]"; 0 if there is none, where there must be none.
Block block_in(std::string_view index, const SampledQuantity& quantity, const Parameters& p) {
  const std::string_view name = quantity.name;
  if (quantity.index.empty() && index.empty()) return 0;
  if (quantity.index.empty()) throw UsageError("{} belongs to no block: leave {} out", name, index);
  const char* const end = index.data() + index.size();
  Block block = 0;
  const auto [stop, error] =
      std::from_chars(index.data() + std::min<Block>(index.size(), 1), end, block);
  const bool is_whole = error == std::errc{} && std::string_view(stop, end) == "]";
  if (is_whole && block < static_cast<Block>(p.Nx)) return block;
  throw UsageError(
      "{} has a value for each block: write {}[0], at the driven side, to {}[{}] (got '{}{}')",
      name, name, name, p.Nx - 1, name, index);
}

/// Says what is true, if it is.
std::function<std::string(const S&)> comparison(std::string_view text, const Parameters& p) {
  const auto at = std::min(text.find_first_of("<>"), text.size());
  const auto* const order = std::ranges::find_if(
      kOrders, [&](const Order& row) { return text.substr(at).starts_with(row.sign); });
  if (order == kOrders.end()) {
    throw UsageError("'{}' compares nothing by < <= > or >=: write F_T < 300 or t > 0.5s", text);
  }
  const std::string_view left = trimmed(text.substr(0, at));
  const std::string_view right = trimmed(text.substr(at + order->sign.size()));
  const std::string_view index = left.substr(std::min(left.find('['), left.size()));
  const SampledQuantity& row = quantity_named(trimmed(left.substr(0, left.find('['))));
  const Block block = block_in(index, row, p);
  const auto limit = number_in(right, row.unit);
  if (!limit || !std::isfinite(*limit)) {
    throw UsageError("in '{}', '{}' is not a finite number{}", text, right, units_taken(row.unit));
  }
  const std::string unit = row.unit == "1" ? "" : fmt::format(" {}", row.unit);
  return [=, &row, name = std::string(left), limit = *limit](const S& now) {
    const double value = row.of(now, block);
    if (!order->holds(value, limit)) return std::string();
    return fmt::format("{} = {:.9g}{} {} {}{}", name, value, unit, order->sign, limit, unit);
  };
}

}  // namespace

bool is_condition(std::string_view text) {
  return text.find_first_of("<>=") != text.npos;
}

Condition::Condition(std::string_view text, const Parameters& p) {
  for (const auto alternative : split_at(" or ", text)) {
    auto& comparisons = alternatives_.emplace_back();
    for (const auto part : split_at(" and ", alternative)) {
      comparisons.push_back(comparison(trimmed(part), p));
    }
  }
}

std::string Condition::what_holds(const Simulation& now) const {
  for (const auto& comparisons : alternatives_) {
    std::vector<std::string> true_ones;
    for (const auto& comparison : comparisons) true_ones.push_back(comparison(now));
    if (std::ranges::count(true_ones, "") == 0)
      return fmt::format("{}", fmt::join(true_ones, " and "));
  }
  return "";
}

}  // namespace rupture
