// The slider at rest in both orders of elimination.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "support/relaxation.hpp"
#include "support/sliders.hpp"

namespace rupture {
namespace {

using testing::small_slider;
using testing::static_residual;

TEST(NestedDissection, gives_each_block_a_place_of_its_own) {
  for (const auto& [Nx, Nz] : {std::pair{3, 3}, {2, 40}, {41, 5}, {57, 31}}) {
    std::vector<Eigen::Index> places = nested_dissection(Nx, Nz);
    std::vector<Eigen::Index> all(static_cast<std::size_t>(Nx * Nz));
    std::iota(all.begin(), all.end(), 0);
    EXPECT_TRUE(std::is_permutation(places.begin(), places.end(), all.begin(), all.end()))
        << Nx << " x " << Nz;
  }
}

TEST(NestedDissection, puts_the_line_that_separates_the_halves_last) {
  const std::vector<Eigen::Index> places = nested_dissection(7, 3);
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 7; ++i) {
      const Eigen::Index place = places[j * 7 + i];
      EXPECT_EQ(place < 9, i < 3) << i << ", " << j;
      EXPECT_EQ(place >= 18, i == 3) << i << ", " << j;
    }
  }
}

/// Demands that both orders give the same slider at rest, but for rounding.
void expect_same_in_both_orders(const Parameters& p, const LoadCase& load_case) {
  const auto by_degree = solve_statics(p, load_case, Elimination::column_minimum_degree);
  const auto by_dissection = solve_statics(p, load_case, Elimination::nested_dissection);
  ASSERT_TRUE(by_degree && by_dissection);
  const double largest_u = largest(by_degree->u_x, by_degree->u_z);
  const auto apart = [](const Field& a, const Field& b) {
    return (a.blocks() - b.blocks()).abs().maxCoeff();
  };
  EXPECT_LT(apart(by_dissection->u_x, by_degree->u_x), 1e-11 * largest_u);
  EXPECT_LT(apart(by_dissection->u_z, by_degree->u_z), 1e-11 * largest_u);
}

TEST(Elimination, moves_the_equilibrium_by_rounding_only) {
  for (const auto& p : {Parameters{}, small_slider(16, 9), small_slider(5, 12)}) {
    expect_same_in_both_orders(p, {});
    std::vector<double> tau(static_cast<std::size_t>(p.Nx), 0.05 * mean_normal_force(p));
    expect_same_in_both_orders(p, {tau, p.K});
  }
}

TEST(Elimination, by_dissection_balances_the_forces_on_every_block) {
  const Parameters p;
  const auto state = solve_statics(p, {}, Elimination::nested_dissection);
  ASSERT_TRUE(state);
  EXPECT_LE(static_residual(p, *state), 1e-11 * mean_normal_force(p));
}

TEST(Elimination, depends_on_the_number_of_blocks) {
  Parameters p = small_slider(110, 91);  // 10,010 blocks
  const State state = normal_load_equilibrium(p);
  EXPECT_LE(static_residual(p, state), 1e-11 * mean_normal_force(p));
  const auto same = solve_statics(p, {}, Elimination::nested_dissection);
  ASSERT_TRUE(same);
  EXPECT_TRUE((state.u_x.blocks() == same->u_x.blocks()).all());

  p = Parameters{};
  const auto unchanged = solve_statics(p, {}, Elimination::column_minimum_degree);
  ASSERT_TRUE(unchanged);
  EXPECT_TRUE((normal_load_equilibrium(p).u_x.blocks() == unchanged->u_x.blocks()).all());
}

}  // namespace
}  // namespace rupture
