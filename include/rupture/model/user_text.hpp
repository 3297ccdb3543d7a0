// What users write: numbers with units, and names that they mistype.
#pragma once

#include <fmt/ranges.h>

#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rupture {

/// The number in `text` counted in `unit`, as text without a unit: "10ms" is "10e-3" if that is
/// "s". Only the exponent is shifted, so that reading it rounds once, as for the plain number. A
/// number without a unit comes back as it is, but for a plus in front; none if the unit is another
/// one, or there is no number in front of it.
std::optional<std::string> in_unit(std::string_view text, std::string_view unit);

/// The number in `text` in `unit`, infinite if it is beyond all doubles; none if in_unit() has
/// none.
std::optional<double> number_in(std::string_view text, std::string_view unit);

/// "a", "a or b", or "a, b or c".
std::string alternatives(const auto& words) {
  const auto last = std::prev(words.end());
  return fmt::format("{}{}{}", fmt::join(words.begin(), last, ", "),
                     last == words.begin() ? "" : " or ", *last);
}

/// What may stand behind a number of this unit, such as " (unit s, ms, us or ns)"; "" if nothing
/// may.
std::string units_taken(std::string_view unit);

/// "unknown tool 'lod': did you mean 'load'?", with the candidate that needs the fewest
/// single-character edits to become `word`; another group in front of a dot counts as one.
/// "unknown tool 'movement'; see rupture help" if more than half of the name would have to change.
/// `candidates` must not be empty.
std::string unknown_text(std::string_view what, std::string_view word,
                         const std::vector<std::string_view>& candidates, std::string_view see);

}  // namespace rupture
