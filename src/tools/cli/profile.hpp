// --profile FILE: properties along the interface, from a table of x.
#pragma once

#include "cli/command_line.hpp"

namespace rupture::tools {

void add_profile_option(po::options_description& options);

/// Sets the parameters: plain values first, then those of --profile, then those that --set and
/// --config give to a part of the interface. Throws UsageError, with the place.
void apply(const Parsed& parsed, Parameters& parameters);

/// An option that may vary along x, of this name: its column in the --profile, or its own text.
/// Throws UsageError if it has neither, or is no such text.
AlongX<double> along_x(const Parsed& parsed, const Parameters& parameters,
                       const std::string& option);

}  // namespace rupture::tools
