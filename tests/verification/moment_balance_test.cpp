// Under driving the normal forces shift towards the leading edge, as the balance of moments wants
// (Fig. S1): F_T acts at height h, friction at the interface.
#include <gtest/gtest.h>

#include <cmath>

#include "rupture/dynamics/equilibrium.hpp"
#include "support/sliders.hpp"

namespace rupture {
namespace {

/// A slider of 13 x 7 blocks at rest under a driving spring drawn by 20 um, junctions unbreakable.
class DrivenAtRest : public ::testing::Test {
 protected:
  DrivenAtRest() {
    p_.h = 2.0 * block_spacing(p_);
    p_.mu_s = 100.0;
    p_.V = 0.0;
    State state = normal_load_equilibrium(p_);
    state.drive.origin_position += 20e-6;
    simulation_ = std::make_unique<Simulation>(p_, state);
    testing::advance(*simulation_, 40000);  // 8 ms; at rest to rounding after 6 ms
  }

  double x(Eigen::Index i) const { return static_cast<double>(i) * block_spacing(p_); }
  double p(Eigen::Index i) const { return simulation_->p()[static_cast<std::size_t>(i)]; }
  double tau(Eigen::Index i) const { return simulation_->tau()[static_cast<std::size_t>(i)]; }

  Parameters p_ = testing::small_slider(13, 7);
  std::unique_ptr<Simulation> simulation_;
};

TEST_F(DrivenAtRest, forces_balance) {
  double sum_p = 0.0, sum_tau = 0.0;
  for (Eigen::Index i = 0; i < p_.Nx; ++i) {
    sum_p += p(i);
    sum_tau += tau(i);
  }
  EXPECT_GT(simulation_->F_T(), 0.1 * p_.F_N);
  EXPECT_NEAR(sum_p, p_.F_N, 1e-12 * p_.F_N);
  EXPECT_NEAR(sum_tau, simulation_->F_T(), 1e-12 * p_.F_N);
}

TEST_F(DrivenAtRest, the_centroid_of_p_has_moved_by_F_T_h_over_F_N) {
  double moment = 0.0;
  for (Eigen::Index i = 0; i < p_.Nx; ++i) moment += x(i) * p(i);
  const double shift = moment / p_.F_N - p_.L / 2.0;
  const double expected = simulation_->F_T() * p_.h / p_.F_N;
  EXPECT_GT(shift, 0.0) << "towards the leading edge";
  // 0.3 % are left because F_N acts on the displaced top row; see the next test
  EXPECT_NEAR(shift, expected, 0.01 * expected);
}

TEST_F(DrivenAtRest, moments_of_all_forces_about_the_track_balance_at_the_displaced_positions) {
  const State& s = simulation_->state();
  const Eigen::Index top = p_.Nz - 1, row = driving_row(p_);
  double moment = simulation_->F_T() * (p_.h + s.u_z(0, row));
  for (Eigen::Index i = 0; i < p_.Nx; ++i) {
    moment -= p(i) * (x(i) + s.u_x(i, 0));
    moment -= tau(i) * s.u_z(i, 0);
    moment += mean_normal_force(p_) * (x(i) + s.u_x(i, top));
  }
  EXPECT_NEAR(moment, 0.0, 1e-12 * p_.F_N * p_.L);
}

/// A slider of 13 x 7 blocks under a ceiling, at rest under a prestress of 0.4 F_N.
class PreparedAtRest : public ::testing::Test {
 protected:
  PreparedAtRest() {
    p_.support = Support::ceiling;
    p_.h = 2.0 * block_spacing(p_);
    prestress_.trigger = Trigger::pinned;
    prestress_.x_trigger = 0.0;
    prestress_.tau_bar = 1.0;
    state_ = prepared_state(p_, prestress_);
  }
  double x(Eigen::Index i) const { return block_position(p_, i); }
  double top(Eigen::Index i) const { return NormalContact(p_).top_force(state_.u_z(i, p_.Nz - 1)); }

  Parameters p_ = testing::small_slider(13, 7);
  Prestress prestress_;
  State state_;
};

TEST_F(PreparedAtRest, the_centroid_of_the_ceiling_has_moved_towards_the_driven_edge) {
  double moment = 0.0;
  for (Eigen::Index i = 0; i < p_.Nx; ++i) moment += x(i) * top(i);
  const double shift = moment / p_.F_N - p_.L / 2.0;
  const double expected = -driving_force(p_, state_) * p_.h / p_.F_N;
  EXPECT_NEAR(shift, expected, 0.05 * std::abs(expected));  // at the undeformed positions
}

TEST_F(PreparedAtRest, moments_of_all_forces_balance_at_the_displaced_positions) {
  const State& s = state_;
  const auto tau = prescribed_friction(p_, prestress_);
  double moment = driving_force(p_, s) * (p_.h + s.u_z(0, driving_row(p_)));
  for (Eigen::Index i = 0; i < p_.Nx; ++i) {
    moment -= NormalContact(p_).normal_force(s.u_z(i, 0)) * (x(i) + s.u_x(i, 0));
    moment -= tau[static_cast<std::size_t>(i)] * s.u_z(i, 0);
    moment += top(i) * (x(i) + s.u_x(i, p_.Nz - 1));
  }
  EXPECT_NEAR(moment, 0.0, 1e-11 * p_.F_N * p_.L);
}

}  // namespace
}  // namespace rupture
