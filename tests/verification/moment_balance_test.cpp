// Under driving the normal forces shift, as the balance of moments wants (Fig. S1): F_T acts at
// height h, friction at the interface.
#include <gtest/gtest.h>

#include "rupture/dynamics/equilibrium.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

using Row = Eigen::ArrayXd;  // one number for each block of a row

/// A slider of 13 x 7 blocks at rest: on a foundation under a driving spring drawn by 20 um, with
/// junctions that cannot break, or under a ceiling under a prestress of 0.4 F_N.
class AtRest : public ::testing::TestWithParam<Support> {
 protected:
  AtRest() {
    p_.h = 2.0 * block_spacing(p_);
    p_.support = GetParam();
    p_.V = 0.0;
    if (is_prepared_) {
      state_ = prepared_state(p_, {.tau_bar = 1.0, .x_trigger = 0.0, .trigger = Trigger::pinned});
    } else {
      p_.mu_s = 100.0;
      state_ = normal_load_equilibrium(p_);
      state_.drive.origin_position += 20e-6;
    }
    Simulation simulation(p_, state_);
    if (!is_prepared_) simulation.advance(40000);  // 8 ms; at rest to rounding after 6 ms
    state_ = simulation.state();
    F_T_ = simulation.F_T();
    bottom_ = Row::Map(simulation.p().data(), p_.Nx);
    tau_ = Row::Map(simulation.tau().data(), p_.Nx);
    top_ = bottom_.NullaryExpr(
        p_.Nx, [&](auto i) { return NormalContact(p_, 0).top_force(state_.u_z(i, p_.Nz - 1)); });
  }

  const bool is_prepared_ = GetParam() == Support::ceiling;
  Parameters p_ = small_slider(13, 7);
  State state_;
  double F_T_ = 0;          // [N]
  Row bottom_, tau_, top_;  // forces on the blocks [N]
  const Row x_ = Row::LinSpaced(p_.Nx, 0.0, p_.L);
};

INSTANTIATE_TEST_SUITE_P(Slider, AtRest, ::testing::Values(Support::foundation, Support::ceiling));

TEST_P(AtRest, forces_balance) {
  EXPECT_GT(F_T_, 0.1 * p_.F_N);
  EXPECT_NEAR(bottom_.sum(), p_.F_N, 1e-12 * p_.F_N);
  EXPECT_NEAR(top_.sum(), p_.F_N, 1e-12 * p_.F_N);
  EXPECT_NEAR(tau_.sum(), F_T_, 1e-12 * p_.F_N);
}

// On a foundation p moves towards the leading edge, and F_N stays; under a ceiling p stays, and the
// force of the ceiling moves towards the driven edge. 0.3 % are missing on the foundation, less
// than 5 % under the ceiling, because the blocks are displaced; see the next test.
TEST_P(AtRest, the_centroids_of_the_normal_forces_have_moved_apart_by_F_T_h_over_F_N) {
  const double shift = (x_ * (bottom_ - top_)).sum() / p_.F_N, expected = F_T_ * p_.h / p_.F_N;
  EXPECT_NEAR(shift, expected, (is_prepared_ ? 0.05 : 0.01) * expected);
}

TEST_P(AtRest, moments_of_all_forces_about_the_track_balance_at_the_displaced_positions) {
  const auto u_x = state_.u_x.blocks(), u_z = state_.u_z.blocks();
  const Row x_bottom = x_ + u_x.row(0).transpose(), z_bottom = u_z.row(0).transpose();
  const Row x_top = x_ + u_x.row(p_.Nz - 1).transpose();
  const double moment = F_T_ * (p_.h + state_.u_z(0, driving_row(p_))) +
                        (top_ * x_top - bottom_ * x_bottom - tau_ * z_bottom).sum();
  EXPECT_NEAR(moment, 0.0, 1e-12 * p_.F_N * p_.L);
}

}  // namespace rupture::testing
