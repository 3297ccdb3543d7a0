// How far and how fast one block slips during an event: fast slip, arrest, slow slip (Fig. 3C).
#pragma once

#include <optional>
#include <span>

#include "rupture/analysis/statistics.hpp"

namespace rupture {

/// Displacement of one block, sampled at increasing times.
struct SlipHistory {
  std::span<const double> time;  ///< [s]
  std::span<const double> u_x;   ///< [m]
};

struct SlipMeasure {
  double t_arrest;   ///< end of fast slip: first sample after the fastest at which the block does
                     ///< not move forwards [s]
  double fast_slip;  ///< displacement from the first sample until t_arrest [m]
  double slow_slip;  ///< displacement from t_arrest to the last sample [m]
  double t_from, t_to;          ///< when 20 % and 80 % of the slow slip had happened [s]
  std::optional<LineFit> slow;  ///< straight line through the slip in [t_from, t_to]; slope [m/s]
};

/// Measures the slip after the block's rupture at t_rupture. The fastest slip is sought within
/// `fast_within` [s] of it (half the mean slipping time, say). No value if the block does not stop
/// before the last sample.
std::optional<SlipMeasure> measure_slip(const SlipHistory& history, double t_rupture,
                                        double fast_within);

}  // namespace rupture
