// The options with which a run ends before its last step.
#pragma once

#include "cli/command_line.hpp"
#include "run/steps.hpp"
#include "rupture/model/rupture.hpp"

namespace rupture::tools {

/// A run that ends early takes at most this long if nothing else was given [s].
inline constexpr double kLongestRun = 10.0;

void add_early_end_options(po::options_description& options);
bool may_end_early(const po::variables_map& values);
/// Throws UsageError.
EarlyEnd early_end(const po::variables_map& values, const Parameters& parameters);

}  // namespace rupture::tools
