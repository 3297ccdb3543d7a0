// The interface laws, one row each: what everything but the laws themselves must know of them. Its
// parameters name the law in their rows; what it does in a step is in its own file
// (forces/interface_law.hpp).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "rupture/model/state.hpp"

namespace rupture {

/// The springs between an interface block and the track: the N_s junctions, which have a
/// distribution phi, or one that stands for them.
enum class SpringsPerBlock { N_s, one };

/// When a slipping spring is pinned again: at a time that is drawn when it breaks, or when the law
/// finds it due.
enum class Repinning { at_a_drawn_time, when_due };

/// A number that only some laws remember of each spring; a dataset of /state/junctions. Of a
/// slipping spring it is never 0.
struct SpringMemory {
  JunctionArray<double> Junctions::*array;
  std::string_view name;  ///< of the dataset
  std::string_view unit;
  double minimum;  ///< smallest valid value
};

/// Whether friction at constant speed and the speed of slow slip are known in closed form.
enum class ClosedForm { known, unknown };

struct LawInfo {
  std::string_view name;  ///< as junctions.law has it
  SpringsPerBlock springs;
  Repinning repinning;
  std::string_view slow_slip_off;  ///< what switches slow slip off
  ClosedForm closed_form;
  std::optional<SpringMemory> memory = {};  ///< of a law that pins springs when they are due
};

/// All laws in the order of Law.
const std::vector<LawInfo>& law_table();

const LawInfo& law_info(Law law);

/// The names of these laws; of all in the order of Law if there are none, as in ParameterInfo.
std::vector<std::string_view> law_names(const std::vector<Law>& laws = {});

}  // namespace rupture
