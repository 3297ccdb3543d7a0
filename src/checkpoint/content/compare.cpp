#include "rupture/checkpoint/compare.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>

#include "rupture/checkpoint/checksum.hpp"
#include "rupture/checkpoint/parameters_content.hpp"

namespace rupture {
namespace {

// Steps from one representable number to the other; at least 1 if their bits differ, so that -0 and
// +0 are one step apart.
std::uint64_t ulp_distance(double a, double b) {
  // Maps the bits to integers in the order of the numbers: ..., -min, -0, +0, +min, ...
  const auto ordered = [](double x) {
    constexpr std::uint64_t sign = std::uint64_t{1} << 63U;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    return (bits & sign) != 0 ? ~bits : bits | sign;
  };
  const std::uint64_t x = ordered(a);
  const std::uint64_t y = ordered(b);
  return x > y ? x - y : y - x;
}

template <class T>
void keep_larger(Largest<T>& largest, T value, std::uint64_t index) {
  if (value > largest.value) largest = {value, index};
}

template <class T>
void add_element(Difference& difference, T a, T b, std::uint64_t index) {
  if (difference.count++ == 0) {
    difference.first = index;
    difference.absolute = difference.relative = {0.0, index};
    difference.ulp = {0, index};
  }
  const auto x = static_cast<double>(a);
  const auto y = static_cast<double>(b);
  const double absolute = std::abs(x - y);
  const double scale = std::max(std::abs(x), std::abs(y));
  keep_larger(difference.absolute, absolute, index);
  if (scale > 0) keep_larger(difference.relative, absolute / scale, index);
  if constexpr (std::is_same_v<T, double>) keep_larger(difference.ulp, ulp_distance(a, b), index);
}

template <class T>
void compare_elements(Difference& difference, const Dataset& a, const Dataset& b) {
  const std::size_t count = a.bytes.size() / sizeof(T);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = i * sizeof(T);
    if (std::memcmp(a.bytes.data() + at, b.bytes.data() + at, sizeof(T)) == 0) continue;
    add_element(difference, element<T>(a, i), element<T>(b, i), i);
  }
}

void compare_values(Difference& difference, const Dataset& a, const Dataset& b) {
  if (a.type == DataType::text) {
    difference.count = 1;
    return;
  }
  with_number_of(a.type, [&]<class T>(T) { compare_elements<T>(difference, a, b); });
}

std::optional<Change> change_between(const Dataset& a, const Dataset& b) {
  if (a.type != b.type) return Change::type;
  if (a.shape != b.shape) return Change::shape;
  if (a.bytes != b.bytes) return Change::values;
  return std::nullopt;
}

}  // namespace

std::string_view name_of(Change change) {
  constexpr std::array<std::string_view, 5> names = {"values", "type", "shape", "only_in_a",
                                                     "only_in_b"};
  return names.at(static_cast<std::size_t>(change));
}

std::vector<Difference> diff(const Content& a, const Content& b) {
  std::vector<Difference> differences;
  for (const auto& [path, dataset] : a) {
    const auto other = b.find(path);
    if (other == b.end()) {
      differences.push_back({.path = path, .change = Change::only_in_a});
    } else if (const auto change = change_between(dataset, other->second)) {
      Difference difference{.path = path, .change = *change};
      if (change == Change::values) compare_values(difference, dataset, other->second);
      differences.push_back(difference);
    }
  }
  for (const auto& [path, dataset] : b) {
    if (!a.contains(path)) differences.push_back({.path = path, .change = Change::only_in_b});
  }
  std::ranges::sort(differences, {}, &Difference::path);
  return differences;
}

Content checksummed_part(const Content& content) {
  const auto stored = [](const auto& entry) {
    return is_checksummed(entry.first) && !entry.first.starts_with("/parameters/");
  };
  Content part = counted_parameters(content);
  std::copy_if(content.begin(), content.end(), std::inserter(part, part.end()), stored);
  return part;
}

Number number_at(const Dataset& dataset, std::uint64_t index) {
  return with_number_of(dataset.type, [&]<class T>(T) -> Number {
    using Wide = std::conditional_t<std::is_floating_point_v<T>, double, std::int64_t>;
    return static_cast<Wide>(element<T>(dataset, index));
  });
}

std::vector<std::uint64_t> indices_at(const Shape& shape, std::uint64_t index) {
  std::vector<std::uint64_t> indices(shape.size());
  for (std::size_t d = shape.size(); d-- > 0; index /= shape[d]) indices[d] = index % shape[d];
  return indices;
}

}  // namespace rupture
