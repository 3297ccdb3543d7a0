// How fast this machine is, measured now, with all that it does besides.
#pragma once

#include "run/forecast.hpp"
#include "rupture/model/state.hpp"

namespace rupture::tools {

/// A slider near the equilibrium under its normal load, at once: uniformly compressed, with
/// unstretched junctions.
State roughly_loaded(const Parameters& parameters);

/// Takes steps from `state` for some tenths of a second and, if the run will look for an
/// equilibrium, finds that of reference_slider().
Speed measure_speed(const Workload& work, const State& state);

}  // namespace rupture::tools
