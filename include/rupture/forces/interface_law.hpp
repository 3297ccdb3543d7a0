// Friction between interface blocks and track, as the step (dynamics/simulation.hpp) asks for it.
//
// A law moves the junctions in State and says which force they exert; it keeps nothing that does
// not follow from State and Parameters, so that a run may be split anywhere. One class per choice
// of `junctions.law`.
#pragma once

#include <memory>

#include "rupture/forces/kernels.hpp"
#include "rupture/model/state.hpp"

namespace rupture {

class InterfaceLaw {
 public:
  InterfaceLaw(const InterfaceLaw&) = delete;
  InterfaceLaw& operator=(const InterfaceLaw&) = delete;
  virtual ~InterfaceLaw() = default;

  /// How many junctions broke or were pinned again.
  struct Changes {
    std::int64_t broken = 0;
    std::int64_t repinned = 0;
  };
  /// Moves every junction to time `t` [s] with the interface blocks at u_x [m] under the given
  /// contact. v_x is the half-kicked velocity, with which the blocks came here from the last step
  /// [m/s].
  virtual Changes update(const double* u_x, const double* v_x, const ContactView& contact,
                         double t) = 0;

  /// Friction force on each block, positive towards -x [N].
  virtual void friction(const double* u_x, const ContactView& contact, double* tau) const = 0;

  /// Breaks spring j of block i, with the block at u and w = f_N / k_ij [m], at time t [s].
  virtual void break_spring(Eigen::Index i, Eigen::Index j, double u, double w, double t) = 0;
  /// It slips from time t on. For laws with N_s junctions per block, which can follow each other.
  virtual void start_slipping(Eigen::Index /*i*/, Eigen::Index /*j*/, double /*t*/) {}

  /// Number of pinned junctions of each block, of springs_per_block().
  virtual const std::vector<std::int32_t>& pinned() const = 0;

 protected:
  InterfaceLaw() = default;
};

/// The law that `parameters.law` names, working on `junctions`, which must outlive it.
std::unique_ptr<InterfaceLaw> make_law(const Parameters& parameters, Junctions& junctions);

/// Part of continued(): makes junctions of the law of `before` junctions of that of `after`, of
/// which both have N_s per block, at time t [s]. Unless both draw the time at which a spring is
/// pinned again, those that slip now begin to slip anew under the new law.
void change_law(const Parameters& before, const Parameters& after, double t, Junctions& junctions);

}  // namespace rupture
