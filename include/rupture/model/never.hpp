// The time that stands for "never"; apart, so that the kernels need no other header for it.
#pragma once

namespace rupture {

inline constexpr double kNever = 1e300;  ///< later than every simulation [s]

}  // namespace rupture
