// Shared by the analyze commands that read one checkpoint.
#pragma once

#include <string>

#include "cli/command_line.hpp"
#include "rupture/checkpoint/checkpoint.hpp"

namespace rupture::tools {

/// Parsed arguments of a command that reads one checkpoint.
struct CheckpointCommand {
  Parsed parsed;
  Checkpoint checkpoint;
};

/// Adds --json and --csv, parses the arguments of `analyze NAME` and reads the checkpoint.
CheckpointCommand read_checkpoint_command(int argc, const char* const* argv,
                                          const std::string& name, const std::string& purpose,
                                          po::options_description& options);

}  // namespace rupture::tools
