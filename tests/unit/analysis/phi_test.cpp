// Distributions of junction forces: their shapes, how they are measured and how they are replaced.
#include "rupture/analysis/phi.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "rupture/dynamics/equilibrium.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

class Shape : public ::testing::TestWithParam<PhiShape> {};

TEST_P(Shape, has_quantiles_in_ascending_antisymmetric_order) {
  for (const std::int64_t n : {1, 2, 7, 100, 1001}) {
    const auto q = unit_quantiles(GetParam(), n);
    ASSERT_EQ(q.size(), static_cast<std::size_t>(n));
    for (std::size_t j = 0; j < q.size(); ++j) {
      EXPECT_EQ(q[j], -q[q.size() - 1 - j]) << "so the mean is zero to the last bit";
      EXPECT_LT(std::abs(q[j]), 1.0);
      EXPECT_TRUE(j == 0 || q[j] > q[j - 1]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Phi, Shape, ::testing::Values(PhiShape::uniform, PhiShape::bell),
                         [](const auto& shape) {
                           return shape.param == PhiShape::bell ? "bell" : "uniform";
                         });

/// A slider of 5 x 3 blocks at equilibrium whose junctions carry f = (1/2 + 1/4
/// xi) f_thres with random xi in [-1, 1]; every tenth junction slips.
class Interface : public ::testing::Test {
 protected:
  Interface() {
    const auto blocks = block_forces(p_, state_);
    Noise noise(0.25);
    for (Eigen::Index i = 0; i < p_.Nx; ++i) {
      const BlockForces& block = blocks[static_cast<std::size_t>(i)];
      for (Eigen::Index j = 0; j < p_.N_s; ++j) {
        const double pinned = (0.5 + noise()) * block.f_thres;
        const bool slips = j % 10 == 0;
        state_.junctions.attachment(i, j) =
            state_.u_x(i, 0) - (slips ? block.f_slip : pinned) / block.k_ij;
        if (slips) state_.junctions.repin_time(i, j) = 1e-3;
      }
    }
    before_ = state_;
  }
  /// Whether the junctions of block i are what they were, to the bit.
  bool untouched(Eigen::Index i) const {
    return (state_.junctions.attachment.row(i) == before_.junctions.attachment.row(i)).all() &&
           (state_.junctions.repin_time.row(i) == before_.junctions.repin_time.row(i)).all();
  }
  void become_widest(PhiShape shape, Slipping slipping) {
    state_ = before_;
    PhiChange change;
    change.shape = shape;
    change.slipping = slipping;
    EXPECT_TRUE(change_phi(p_, state_, change).empty());
    for (std::size_t i = 0; i < 5; ++i) {
      const BlockForces block = now()[i];
      EXPECT_NEAR(block.mean, then()[i].mean, 1e-12 * block.f_thres);
      EXPECT_DOUBLE_EQ(block.slipping, slipping == Slipping::pin ? 0.0 : 0.1);
      // all but every tenth, or all; their forces are exact quantiles about their mean
      std::vector<double> pinned;
      for (std::size_t j = 0; j < 100; ++j) {
        if (slipping == Slipping::pin || j % 10 != 0) pinned.push_back(block.forces[j]);
      }
      std::sort(pinned.begin(), pinned.end());
      const auto n = static_cast<double>(pinned.size());
      const double mean = std::accumulate(pinned.begin(), pinned.end(), 0.0) / n;
      const double half_width = block.f_thres - std::abs(mean);
      const auto q = unit_quantiles(shape, std::ssize(pinned));
      for (std::size_t j = 0; j < pinned.size(); ++j) {
        EXPECT_NEAR(pinned[j], mean + half_width * q[j], 1e-12 * block.f_thres);
      }
    }
  }
  std::vector<BlockForces> now() const { return block_forces(p_, state_); }
  std::vector<BlockForces> then() const { return block_forces(p_, before_); }

  Parameters p_ = small_slider(5, 3);
  State state_ = normal_load_equilibrium(p_);
  State before_;
};

TEST_F(Interface, has_the_properties_of_each_block) {
  const double k_ij = now()[1].k_ij, f_N = normal_forces(p_, state_)[1] / 100.0;
  p_.mu_s = AlongX<double>({0.4, 0.5, 0.4, 0.4, 0.4});
  p_.mu_d = AlongX<double>({0.1, 0.2, 0.1, 0.1, 0.1});
  p_.kappa = AlongX<double>({1e9, 4.0 * p_.kappa[1], 1e9, 1e9, 1e9});
  EXPECT_DOUBLE_EQ(now()[1].f_thres, 0.5 * f_N);
  EXPECT_DOUBLE_EQ(now()[1].f_slip, 0.2 * f_N);
  EXPECT_DOUBLE_EQ(now()[1].k_ij, 2.0 * k_ij);
  p_.law = Law::simplified;
  state_.junctions = State(p_).junctions;
  EXPECT_DOUBLE_EQ(now()[1].k_ij, 100.0 * 2.0 * k_ij) << "a single spring";
}

TEST_F(Interface, becomes_as_wide_as_it_can_with_the_same_means) {
  State backwards = state_;
  for (Eigen::Index i = 0; i < p_.Nx; ++i) {
    backwards.junctions.attachment.row(i) =
        2.0 * state_.u_x(i, 0) - state_.junctions.attachment.row(i);
  }
  for (const State& before : {state_, backwards}) {
    before_ = before;
    for (const PhiShape shape : {PhiShape::uniform, PhiShape::bell}) {
      for (const Slipping slipping : {Slipping::keep, Slipping::pin}) {
        become_widest(shape, slipping);
      }
    }
  }
}

TEST_F(Interface, keeps_slipping_junctions_and_the_order_of_the_others) {
  change_phi(p_, state_, PhiChange{});
  const auto a = now()[3].forces, b = then()[3].forces;
  for (std::size_t j = 0; j < 100; ++j) {
    for (std::size_t k = 0; k < 100; ++k) {
      const bool both_pinned = j % 10 != 0 && k % 10 != 0;
      EXPECT_TRUE(!both_pinned || b[j] >= b[k] || a[j] < a[k]) << j << ", " << k;
    }
  }
  for (Eigen::Index i = 0; i < 5; ++i) {
    for (Eigen::Index j = 0; j < 100; j += 10) {
      EXPECT_EQ(state_.junctions.attachment(i, j), before_.junctions.attachment(i, j));
      EXPECT_EQ(state_.junctions.repin_time(i, j), 1e-3);
    }
    EXPECT_DOUBLE_EQ(pinned_fraction(state_.junctions, i), 0.9);
  }
  EXPECT_TRUE((state_.junctions.draws == before_.junctions.draws).all());
}

TEST_F(Interface, refuses_a_width_that_would_break_a_junction_and_tells_the_largest) {
  PhiChange change;
  change.sigma_bar = 10.0;
  const auto impossible = change_phi(p_, state_, change);
  ASSERT_EQ(impossible.size(), 5U);
  for (Eigen::Index i = 0; i < 5; ++i) {
    const auto& block = impossible[static_cast<std::size_t>(i)];
    EXPECT_DOUBLE_EQ(block.x, static_cast<double>(i) * 2.5e-3);
    EXPECT_TRUE(untouched(i));
    // slightly less than the largest width is possible for this block, slightly more is not
    PhiChange alone;
    alone.x_from = alone.x_to = block.x;
    State copy = before_;
    alone.sigma_bar = block.largest_sigma_bar * (1.0 + 1e-9);
    EXPECT_EQ(change_phi(p_, copy, alone).size(), 1U);
    alone.sigma_bar = block.largest_sigma_bar * (1.0 - 1e-9);
    EXPECT_TRUE(change_phi(p_, copy, alone).empty());
  }
}

TEST_F(Interface, leaves_blocks_alone_that_are_not_pressed_or_overloaded_or_all_slip) {
  state_.u_z(1, 0) = 1e-6;
  state_.junctions.repin_time.row(2) = 1e-3;
  state_.junctions.attachment.row(3) -= now()[3].f_thres / now()[3].k_ij;  // 1.5 f_thres on average
  before_ = state_;
  const auto impossible = change_phi(p_, state_, PhiChange{});
  ASSERT_EQ(impossible.size(), 2U);
  EXPECT_DOUBLE_EQ(impossible[0].x, 2.5e-3);
  EXPECT_DOUBLE_EQ(impossible[1].x, 7.5e-3);
  EXPECT_EQ(impossible[0].largest_sigma_bar, 0.0);
  EXPECT_EQ(impossible[1].largest_sigma_bar, 0.0);
  EXPECT_TRUE(untouched(1) && untouched(2) && untouched(3));
}

TEST(Histogram, counts_every_junction_once) {
  BlockForces block;
  block.f_thres = 1.0;
  block.forces = {-1.0, -0.51, -0.49, 0.0, 0.1, 0.49, 0.99, 1.0, 1e300};
  EXPECT_EQ(histogram(block, 4), (std::vector<std::int64_t>{2, 1, 3, 3}));
}

}  // namespace rupture::testing
