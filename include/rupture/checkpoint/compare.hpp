// Where and by how much two contents differ.
#pragma once

#include <variant>

#include "rupture/checkpoint/content.hpp"

namespace rupture {

/// How a dataset differs between contents a and b.
enum class Change { values, type, shape, only_in_a, only_in_b };

std::string_view name_of(Change change);

/// The largest of some numbers and the element that has it first, in storage order.
template <class T>
struct Largest {
  T value{};
  std::uint64_t index = 0;
};

/// One dataset that differs. The numbers are zero unless `change` is `values`; for a text there is
/// only `count`.
struct Difference {
  std::string path;
  Change change = Change::values;
  std::uint64_t count = 0;          ///< elements whose bits differ; 1 for a text
  std::uint64_t first = 0;          ///< index of the first one in storage order
  Largest<double> absolute = {};    ///< |a - b| in the dataset's unit
  Largest<double> relative = {};    ///< |a - b| / max(|a|, |b|)
  Largest<std::uint64_t> ulp = {};  ///< float64 only: representable numbers from one to the other
};

/// All datasets that differ, sorted by path; empty if the contents are equal. Units are not
/// compared.
std::vector<Difference> diff(const Content& a, const Content& b);

/// The datasets that the content checksum covers, as they count in it: what diff is usually asked
/// about.
Content checksummed_part(const Content& content);

/// One element of a dataset of numbers; `index` in storage order.
using Number = std::variant<double, std::int64_t>;
Number number_at(const Dataset& dataset, std::uint64_t index);

/// The indices of element `index`, slowest dimension first; none in a scalar.
std::vector<std::uint64_t> indices_at(const Shape& shape, std::uint64_t index);

}  // namespace rupture
