// Claim 1G: friction of one block that slides at constant speed v, against renewal theory, both as
// in analysis/slow_slip.hpp, where the theory is derived.
#include <gtest/gtest.h>

#include "rupture/analysis/slow_slip.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::testing {

/// A block under the mean normal force of the reference slider.
SteadySliding block_of(const Parameters& p) {
  return {p, mean_normal_force(Parameters{})};
}

// Claim 1G allows 1 %, but then t_R could be wrong by a quarter. 4000 cycles leave 0.05 % of
// scatter at most; a step is 1/4000 of a cycle, and events come up to a step late twice in a cycle.
constexpr double kTolerance = 0.002, kStep = 2.0 / 4000.0;

TEST(SteadySliding, follows_renewal_theory_and_falls_monotonically_with_speed) {
  Parameters exponential, keeping_f_slip;
  exponential.slipping_times = SlippingTimes::exponential;
  keeping_f_slip.f_new = NewForce::f_slip;
  for (const Parameters& p : {Parameters{}, exponential, keeping_f_slip}) {
    double before = 1.0;
    for (const double v : {1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 1e-1, 1.0}) {  // [m/s]
      const double expected = renewal_friction(block_of(p), v);
      const Mean measured = measured_friction(block_of(p), v);
      EXPECT_NEAR(measured.value, expected, kTolerance * expected) << v << " m/s";
      EXPECT_NEAR(measured.value, expected, 4.0 * measured.standard_error + kStep * expected);
      EXPECT_LT(measured.standard_error, kTolerance / 2.0 * expected) << v << " m/s";
      EXPECT_LT(measured.value, before) << v << " m/s";
      before = measured.value;
    }
  }
}

TEST(SteadySliding, friction_goes_from_half_mu_s_to_mu_d) {
  const Parameters p;
  EXPECT_NEAR(measured_friction(block_of(p), 1e-6).value, p.mu_s[0] / 2.0, 0.001);
  EXPECT_NEAR(measured_friction(block_of(p), 10.0).value, p.mu_d[0], 1e-4);
}

}  // namespace rupture::testing
