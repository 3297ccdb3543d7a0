// What the analyze commands read: a record, a checkpoint, or any of our files.
#pragma once

#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/record.hpp"

namespace rupture::tools {

/// A record, and how it is to be measured.
struct RecordCommand {
  po::variables_map values;
  Record record;
  double from = 0, to = 0;  ///< window of time that counts [s]
};

/// Adds --from and --to.
void add_window_options(po::options_description& options);

/// Reads the record. The window is the whole record unless --from and --to were given. The record's
/// ruptures are those that --ruptured-below asks for, if the command has it. Throws UsageError if
/// the window is empty, beside the record or given with --event, Failure if the record cannot be
/// read, holds no samples or not these ruptures.
RecordCommand record_of(const Parsed& parsed);

/// Reads the checkpoint that was named. `wanted` stands in the sentence if there is none.
Checkpoint checkpoint_of(const Parsed& parsed, const std::string& wanted = "a checkpoint");

/// All files that were named.
std::vector<std::string> files_of(const Parsed& parsed);

}  // namespace rupture::tools
