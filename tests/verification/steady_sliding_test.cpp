// Claim 1G: friction of one block that slides at constant speed v, against renewal theory.
//
// At constant p every junction repeats one cycle: pinned, its force rises from f_new = 0 at the
// rate k_ij v until f_thres, which takes T_p = f_thres / (k_ij v) at a mean force f_thres / 2; then
// it slips for t_R at f_slip. Cycles are independent, so by the renewal-reward theorem the time
// average of its force is
//     f(v) = (T_p f_thres/2 + <t_R> f_slip) / (T_p + <t_R>),
// which depends on T(t_R) only through <t_R>. Limits: mu_s/2 for v -> 0, mu_d for v -> infinity;
// between them f falls monotonically as mu_d < mu_s/2.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "rupture/forces/reference_law.hpp"
#include "support/sliders.hpp"

namespace rupture {
namespace {

/// <|N(mu, sigma)|>
double mean_slipping_time(const Parameters& p) {
  if (p.slipping_times == SlippingTimes::exponential || p.delta_t_R == 0.0) return p.t_R;
  const double ratio = p.t_R / (std::numbers::sqrt2 * p.delta_t_R);
  return p.delta_t_R * std::sqrt(2.0 / std::numbers::pi) * std::exp(-ratio * ratio) +
         p.t_R * std::erf(ratio);
}

/// The contact of a block under the mean normal force of the reference slider.
struct Contact {
  explicit Contact(const Parameters& p)
      : p_i(mean_normal_force(Parameters{})),
        k_ij(junction_stiffness(p, p_i)),
        w(p_i / static_cast<double>(p.N_s) / k_ij) {}
  ContactView view() { return {&p_i, &k_ij, &w}; }
  double p_i, k_ij, w;
};

double pinned_time(const Parameters& p, double v) {
  return p.mu_s * Contact(p).w / v;
}

/// tau / p of renewal theory.
double renewal_friction(const Parameters& p, double v) {
  const double T_p = pinned_time(p, v), t_R = mean_slipping_time(p);
  return (T_p * p.mu_s / 2.0 + t_R * p.mu_d) / (T_p + t_R);
}

/// tau / p of the law, averaged over 40 cycles after 10 cycles of running in.
double simulated_friction(Parameters p, double v) {
  p.Nx = 1;
  Contact contact(p);
  Junctions junctions = State(p).junctions;
  // All attached at once, slow junctions would break at once for many cycles: start them evenly
  // spread over the pinned phase.
  for (Eigen::Index j = 0; j < p.N_s; ++j) {
    junctions.attachment(0, j) =
        -p.mu_s * contact.w * (static_cast<double>(j) + 0.5) / static_cast<double>(p.N_s);
  }
  ReferenceLaw law(p, junctions);
  constexpr int per_cycle = 4000, running_in = 10 * per_cycle, measured = 40 * per_cycle;
  const double dt = (pinned_time(p, v) + mean_slipping_time(p)) / per_cycle;
  double sum = 0.0;
  for (int n = 1; n <= running_in + measured; ++n) {
    const double t = n * dt, u = v * t;
    law.update(&u, &v, contact.view(), t);
    double tau = 0.0;
    law.friction(&u, contact.view(), &tau);
    if (n > running_in) sum += tau;
  }
  return sum / measured / contact.p_i;
}

const std::vector<double> kSpeeds = {1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 1e-1, 1.0};  // [m/s]

// 4000 cycles leave 0.06 % of scatter; 4000 steps per cycle overshoot f_thres by less. Claim 1G
// allows 1 %, but then t_R could be wrong by a quarter.
constexpr double kTolerance = 0.002;

void expect_renewal_theory(const Parameters& p) {
  for (const double v : kSpeeds) {
    const double expected = renewal_friction(p, v);
    EXPECT_NEAR(simulated_friction(p, v), expected, kTolerance * expected) << v << " m/s";
  }
}

TEST(SteadySliding, follows_renewal_theory) {
  expect_renewal_theory(Parameters{});
}

TEST(SteadySliding, follows_renewal_theory_with_exponential_slipping_times) {
  Parameters p;
  p.slipping_times = SlippingTimes::exponential;
  expect_renewal_theory(p);
}

TEST(SteadySliding, friction_falls_monotonically_with_speed) {
  double before = 1.0;
  for (const double v : kSpeeds) {
    const double now = simulated_friction(Parameters{}, v);
    EXPECT_LT(now, before) << v << " m/s";
    before = now;
  }
}

TEST(SteadySliding, friction_goes_from_half_mu_s_to_mu_d) {
  const Parameters p;
  EXPECT_NEAR(simulated_friction(p, 1e-6), p.mu_s / 2.0, 0.001);
  EXPECT_NEAR(simulated_friction(p, 10.0), p.mu_d, 1e-4);
}

}  // namespace
}  // namespace rupture
