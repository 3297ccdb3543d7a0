// The interface laws, one row each: what everything but the laws themselves must know of them. Its
// parameters name the law in their rows; what it does in a step is in its own file
// (forces/interface_law.hpp).
#pragma once

#include <string_view>
#include <vector>

#include "rupture/model/parameters.hpp"

namespace rupture {

/// The springs between an interface block and the track: the N_s junctions, which have a
/// distribution phi, or one that stands for them.
enum class SpringsPerBlock { N_s, one };

/// How slow slip comes about: as junctions are pinned again one after the other, or at a speed that
/// is imposed for a time, which the state remembers (Junctions::slow_until).
enum class SlowSlip { relaxation, imposed };

/// Whether friction at constant speed and the speed of slow slip are known in closed form.
enum class ClosedForm { known, unknown };

struct LawInfo {
  std::string_view name;  ///< as junctions.law has it
  SpringsPerBlock springs;
  SlowSlip slow_slip;
  std::string_view slow_slip_off;  ///< what switches slow slip off
  ClosedForm closed_form;
};

/// All laws in the order of Law.
const std::vector<LawInfo>& law_table();

const LawInfo& law_info(Law law);

/// The names of all laws in the order of Law.
const std::vector<std::string_view>& law_names();

/// The names of some laws.
std::vector<std::string_view> law_names(const std::vector<Law>& laws);

}  // namespace rupture
