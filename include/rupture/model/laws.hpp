// The interface laws, one row each: what everything but the laws themselves must know of them. Its
// parameters name the law in their rows; what it does in a step is in its own file
// (forces/interface_law.hpp).
#pragma once

#include <optional>

#include "rupture/model/state.hpp"

namespace rupture {

/// The springs between an interface block and the track: the N_s junctions, which have a
/// distribution phi, or one that stands for them.
enum class SpringsPerBlock { N_s, one };

/// A number that a law remembers for each spring if it does not draw, when the spring breaks, the
/// time at which it is pinned again, but decides this in each step. A dataset of /state/junctions;
/// never 0 while the spring slips.
struct SpringMemory {
  RowMajorArray<double> Junctions::*array;
  std::string_view name;  ///< of the dataset
  std::string_view unit;
  double minimum;  ///< smallest valid value
};

struct LawInfo {
  std::string_view name;  ///< as junctions.law has it
  SpringsPerBlock springs;
  std::string_view slow_slip_off;  ///< what switches slow slip off
  std::optional<SpringMemory> memory = {};
};

/// All laws in the order of Law.
const std::vector<LawInfo>& law_table();

const LawInfo& law_info(Law law);

/// The names of these laws; of all in the order of Law if there are none, as in ParameterInfo.
std::vector<std::string_view> law_names(const std::vector<Law>& laws = {});

}  // namespace rupture
