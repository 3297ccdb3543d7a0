#include "rupture/model/nearest.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rupture {
namespace {

/// Number of single-character edits that turn a into b.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substituted, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

std::size_t distance(std::string_view word, std::string_view candidate) {
  const auto leaf = candidate.substr(candidate.find('.') + 1);
  return std::min(edit_distance(word, candidate), edit_distance(word, leaf) + 1);
}

}  // namespace

std::string_view nearest(std::string_view word, const std::vector<std::string_view>& candidates) {
  return *std::min_element(candidates.begin(), candidates.end(),
                           [&](std::string_view a, std::string_view b) {
                             return distance(word, a) < distance(word, b);
                           });
}

}  // namespace rupture
