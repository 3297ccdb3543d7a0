#include "rupture/model/spanning.hpp"

#include "rupture/model/derived.hpp"

namespace rupture {

bool spans(const Parameters& p, const FirstRuptures& first, double skip_below_x) {
  if (!first.back()) return false;
  std::size_t blocks = 0, ruptured = 0, before_edge = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (block_position(p, static_cast<std::int64_t>(i)) <= skip_below_x) continue;
    ++blocks;
    if (first[i]) ++ruptured;
    if (first[i] && *first[i] < *first.back()) ++before_edge;
  }
  return 2 * ruptured > blocks && before_edge > 0;
}

}  // namespace rupture
