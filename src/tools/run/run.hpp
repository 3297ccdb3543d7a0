// Running a simulation from the command line: what load and restart have in common.
#pragma once

#include "run/plan.hpp"

namespace rupture::tools {

/// Runs `start` until the stop rule says so, writes everything asked for and prints the invariants.
/// With DryRun, prints what that would need instead, and writes nothing.
/// Nothing is run if an output may not be written or would replace `input` (empty for none: the run
/// begins with an equilibrium, which costs something, too). The
/// provenance of `start` already names this tool. Throws Interrupted if a signal came; the run can
/// then be resumed. Returns kDone.
int simulate(Checkpoint start, const StopRule& rule, const RunOptions& options,
             const std::filesystem::path& input);

}  // namespace rupture::tools
