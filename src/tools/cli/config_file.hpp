// Parameters and options from an INI file, and parameters from the command line.
#pragma once

#include "cli/command_line.hpp"

namespace rupture::tools {

/// What --set and --seed change. Throws UsageError if a parameter is given twice.
ParameterChanges changes_by(const po::parsed_options& given);

/// Options in the file go to `values` unless the command line gave them; other names are
/// parameters. Throws UsageError with the line, or Failure if the file cannot be read.
ParameterChanges read_config(const std::string& path, const po::options_description& options,
                             po::variables_map& values);

}  // namespace rupture::tools
