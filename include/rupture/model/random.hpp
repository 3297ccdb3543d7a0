// Counter-based random numbers: every draw is a pure function of (seed, block, junction, purpose,
// n), so there is no generator state to keep and no order in which draws must happen.
#pragma once

#include "rupture/model/parameters.hpp"

namespace rupture {

// Elementary functions made of +, -, *, / and sqrt only.
//
// IEEE 754 fixes the result of those five to the last bit; it does not fix log or the normal
// quantile, whose library versions differ between systems and even between processors.

/// Natural logarithm of x, for finite normal x > 0; within 1e-15 relative or 1e-16 absolute.
double exact_log(double x);

/// Quantile of the standard normal distribution for p in (0, 1), relative accuracy about 1e-15.
/// Rational approximations of Wichura, Appl. Stat. 37, 477 (1988), algorithm AS 241.
double normal_quantile(double p);

/// Use of a random number; different purposes never share a counter.
enum class Purpose : std::uint32_t { slipping = 1 };

/// Uniform number in (0, 1), never 0 or 1, with 52 random bits (Philox4x32-10).
double uniform(std::int64_t seed, std::uint32_t block, std::uint32_t junction, Purpose purpose,
               std::uint32_t n);

/// |N(mean, deviation)|, the folded Gaussian T_G(t) + T_G(-t) of the paper, from the n-th uniform
/// number of a junction, which decides how long or how far it slips.
double folded_gaussian(double mean, double deviation, std::int64_t seed, std::uint32_t block,
                       std::uint32_t junction, std::uint32_t n);

/// The n-th slipping time t_R of a junction, drawn from T(t_R) (Methods) [s].
///
/// gaussian: folded_gaussian(t_R, delta_t_R); exponential: -t_R ln u.
double slipping_time(const Parameters& parameters, std::uint32_t block, std::uint32_t junction,
                     std::uint32_t n);

}  // namespace rupture
