// The commands of the analyze tool. Each parses its own arguments.
#pragma once

#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/report.hpp"

namespace rupture::tools {

/// One command: `run` gets argv from the command's name on.
struct Command {
  std::string name;
  std::string purpose;
  int (*run)(int argc, const char* const* argv);
};

// of records
int analyze_events(int argc, const char* const* argv);
int analyze_front(int argc, const char* const* argv);
int analyze_classify(int argc, const char* const* argv);
int analyze_slow_slip(int argc, const char* const* argv);
int analyze_slip(int argc, const char* const* argv);
int analyze_loading(int argc, const char* const* argv);

// of checkpoints
int analyze_stress(int argc, const char* const* argv);
int analyze_phi(int argc, const char* const* argv);
int analyze_strength(int argc, const char* const* argv);  // or of a shape of phi
int analyze_estimate(int argc, const char* const* argv);

// of parameters
int analyze_steady_state(int argc, const char* const* argv);

// of nothing: what all these measure
int analyze_quantities(int argc, const char* const* argv);

// of any file
int analyze_checksum(int argc, const char* const* argv);
int analyze_verify(int argc, const char* const* argv);
int analyze_diff(int argc, const char* const* argv);
int analyze_show(int argc, const char* const* argv);
int analyze_lineage(int argc, const char* const* argv);

}  // namespace rupture::tools
