// The normal-load equilibrium, found in both orders of elimination.
#include "rupture/dynamics/equilibrium.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "dynamics/statics.hpp"
#include "rupture/analysis/phi.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

class Equilibrium : public ::testing::Test {
 protected:
  const Parameters p_{};
  const State state_ = normal_load_equilibrium(p_);
};

TEST_F(Equilibrium, has_symmetric_p_that_bears_the_load_and_antisymmetric_tau) {
  const auto p = normal_forces(p_, state_), tau = friction_forces(p_, state_);
  const double mean = mean_normal_force(p_);
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(p[i], p[p.size() - 1 - i], 1e-9 * mean);
    EXPECT_NEAR(tau[i], -tau[tau.size() - 1 - i], 1e-9 * mean);
    EXPECT_GT(p[i], 0.0);
  }
  EXPECT_NEAR(std::accumulate(p.begin(), p.end(), 0.0), p_.F_N, 1e-9 * p_.F_N);
  EXPECT_NEAR(std::accumulate(tau.begin(), tau.end(), 0.0), 0.0, 1e-9 * p_.F_N);
  // Compressed from above the slider spreads: friction holds the driven side back towards +x.
  EXPECT_LT(tau.front(), -0.01 * mean);
}

TEST_F(Equilibrium, leaves_every_junction_pinned_below_its_strength) {
  for (const BlockForces& block : block_forces(p_, state_)) {
    EXPECT_LT(std::abs(block.mean), block.f_thres);
    EXPECT_EQ(block.slipping, 0.0);
    EXPECT_NEAR(block.sigma, 0.0, 1e-12 * block.f_thres);
  }
  EXPECT_EQ(state_.junctions.attachment.abs().maxCoeff(), 0.0) << "attached while undeformed";
}

TEST_F(Equilibrium, stays_at_rest_when_it_is_not_driven) {
  Parameters p = p_;
  p.V = 0.0;
  Simulation simulation(p, continued(state_, p));
  simulation.advance(1000);
  const double moved = (simulation.state().u_x.blocks() - state_.u_x.blocks()).abs().maxCoeff();
  EXPECT_LT(moved, 1e-12 * state_.u_x.blocks().abs().maxCoeff());
}

void expect_same_in_both_orders(const Parameters& p, const LoadCase& load_case) {
  const auto by_degree = solve_statics(p, load_case, Elimination::column_minimum_degree);
  const auto by_dissection = solve_statics(p, load_case, Elimination::nested_dissection);
  ASSERT_TRUE(by_degree && by_dissection);
  const double rounding = 1e-11 * largest(by_degree->u_x, by_degree->u_z);
  for (Field State::*u : {&State::u_x, &State::u_z}) {
    const Field &found = (*by_dissection).*u, &expected = (*by_degree).*u;
    EXPECT_LT((found.blocks() - expected.blocks()).abs().maxCoeff(), rounding);
  }
}

TEST(Elimination, moves_the_equilibrium_by_rounding_only) {
  for (const auto& p : {Parameters{}, small_slider(16, 9), small_slider(5, 12)}) {
    expect_same_in_both_orders(p, {});
    std::vector<double> tau(static_cast<std::size_t>(p.Nx), 0.05 * mean_normal_force(p));
    expect_same_in_both_orders(p, {tau, p.K});
  }
}

TEST(Elimination, depends_on_the_number_of_blocks) {
  Parameters p = small_slider(110, 91);  // 10,010 blocks
  const State state = normal_load_equilibrium(p);
  const auto same = solve_statics(p, {}, Elimination::nested_dissection);
  ASSERT_TRUE(same);
  EXPECT_TRUE((state.u_x.blocks() == same->u_x.blocks()).all());

  p = Parameters{};
  const auto unchanged = solve_statics(p, {}, Elimination::column_minimum_degree);
  ASSERT_TRUE(unchanged);
  EXPECT_TRUE((normal_load_equilibrium(p).u_x.blocks() == unchanged->u_x.blocks()).all());
}

}  // namespace rupture::testing
