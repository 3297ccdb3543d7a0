// How far and how fast one block slips during an event: fast slip, arrest, slow slip (Fig. 3C); and
// how fast the blocks behind a slow front slip (Figs. 3C inset and 3D).
#pragma once

#include "rupture/analysis/front.hpp"
#include "rupture/analysis/statistics.hpp"

namespace rupture {

/// Displacement of one block, sampled at increasing times.
struct SlipHistory {
  std::span<const double> time;  ///< [s]
  std::span<const double> u_x;   ///< [m]
};

struct SlipMeasure {
  double t_arrest = 0;   ///< end of fast slip: first sample after the rupture at which the block
                         ///< has moved forwards and stops [s]
  double fast_slip = 0;  ///< displacement from the first sample until t_arrest [m]
  double t_end = 0;      ///< when the block next slips fast, or the last sample [s]
  double slow_slip = 0;  ///< displacement from t_arrest to t_end [m]
  double t_from = 0, t_to = 0;  ///< when 20 % and 80 % of the slow slip had happened [s]
  std::optional<LineFit> slow;  ///< straight line through the slip in [t_from, t_to]; slope [m/s]
};

/// Measures the slip after the block's rupture at t_rupture. Once stopped, the block slips slowly
/// until it is faster than `fast_above` [m/s]. No value if it does not stop before the last sample.
std::optional<SlipMeasure> measure_slip(const SlipHistory& history, double t_rupture,
                                        double fast_above);

/// The stretch of time in which a block slips slowly while the front ahead of it is slow [s].
struct SlowSlipTime {
  double from, to;
};

/// How long slow slip is followed; the tools show these as options.
struct SlowSlipCriteria {
  double longest = 1.0;   ///< mean slipping times
  double shortest = 0.5;  ///< the same; a block with less time than this has no value
};

/// The slow slip of `block` begins when waves have had the time H/c_s to end the fast slip, counted
/// from its rupture or, if that comes later, from the front's becoming slow. It is followed until
/// the front leaves its slow stretch, but no longer than `longest`. No value without a slow stretch
/// and for blocks that did not rupture or rupture too late.
std::optional<SlowSlipTime> slow_slip_time(const Parameters& parameters, const Front& front,
                                           std::size_t block, const SlowSlipCriteria& criteria);

/// The blocks with a whole stencil in the slow stretch.
std::vector<std::size_t> slow_blocks(const Front& front);

/// Straight line between 20 % and 80 % of the slip in `time`; slope [m/s].
std::optional<LineFit> fit_slow_slip(const SlipHistory& history, const SlowSlipTime& time);

}  // namespace rupture
