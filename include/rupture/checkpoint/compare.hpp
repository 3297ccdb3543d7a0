// Where and by how much two contents differ.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rupture/checkpoint/content.hpp"

namespace rupture {

/// How a dataset differs between contents a and b.
enum class Change { values, type, shape, only_in_a, only_in_b };

/// One dataset that differs. The numbers are zero unless `change` is `values`.
struct Difference {
  std::string path;
  Change change = Change::values;
  std::uint64_t count = 0;        ///< elements whose bits differ; 1 for a text
  std::uint64_t first = 0;        ///< index of the first one in storage order; byte for a text
  double largest_absolute = 0;    ///< in the dataset's unit
  double largest_relative = 0;    ///< |a - b| / max(|a|, |b|)
  std::uint64_t largest_ulp = 0;  ///< float64 only: representable numbers from one to the other
};

/// All datasets that differ, sorted by path; empty if the contents are equal. Units are not
/// compared.
std::vector<Difference> diff(const Content& a, const Content& b);

/// The datasets that the content checksum covers: what diff is usually asked about.
Content checksummed_part(const Content& content);

/// Steps from one representable number to the other; at least 1 if their bits differ, so that
/// -0 and +0 are one step apart.
std::uint64_t ulp_distance(double a, double b);

}  // namespace rupture
