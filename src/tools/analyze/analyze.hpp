// The commands of the analyze tool.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/quantity.hpp"

namespace rupture::tools {

using AddOptions = void (*)(po::options_description&);

/// Everything about one command; --help, --describe and `analyze quantities` come from it.
struct Command {
  std::string_view call;  ///< its name, and its arguments in the synopsis
  const char* input;      ///< kind of the positional arguments; empty: none are taken
  const char* summary;    ///< a line for lists of commands
  const char* purpose;
  std::array<AddOptions, 4> options;  ///< in the order of --help
  int (*run)(const Parsed&);
  Quantities (*quantities)() = nullptr;  ///< rows of what it measures, whatever their values
  UsesParameters uses_parameters = UsesParameters::no;

  std::string name() const { return std::string(call.substr(0, call.find(' '))); }
};

// of records
extern const Command events_command, front_command, classify_command, slip_command,
    slow_slip_command, loading_command;
// of checkpoints, strength also of a shape of phi
extern const Command stress_command, phi_command, strength_command, estimate_command;
// of parameters, and of nothing: what all these measure
extern const Command steady_state_command, quantities_command;
// of any file
extern const Command checksum_command, verify_command, diff_command, show_command, lineage_command;

/// All of them, in the order of the help.
const std::vector<const Command*>& commands();

}  // namespace rupture::tools
