// Effective static friction: quadrature, and the forces of single junctions.
#include "rupture/analysis/strength.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rupture/dynamics/equilibrium.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

/// mu-bar by quadrature of the density of a shape as the paper writes it (Fig. S5), to about 1e-8.
double by_quadrature(PhiShape shape, double sigma_bar) {
  const double a = sigma_bar / unit_sigma(shape);
  const auto phi = [=](double g) {
    const double x = std::abs(g / a);
    if (shape == PhiShape::uniform) return 1.0 / (2.0 * a);
    return 5.0 / (4.0 * a) * (1.0 + 3.0 * x) * std::pow(1.0 - x, 3);
  };
  constexpr int cells = 20000;  // the largest G on the grid lacks |G''| h^2 / 8 at most
  const double h = 2.0 * a / cells;
  double F = 0.0, H = 0.0, largest = 0.0;
  for (int n = 0; n < cells; ++n) {
    const double left = phi(-a + n * h), middle = phi(-a + (n + 0.5) * h),
                 right = phi(-a + (n + 1) * h);
    // Simpson's rule for int (right - xi) phi and for int phi
    H += h * F + h * h / 6.0 * (left + 2.0 * middle);
    F += h / 6.0 * (left + 4.0 * middle + right);
    largest = std::max(largest, F - H);
  }
  return largest / F;
}

TEST(Strength, agrees_with_quadrature) {
  for (const PhiShape shape : {PhiShape::uniform, PhiShape::bell}) {
    for (const double sigma_bar : {0.01, 0.1, 0.2, 0.28, 0.3, 0.4, 0.6, 0.8, 1.0}) {
      EXPECT_NEAR(effective_strength(shape, sigma_bar), by_quadrature(shape, sigma_bar), 1e-7)
          << sigma_bar;
    }
    EXPECT_DOUBLE_EQ(effective_strength(shape, 0.0), 1.0) << "as of one junction";
  }
  for (const double a : {1e60, 1e300, 1e308}) EXPECT_EQ(effective_strength(PhiShape::bell, a), 0.0);
}

/// Junctions with f_thres = 4 N and f_slip = 1 N.
struct Forces {
  std::vector<double> pinned, slipping;
  double largest;
  const char* why;
};

TEST(LargestFriction, is_met_before_the_right_break) {
  const std::vector<Forces> all = {
      {{-3.0}, {}, 4.0, "one junction"},
      {{2.0, 1.5, 1.0}, {}, 4.0 + 3.5 + 3.0, "before the first break"},
      // breaks at stretches 0, 5 and 6: 4 - 1 - 2 = 1, then 1 + 4 + 3 = 8, then 1 + 1 + 4 = 6
      {{-1.0, 4.0, -2.0}, {}, 8.0, "before a later break"},
      {{2.0}, {1.0, 1.0}, 4.0 + 2.0, "slipping junctions bear f_slip"},
      {{}, {1.0, 1.0}, 2.0, "slipping junctions alone"},
      // after a reversal they carry less; at the break, stretch 1, they carry -0.5 + 1, 1 and -1 +
      // 1
      {{3.0}, {-0.5, 0.8, -1.0}, 4.0 + 0.5 + 1.0 + 0.0, "they are stretched to f_slip at most"},
      {{}, {-0.5, 0.8, -1.0}, 3.0, "all slip at last"},
      {{4.5, 3.0}, {}, 4.0 + 3.0, "one beyond f_thres is about to break"},
  };
  for (const Forces& forces : all) {
    const JunctionForces junctions = {forces.pinned, forces.slipping, 4.0, 1.0};
    EXPECT_DOUBLE_EQ(largest_friction(junctions), forces.largest) << forces.why;
  }
}

/// A slider of 5 x 3 blocks at equilibrium; each junction carries `mean` +- half_width in units g.
class StrengthOfBlocks : public ::testing::Test {
 protected:
  void carry(PhiShape shape, double mean, double half_width) {
    const auto blocks = block_forces(p_, state_);
    const auto xi = unit_quantiles(shape, p_.N_s);
    for (Eigen::Index i = 0; i < p_.Nx; ++i) {
      const auto& b = blocks[static_cast<std::size_t>(i)];
      for (Eigen::Index j = 0; j < p_.N_s; ++j) {
        const double g = mean + half_width * xi[static_cast<std::size_t>(j)];
        state_.junctions.attachment(i, j) =
            state_.u_x(i, 0) - (b.f_slip + g * (b.f_thres - b.f_slip)) / b.k_ij;
      }
    }
  }

  Parameters p_ = small_slider(5, 3);
  State state_ = normal_load_equilibrium(p_);
};

TEST_F(StrengthOfBlocks, lies_on_the_curve) {
  for (const double mean : {-0.3, 0.1}) {
    carry(PhiShape::bell, mean, 0.8);
    for (const BlockStrength& block : block_strengths(p_, state_)) {
      EXPECT_NEAR(*block.tau_bar_0, mean, 1e-12);
      EXPECT_NEAR(*block.sigma_bar, 0.8 * std::sqrt(2.0 / 21.0), 2e-3);
      // 100 junctions: the largest friction is met while one of them is about to break
      EXPECT_NEAR(*block.mu_bar_eff, effective_strength(PhiShape::bell, *block.sigma_bar), 0.01);
      EXPECT_NEAR(block.tau_max / block.p, 0.17 + 0.23 * *block.mu_bar_eff, 1e-12);
    }
  }
}

TEST_F(StrengthOfBlocks, is_in_units_of_each_block) {
  p_.mu_s = AlongX<double>({0.4, 0.5, 0.6, 0.7, 0.8});
  p_.mu_d = AlongX<double>({0.1, 0.2, 0.2, 0.1, 0.3});
  carry(PhiShape::uniform, 0.3, 0.0);
  for (const BlockStrength& block : block_strengths(p_, state_)) {
    EXPECT_NEAR(*block.tau_bar_0, 0.3, 1e-12);
    EXPECT_NEAR(*block.mu_bar_eff, 1.0, 1e-12);
  }
}

TEST_F(StrengthOfBlocks, has_no_value_without_contact) {
  state_.u_z(2, 0) = 1e-6;
  const BlockStrength block = block_strengths(p_, state_)[2];
  EXPECT_DOUBLE_EQ(block.x, 5e-3);
  EXPECT_EQ(block.p, 0.0);
  EXPECT_EQ(block.tau_max, 0.0);
  EXPECT_FALSE(block.sigma_bar || block.tau_bar_0 || block.mu_bar_eff);
}

TEST(Strength, of_single_springs_begins_at_their_friction) {
  Parameters p = small_slider(5, 3);
  p.law = Law::simplified;
  State state = normal_load_equilibrium(p);
  state.junctions.attachment.setConstant(-1e-6);
  const auto friction = friction_forces(p, state);
  const auto blocks = block_strengths(p, state);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    EXPECT_NEAR(*blocks[i].tau_bar_0 * 0.23 + 0.17, friction[i] / blocks[i].p, 1e-12);
  }
}

}  // namespace rupture::testing
