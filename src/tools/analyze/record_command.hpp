// Shared by the analyze commands that read one record.
#pragma once

#include <string>

#include "cli/command_line.hpp"
#include "rupture/checkpoint/record.hpp"

namespace rupture::tools {

/// Parsed arguments of a command that reads one record.
struct RecordCommand {
  Parsed parsed;
  Record record;
  double from = 0, to = 0;  ///< window of time that counts [s]
};

/// Adds --from and --to.
void add_window_options(po::options_description& options);

/// Parses the arguments of `analyze NAME` and reads the record. The window is the whole record
/// unless `options` has --from and --to and they were given. The record's ruptures are those that
/// --ruptured-below asks for, if `options` has it. Throws UsageError if the window is empty, beside
/// the record or given with --event, Failure if the record cannot be read, holds no samples or not
/// these ruptures.
RecordCommand read_record_command(int argc, const char* const* argv, const std::string& name,
                                  const std::string& purpose, po::options_description& options);

}  // namespace rupture::tools
