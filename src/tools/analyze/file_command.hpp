// Shared by the analyze commands that read any of our files.
#pragma once

#include <string>
#include <vector>

#include "cli/command_line.hpp"

namespace rupture::tools {

/// Parses the arguments of `analyze NAME`, of which the positional ones, `arguments` in the
/// synopsis, are files.
Parsed parse_file_command(int argc, const char* const* argv, const std::string& name,
                          const std::string& arguments, const std::string& purpose,
                          const po::options_description& options);

/// All files that were named.
std::vector<std::string> files_of(const Parsed& parsed);

/// The one file that was named. Throws UsageError if there is none or more.
std::string file_of(const Parsed& parsed);

}  // namespace rupture::tools
