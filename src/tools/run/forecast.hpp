// Time, memory and disk of a run, forecast from its plan and how fast this machine is.
//
// The constants come from measurements of lattices from 57 x 31 to 449 x 241 blocks (x86-64, Debian
// 12, gcc 12.2).
#pragma once

#include <string>

#include "run/plan.hpp"

namespace rupture::tools {

/// What is left of the run needs this: a few lines for people, or the same as one JSON object.
/// Takes steps for some tenths of a second and, if the run will look for an equilibrium, finds that
/// of a smaller slider.
std::string forecast(const RunPlan& plan, DryRun how);

/// A slider near the equilibrium under its normal load, at once: uniformly compressed, with
/// unstretched junctions.
State roughly_loaded(const Parameters& parameters);

}  // namespace rupture::tools
