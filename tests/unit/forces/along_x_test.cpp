// Properties that vary along x: every law, every parameter that may vary.
#include <gtest/gtest.h>

#include "hand_made_interface.hpp"
#include "rupture/model/laws.hpp"

namespace rupture::testing {

constexpr std::int64_t kBlocks = 6;

/// Friction on all blocks, one row per step, while all make the same moves: there and back so often
/// that junctions break, are pinned again and slip slowly.
std::vector<std::vector<double>> history(const Parameters& p) {
  Junctions junctions = State(p).junctions;
  const auto law = make_law(p, junctions);
  std::vector<double> load(kBlocks, 5.0), k_ij, w, tau(kBlocks);
  for (std::int64_t i = 0; i < kBlocks; ++i) {
    k_ij.push_back(junction_stiffness(p, i, load.front()));
    w.push_back(friction_stretch(p, i, load.front()));
  }
  const ContactView contact = {load.data(), k_ij.data(), w.data()};
  std::vector<std::vector<double>> rows;
  for (int n = 1; n <= 4000; ++n) {
    const double t = n * 8e-6, phase = n * 0.013;
    const std::vector<double> u(kBlocks, std::sin(phase)), v(kBlocks, std::cos(phase));
    law->update(u.data(), v.data(), contact, t);
    law->friction(u.data(), contact, tau.data());
    rows.push_back(tau);
  }
  return rows;
}

Parameters of_law(const LawInfo& law) {
  Parameters p = hand_made(5);
  p.Nx = kBlocks;
  p.L = 0.0025 * (kBlocks - 1);
  p.delta_t_R = 0.6e-3;
  p.d_R = 0.3;
  p.delta_d_R = 0.1;
  p.v_slow = 10.0;  // per step, as far as the block moves
  p.dt = 1e-4;
  set_parameter(p, "junctions.law", law.name);
  return p;
}

/// Another value that the parameter may have.
std::string other(const Parameters& p, const ParameterInfo& info) {
  if (!info.valid.words.empty()) return std::string(info.valid.words.back());
  return fmt::format("{}", 0.9 * std::stod(parameter_text(p, info)));
}

TEST(AlongX, each_half_of_the_interface_obeys_the_law_with_its_own_value) {
  int moved = 0;
  for (const LawInfo& law : law_table()) {
    for (const ParameterInfo& info : parameter_table()) {
      const Parameters left = of_law(law);
      if (!may_vary_along_x(info) || info.name == "slider.load" || !is_used(info, left.law))
        continue;
      SCOPED_TRACE(fmt::format("{} under the {} law", info.name, law.name));
      Parameters right = left, both = left;
      set_parameter(right, info.name, other(left, info));
      set_parameter(both, info.name, other(left, info) + " from 7.5mm to 12.5mm");
      const auto of_left = history(left), of_right = history(right), of_both = history(both);
      bool differs = false;
      for (std::size_t n = 0; n < of_both.size(); ++n) {
        for (std::size_t i = 0; i < kBlocks; ++i) {
          ASSERT_EQ(of_both[n][i], (i < kBlocks / 2 ? of_left : of_right)[n][i]) << n << ' ' << i;
          differs |= of_left[n][i] != of_right[n][i];
        }
      }
      EXPECT_TRUE(differs);
      ++moved;
    }
  }
  EXPECT_GE(moved, 20);
}

// Two blocks of the same slider apart: with weights 3 to 1 the left half bears three quarters.
TEST(AlongX, a_load_keeps_its_sum_and_presses_where_it_is) {
  Parameters p = small_slider(9, 5);
  set_parameter(p, "slider.load", "3 from 0 to 17.5mm");
  double sum = 0.0;
  for (std::int64_t i = 0; i < p.Nx; ++i) sum += column_load(p, i);
  EXPECT_DOUBLE_EQ(sum, p.F_N);
  EXPECT_DOUBLE_EQ(column_load(p, 0) / column_load(p, 8), 3.0);
  const State state = normal_load_equilibrium(p);
  double pressed = 0.0, moment = 0.0, load_moment = 0.0;
  for (std::int64_t i = 0; i < p.Nx; ++i) {
    const double p_i = NormalContact(p, i).normal_force(state.u_z(i, 0));
    pressed += p_i;
    moment += p_i * (block_position(p, i) + state.u_x(i, 0));
    load_moment += column_load(p, i) * (block_position(p, i) + state.u_x(i, p.Nz - 1));
  }
  EXPECT_NEAR(pressed, p.F_N, 1e-9 * p.F_N);
  EXPECT_NEAR(moment, load_moment, 2e-4 * load_moment);  // junctions bear the little rest
}

}  // namespace rupture::testing
