// Suggestions for mistyped names.
#pragma once

#include <string_view>
#include <vector>

namespace rupture {

/// The candidate that needs the fewest single-character edits to become `word`; of a candidate
/// "group.name" the part behind the dot counts too. `candidates` must not be empty.
std::string_view nearest(std::string_view word, const std::vector<std::string_view>& candidates);

}  // namespace rupture
