// The programs that write checkpoints and records.
#pragma once

#include "cli/command_line.hpp"

namespace rupture::tools {

extern const Command load_command, restart_command, prepare_command, modify_phi_command,
    finish_command, seal_command;

}  // namespace rupture::tools
