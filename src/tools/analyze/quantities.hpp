// The values that the commands of analyze report as JSON: name, unit and meaning of each.
#pragma once

#include <string>
#include <vector>

namespace rupture::tools {

/// A number, text or truth value in the JSON that a command prints.
struct Quantity {
  std::string name;  ///< e.g. "front.v_c.*": the command, then the path; * stands for an index
  std::string unit;  ///< SI, "1" for none; empty for texts and truth values
  std::string help;  ///< one line
};

/// All quantities of the commands that measure, command by command. A test demands that this list
/// and what they print agree.
std::vector<Quantity> quantities();

}  // namespace rupture::tools
