// Rupture fronts: where they were when, how fast, and of which type (Fig. 2, physics "Measured
// quantities").
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "rupture/model/parameters.hpp"
#include "rupture/model/rupture.hpp"

namespace rupture {

/// Choices behind a front's type; the tools show them as options.
struct FrontCriteria {
  double slow_below = 1.0 / 20.0;  ///< a front is slow where v_c < slow_below * c_s
  double skip_below_x = 0.02;      ///< the loading or triggering zone does not count [m]
};

/// One interface-length array each; a block that did not rupture has no value.
struct RuptureLine {
  std::vector<double> x;                         ///< position of the blocks [m]
  std::vector<std::optional<double>> t_rupture;  ///< first rupture in the window [s]
};

/// First rupture of every block at times in [from, to] [s].
RuptureLine rupture_line(const Parameters& parameters, std::span<const Rupture> ruptures,
                         double from, double to);

/// Front speed at each block, the inverse slope between the end points of a five-block stencil
/// [m/s]. No value within two blocks of the edges, where a block did not rupture, and where the
/// stencil's ends ruptured in the same step. Negative where the front runs towards the driven edge.
std::vector<std::optional<double>> front_speed(const RuptureLine& line);

enum class FrontType { none, arrested, slow, fast };
std::string_view front_type_name(FrontType type);

/// Whether a front of this type reached the leading edge.
bool spans(FrontType type);

/// A stretch of consecutive blocks over which the front is slow.
struct SlowStretch {
  double x_from = 0, x_to = 0;  ///< first and last block of the stretch [m]
  double t_from = 0, t_to = 0;  ///< when these two ruptured [s]
  double speed = 0;             ///< median of v_c over the stretch [m/s]

  double duration() const { return t_to - t_from; }  ///< [s]

  /// Medians of v_c beyond the loading zone on either side, over the stencils that lie wholly
  /// there.
  std::optional<double> fast_before, fast_after;  ///< [m/s]
};

struct Front {
  RuptureLine line;
  std::vector<std::optional<double>> v_c;
  FrontType type = FrontType::none;
  std::optional<double> x_arrest;   ///< furthest ruptured block if the front did not span [m]
  std::optional<SlowStretch> slow;  ///< the slow stretch that lasted longest
};

/// Measures the front in one rupture line. None: nothing ruptured; arrested: it does not reach the
/// leading edge; slow: it does, and v_c < slow_below c_s somewhere beyond skip_below_x; fast: the
/// rest.
Front measure_front(const Parameters& parameters, RuptureLine line, const FrontCriteria& criteria);

}  // namespace rupture
