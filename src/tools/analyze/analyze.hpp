// The commands of the analyze tool. Each parses its own arguments.
#pragma once

#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/quantity.hpp"

namespace rupture::tools {

/// One command: `run` gets argv from the command's name on.
struct Command {
  std::string name;
  std::string purpose;
  int (*run)(int argc, const char* const* argv);
  Quantities (*quantities)() = nullptr;  ///< rows of what it measures, whatever their values
};

/// All commands, in the order of the help.
const std::vector<Command>& commands();

// of records
int analyze_events(int argc, const char* const* argv);
Quantities events_quantities();
int analyze_front(int argc, const char* const* argv);
Quantities front_quantities();
int analyze_classify(int argc, const char* const* argv);
Quantities classify_quantities();
int analyze_slow_slip(int argc, const char* const* argv);
Quantities slow_slip_quantities();
int analyze_slip(int argc, const char* const* argv);
Quantities slip_quantities();
int analyze_loading(int argc, const char* const* argv);
Quantities loading_quantities();

// of checkpoints
int analyze_stress(int argc, const char* const* argv);
Quantities stress_quantities();
int analyze_phi(int argc, const char* const* argv);
Quantities phi_quantities();
int analyze_strength(int argc, const char* const* argv);  // or of a shape of phi
Quantities strength_quantities();
int analyze_estimate(int argc, const char* const* argv);
Quantities estimate_quantities();

// of parameters
int analyze_steady_state(int argc, const char* const* argv);
Quantities steady_state_quantities();

// of nothing: what all these measure
int analyze_quantities(int argc, const char* const* argv);

// of any file
int analyze_checksum(int argc, const char* const* argv);
int analyze_verify(int argc, const char* const* argv);
int analyze_diff(int argc, const char* const* argv);
int analyze_show(int argc, const char* const* argv);
int analyze_lineage(int argc, const char* const* argv);

}  // namespace rupture::tools
