// The model in plain terms: one step of m a = sum of forces (docs/model.md), written to be read.
// Simulation does the same faster, for which it merges loops; its every step must equal this one up
// to the order of sums. Tests compare them, and use this one for systems that are no whole slider.
#pragma once

#include <functional>

#include "rupture/forces/bulk.hpp"
#include "rupture/forces/interface_law.hpp"

namespace rupture {

/// Adds forces [N] to f_x and f_z of a state, whose blocks are at their new positions.
using AddForces = std::function<void(State&)>;

/// One step of velocity Verlet, dt [s], from a complete state to a complete state. The forces are
/// those of springs and dampers between blocks, and those that `add_forces` adds.
void plain_step(const Parameters& p, double dt, Bulk& bulk, State& state,
                const AddForces& add_forces);

/// Moves the junctions to the new positions, then adds what acts on the slider from outside: the
/// support and F_N on its faces, friction tau_i on its lowest row, and the driving force F_T.
void add_outer_forces(const Parameters& p, InterfaceLaw& law, State& state);

}  // namespace rupture
