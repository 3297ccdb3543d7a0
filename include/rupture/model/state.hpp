// Everything that changes in time. Plain data; State and Parameters together determine the future.
#pragma once

#include "rupture/model/field.hpp"
#include "rupture/model/never.hpp"
#include "rupture/model/parameters.hpp"

namespace rupture {

/// The junctions of all interface blocks; arrays of shape [Nx][springs_per_block].
struct Junctions {
  /// A repin time later than every simulation: marks a pinned junction.
  static constexpr double never = kNever;
  /// The repin time of a slipping spring that is pinned when its law finds it due.
  static constexpr double unknown = 0.0;

  /// Attachment point x_ij on the track, measured like u_x from the undeformed block position [m].
  RowMajorArray<double> attachment;
  /// Time at which a slipping junction is pinned again [s]; `never` while it is pinned.
  RowMajorArray<double> repin_time;
  /// How many slipping times this junction has drawn so far.
  RowMajorArray<std::uint32_t> draws;
  /// Simplified law only, else empty: time until which the attachment point moves by itself [s];
  /// negative where it moves towards -x, 0 where the spring has never broken.
  RowMajorArray<double> slow_until;
  /// Distance law only, else empty: how far a slipping junction still slides [m]; 0 while pinned.
  RowMajorArray<double> slip_left;
};

/// Position of the driving point: x_drive(n) = origin_position + V (n - origin_step) dt.
struct Drive {
  std::int64_t origin_step = 0;
  double origin_position = 0;  ///< [m]
};

/// Time of the steps: t(n) = origin_time + (n - origin_step) dt. The origin is where dt changed
/// last.
struct Clock {
  std::int64_t origin_step = 0;
  double origin_time = 0;  ///< [s]

  bool operator==(const Clock&) const = default;
};

struct State {
  State() = default;
  /// The undeformed slider at rest with every junction pinned and unstretched.
  explicit State(const Parameters& parameters);

  Parameters made_with;   ///< give the rest its meaning: other ones are for continued()
  std::int64_t step = 0;  ///< steps done, whatever dt they had
  Clock clock;
  Drive drive;
  Field u_x, u_z;  ///< displacement from the undeformed lattice [m]
  Field v_x, v_z;  ///< velocity [m/s]
  Field f_x, f_z;  ///< net force on each block at this step [N]
  Junctions junctions;
};

/// Throws UsageError unless the state was made with these parameters.
void refuse_other_parameters(const State& state, const Parameters& parameters);

/// Time of `step`, not before the clock's origin [s].
double time_at(const Parameters& parameters, const Clock& clock, std::int64_t step);

/// The number of steps nearest to a duration [s]. Throws UsageError if it is not below 2^53.
std::int64_t steps_in(const Parameters& parameters, double duration);

/// The step nearest to time t [s]; throws as steps_in().
std::int64_t step_at(const Parameters& parameters, const Clock& clock, double t);

/// Simulated time of the state [s].
double time(const Parameters& parameters, const State& state);

/// Position x_drive of the driving point at `step` [m].
double drive_position(const Parameters& parameters, const Drive& drive, std::int64_t step);

/// Part of continued(): gives the state the dt and V of `after`. Its time and its
/// driving point stay where they are.
void change_pace(const Parameters& before, const Parameters& after, State& state);

/// Force of the driving spring, F_T = K (x_drive - u_x) at the driven block [N].
double driving_force(const Parameters& parameters, const State& state);

inline bool is_slipping(double repin_time) {
  return repin_time < Junctions::never;
}

/// Fraction of block i's junctions that are pinned.
double pinned_fraction(const Junctions& junctions, Eigen::Index i);

}  // namespace rupture
