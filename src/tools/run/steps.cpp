#include "run/steps.hpp"

#include <algorithm>

#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {

std::int64_t block_at(const Parameters& p, double x, const std::string& option) {
  const double block = std::round(x / block_spacing(p));
  if (block <= static_cast<double>(p.Nx - 1)) return static_cast<std::int64_t>(block);
  throw UsageError("--{} {:g} is beyond the interface, which ends at {:g} m", option, x, p.L);
}

Interval interval(const Parameters& p, const Clock& clock, double t, std::string_view option) {
  constexpr double rounding = 1e-9, half = 0.5 - 1e-6;  // a tie is decided once, by `zero`
  steps_in(p, t);                                       // not too long
  const std::int64_t zero = step_at(p, clock, 0.0);
  const double offset = std::clamp(-time_at(p, clock, zero) / p.dt, -half, half);
  if (t >= p.dt * (1.0 - rounding)) return {std::max(t, p.dt), p.dt, zero, offset};
  throw UsageError("--{} must be at least one time step, {:g} s (got {:g} s)", option, p.dt, t);
}

}  // namespace rupture::tools
