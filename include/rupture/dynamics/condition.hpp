// Conditions on what a record holds of each sample, such as "F_T < 300" or
// "pinned_fraction[28] < 0.3 and t > 0.5s".
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "rupture/dynamics/simulation.hpp"

namespace rupture {

/// Whether a text is meant as a condition, be it a wrong one: it compares something.
bool is_condition(std::string_view text);

/// Comparisons of one quantity with one number by <, <=, > or >=, joined by `and` and `or`; `and`
/// binds tighter.
class Condition {
 public:
  /// Throws UsageError, saying what is wrong, unless the slider has all that is compared.
  Condition(const std::string& text, const Parameters& parameters);

  /// What is true now, as in "F_T = 299.97 N < 300 N"; empty if the condition is not.
  std::string what_holds(const Simulation& simulation) const;

 private:
  std::vector<std::vector<std::function<std::string(const Simulation&)>>> alternatives_;
};

}  // namespace rupture
