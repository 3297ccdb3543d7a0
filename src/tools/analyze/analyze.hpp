// The commands of the analyze tool.
#pragma once

#include "cli/command_line.hpp"
#include "rupture/checkpoint/checkpoint.hpp"

namespace rupture::tools {

// of records
extern const Command events_command, front_command, classify_command, slip_command,
    slow_slip_command, loading_command;
// of checkpoints, strength also of a shape of phi
extern const Command stress_command, phi_command, strength_command, estimate_command;
// of parameters, and of nothing: what all these measure
extern const Command steady_state_command, quantities_command;
// of any file
extern const Command checksum_command, verify_command, diff_command, show_command, lineage_command;

/// A line about the alarm that stopped a run in the state of a file; nothing if it is of none.
std::string alarm_text(const Content& content);

/// Reads the checkpoint that was named. `wanted` is what the error asks for if there is none.
Checkpoint checkpoint_of(const Parsed& parsed, const std::string& wanted = "a checkpoint");

std::vector<std::string> files_of(const Parsed& parsed);

}  // namespace rupture::tools
