// The normal-load equilibrium of the reference slider, found directly and by relaxation.
#include "rupture/dynamics/equilibrium.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "rupture/analysis/phi.hpp"
#include "support/relaxation.hpp"
#include "support/sliders.hpp"

namespace rupture {
namespace {

using testing::message_of;
using testing::static_residual;

class Equilibrium : public ::testing::Test {
 protected:
  const Parameters p_{};
  const State state_ = normal_load_equilibrium(p_);
};

TEST_F(Equilibrium, balances_the_forces_on_every_block) {
  EXPECT_LE(static_residual(p_, state_), 1e-9 * p_.F_N);
  EXPECT_LE(static_residual(p_, state_), 1e-11 * mean_normal_force(p_)) << "as promised";
}

TEST_F(Equilibrium, has_symmetric_p_that_bears_the_load) {
  const auto p = normal_forces(p_, state_);
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_NEAR(p[i], p[p.size() - 1 - i], 1e-9 * mean_normal_force(p_));
    EXPECT_GT(p[i], 0.0);
  }
  EXPECT_NEAR(std::accumulate(p.begin(), p.end(), 0.0), p_.F_N, 1e-9 * p_.F_N);
}

TEST_F(Equilibrium, has_antisymmetric_tau_that_sums_to_zero) {
  const auto tau = friction_forces(p_, state_);
  for (std::size_t i = 0; i < tau.size(); ++i) {
    EXPECT_NEAR(tau[i], -tau[tau.size() - 1 - i], 1e-9 * mean_normal_force(p_));
  }
  EXPECT_NEAR(std::accumulate(tau.begin(), tau.end(), 0.0), 0.0, 1e-9 * p_.F_N);
  // Compressed from above the slider spreads: friction holds the driven side back towards +x.
  EXPECT_LT(tau.front(), -0.01 * mean_normal_force(p_));
}

TEST_F(Equilibrium, leaves_every_junction_pinned_below_its_strength) {
  for (const BlockForces& block : block_forces(p_, state_)) {
    EXPECT_LT(std::abs(block.mean), block.f_thres);
    EXPECT_EQ(block.slipping, 0.0);
    EXPECT_NEAR(block.sigma, 0.0, 1e-12 * block.f_thres);
  }
  EXPECT_EQ(state_.junctions.attachment.abs().maxCoeff(), 0.0) << "attached while undeformed";
}

TEST_F(Equilibrium, starts_driving_at_time_zero_without_force) {
  const Simulation simulation(p_, state_);
  EXPECT_EQ(simulation.time(), 0.0);
  EXPECT_EQ(simulation.F_T(), 0.0);
}

TEST_F(Equilibrium, stays_at_rest_when_it_is_not_driven) {
  Parameters p = p_;
  p.V = 0.0;
  Simulation simulation(p, continued(state_, p));
  testing::advance(simulation, 1000);
  const double moved = (simulation.state().u_x.blocks() - state_.u_x.blocks()).abs().maxCoeff();
  EXPECT_LT(moved, 1e-12 * state_.u_x.blocks().abs().maxCoeff());
}

TEST_F(Equilibrium, SLOW_is_where_damped_relaxation_ends) {
  const State relaxed = testing::relaxed(p_, {}, 20e-3);
  EXPECT_LE(static_residual(p_, relaxed), 1e-9 * p_.F_N);
  const double largest = state_.u_z.blocks().abs().maxCoeff();
  EXPECT_LT((relaxed.u_x.blocks() - state_.u_x.blocks()).abs().maxCoeff(), 1e-10 * largest);
  EXPECT_LT((relaxed.u_z.blocks() - state_.u_z.blocks()).abs().maxCoeff(), 1e-10 * largest);
  EXPECT_EQ(state_.drive.origin_position, state_.u_x(0, driving_row(p_)));
}

TEST(EquilibriumFailure, names_the_block_whose_junctions_are_too_weak) {
  Parameters p;
  p.mu_s = 0.2;  // the outermost blocks carry tau/p = 0.2216
  p.mu_d = 0.1;
  EXPECT_EQ(message_of<Failure>([&] { normal_load_equilibrium(p); }),
            "the junctions of block 0 cannot bear the normal load: |f|/f_thres = 1.11 at F_N = "
            "1920 N; raise junctions.mu_s or slider.foundation, or lower slider.F_N");
}

TEST(EquilibriumFailure, says_that_an_absurd_load_has_no_equilibrium) {
  Parameters p = testing::small_slider(9, 5);
  p.F_N = 2e5;  // nominal strain 0.55: the lattice buckles
  EXPECT_EQ(message_of<Failure>([&] { normal_load_equilibrium(p); }),
            "no equilibrium under F_N = 200000 N was found: the load is too large for slider.E = "
            "3e+09 Pa or the slider tips over");
}

// At a nominal strain above 1 the static equations have solutions in which every block lies below
// the one it was above.
TEST(EquilibriumFailure, refuses_a_load_that_turns_the_lattice_inside_out) {
  Parameters p = testing::small_slider(9, 5);
  p.F_N = 1e6;
  EXPECT_THROW(normal_load_equilibrium(p), Failure);
}

TEST(EquilibriumFailure, refuses_parameters_that_make_no_sense) {
  Parameters p;
  p.H = 0.08;
  EXPECT_THROW(normal_load_equilibrium(p), UsageError);
}

}  // namespace
}  // namespace rupture
