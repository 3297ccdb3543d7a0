// Prepared interfaces: the prescribed prestress, the quantiles, the trigger, and what is refused.
#include <gtest/gtest.h>

#include <numeric>

#include "rupture/analysis/phi.hpp"
#include "rupture/dynamics/equilibrium.hpp"
#include "rupture/model/random.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

Parameters under_ceiling(Parameters p) {
  p.support = Support::ceiling;
  p.V = 0.0;
  return p;
}

/// The reference slider with a trigger region of nine blocks.
class Prepared : public ::testing::Test {
 protected:
  const Parameters p_ = under_ceiling({});
  const Prestress prestress_ = {0.2, 0.15, PhiShape::bell};
  const State state_ = prepared_state(p_, prestress_);
  static constexpr std::size_t kTriggered = 9;
};

TEST_F(Prepared, has_the_same_p_on_every_block_which_the_ceiling_bears) {
  for (const double p_i : normal_forces(p_, state_)) EXPECT_EQ(p_i, p_.F_N / 57.0);
  double borne = 0.0;
  for (Eigen::Index i = 0; i < p_.Nx; ++i)
    borne += NormalContact(p_, 0).top_force(state_.u_z(i, p_.Nz - 1));
  EXPECT_NEAR(borne, p_.F_N, 1e-10 * p_.F_N);
}

TEST_F(Prepared, stays_at_rest_while_nothing_is_depinned) {
  Prestress pinned = prestress_;
  pinned.trigger = Trigger::pinned;
  const State before = prepared_state(p_, pinned);
  Simulation simulation(p_, before);
  simulation.advance(1000);
  const State& after = simulation.state();
  const double largest = before.u_x.blocks().abs().maxCoeff();
  EXPECT_LT((after.u_x.blocks() - before.u_x.blocks()).abs().maxCoeff(), 1e-11 * largest);
  EXPECT_LT((after.u_z.blocks() - before.u_z.blocks()).abs().maxCoeff(), 1e-11 * largest);
  EXPECT_EQ(after.junctions.draws.sum(), 0U);
}

TEST_F(Prepared, has_junction_forces_that_are_the_quantiles_of_phi) {
  const double f_thres = 0.4 * p_.F_N / 5700.0, f_slip = 0.17 * p_.F_N / 5700.0;
  for (const PhiShape shape : {PhiShape::uniform, PhiShape::bell}) {
    Prestress prestress = prestress_;
    prestress.shape = shape;
    const double a = 0.15 * (f_thres - f_slip) / unit_sigma(shape);
    const auto q = unit_quantiles(shape, 100);
    const auto blocks = block_forces(p_, prepared_state(p_, prestress));
    for (std::size_t i = kTriggered; i < blocks.size(); ++i) {
      for (std::size_t j = 0; j < 100; ++j) {
        ASSERT_NEAR(blocks[i].forces[j], 0.216 * p_.F_N / 5700.0 + a * q[j], 1e-12 * f_thres);
      }
      EXPECT_NEAR(blocks[i].sigma_bar(), 0.15, 0.003 * 0.15) << "of 100 quantiles";
      EXPECT_EQ(blocks[i].slipping, 0.0);
    }
  }
}

TEST_F(Prepared, starts_with_the_trigger_region_depinned_at_once) {
  const double normal = p_.F_N / 57.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(p_.Nx); ++i) {
    const auto block = static_cast<Eigen::Index>(i);
    const bool depinned = i < kTriggered;
    EXPECT_EQ(pinned_fraction(state_.junctions, block), depinned ? 0.0 : 1.0);
    // what friction gave way is the net force on the block
    EXPECT_NEAR(state_.f_x(block, 0), depinned ? (0.239 - 0.17) * normal : 0.0, 1e-12 * normal);
  }
  const auto tau = friction_forces(p_, state_);
  EXPECT_NEAR(std::accumulate(tau.begin(), tau.end(), 0.0), (9 * 0.17 + 48 * 0.216) * normal,
              1e-10 * p_.F_N);
  EXPECT_EQ(state_.junctions.draws.topRows(kTriggered).minCoeff(), 1U);
  EXPECT_EQ(state_.junctions.draws.sum(), 900U);
  EXPECT_EQ(state_.junctions.repin_time(8, 99), slipping_time(p_, 8, 99, 0));
}

TEST_F(Prepared, depins_junctions_in_the_direction_of_their_force) {
  Prestress backwards = prestress_;
  backwards.tau_bar_trigger = -2.0;  // tau_0/p = -0.29
  const auto blocks = block_forces(p_, prepared_state(p_, backwards));
  for (const double f : blocks[0].forces) EXPECT_NEAR(f, -blocks[0].f_slip, 1e-12);
}

// The trigger region's own prestress limits sigma-bar only while it stays pinned.
TEST_F(Prepared, is_refused_beyond_the_largest_sigma_bar) {
  for (const Trigger trigger : {Trigger::depinned, Trigger::pinned}) {
    for (const PhiShape shape : {PhiShape::uniform, PhiShape::bell}) {
      Prestress prestress = {0.2, 0.0, shape};
      prestress.trigger = trigger;
      const double largest = largest_sigma_bar(p_, prestress);
      const double tau_bar = trigger == Trigger::depinned ? 0.2 : 0.3;
      EXPECT_NEAR(largest, (1.0 - tau_bar) * unit_sigma(shape) / unit_quantiles(shape, 100).back(),
                  1e-12);
      prestress.sigma_bar = largest * (1.0 - 1e-9);
      const auto block = block_forces(p_, prepared_state(p_, prestress)).back();
      EXPECT_LE(block.forces.back(), block.f_thres);
      for (const double beyond : {largest * (1.0 + 1e-9), -1e-9}) {
        prestress.sigma_bar = beyond;
        EXPECT_THROW(prepared_state(p_, prestress), UsageError);
      }
    }
  }
}

/// The reference slider with one spring per block, as strong and as stiff as its 100 junctions.
class PreparedSprings : public ::testing::Test {
 protected:
  static Parameters parameters() {
    Parameters p = under_ceiling({});
    p.law = Law::simplified;
    return p;
  }
  const Parameters p_ = parameters();
  const double normal_ = p_.F_N / 57.0;
};

TEST_F(PreparedSprings, carry_what_the_junctions_of_the_reference_law_carry) {
  const Prestress prestress = {0.2};
  const State state = prepared_state(p_, prestress);
  const State reference = prepared_state(under_ceiling({}), prestress);
  ASSERT_EQ(state.junctions.attachment.cols(), 1);
  const auto tau = friction_forces(p_, state);
  const auto wanted = friction_forces(under_ceiling({}), reference);
  for (std::size_t i = 0; i < tau.size(); ++i) {
    EXPECT_NEAR(tau[i], wanted[i], 1e-11 * normal_) << "block " << i;
  }
  EXPECT_LT((state.f_x.blocks() - reference.f_x.blocks()).abs().maxCoeff(), 1e-11 * normal_);
}

}  // namespace rupture::testing
