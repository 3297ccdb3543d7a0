// analyze strength, estimate, steady-state: what follows from parameters and junction forces.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "tool_test.hpp"

namespace rupture::testing {
namespace {

using Values = std::vector<double>;
using Cells = std::vector<std::vector<std::string>>;

// --- strength
// -------------------------------------------------------------------------------------

using Strength = ToolTest;

TEST_F(Strength, of_a_checkpoint_follows_its_junctions) {
  output_of("load --config small.ini -o a.h5 -q");
  output_of("modify-phi a.h5 -o b.h5 --shape bell --sigma-bar 0.2 -q");
  const Json json = json_of("analyze strength b.h5 --json");
  const Json stress = json_of("analyze stress b.h5 --json");
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(json["x"][i], stress["x"][i]);
    EXPECT_EQ(json["slipping"][i], 0.0);
    EXPECT_NEAR(json["sigma_bar"][i], 0.2, 1e-3);  // 100 quantiles
    EXPECT_NEAR(json["mu_bar_eff"][i], 0.628, 0.01);
    const double mu = stress["tau"][i].get<double>() / stress["p"][i].get<double>();
    EXPECT_NEAR(json["tau_bar_0"][i], (mu - 0.17) / 0.23, 1e-12);
    EXPECT_NEAR(json["mu_eff"][i], 0.17 + 0.23 * json["mu_bar_eff"][i].get<double>(), 1e-12);
  }
  const auto rows = csv_of(output_of("analyze strength b.h5 --csv"));
  ASSERT_EQ(rows.size(), 10U);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"x [m]", "slipping", "sigma_bar", "tau_bar_0",
                                               "mu_bar_eff", "mu_eff"}));
  EXPECT_EQ(lines_of(output_of("analyze strength b.h5")).size(), 10U);
}

TEST_F(Strength, of_blocks_all_of_whose_junctions_slip_is_zero) {
  output_of("load --config small.ini -o a.h5 --until 6e-4 -q");
  const Json json = json_of("analyze strength a.h5 --json");
  int sliding = 0;
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_GE(json["mu_bar_eff"][i], -1e-12);
    if (json["slipping"][i] < 1.0) continue;
    ++sliding;
    EXPECT_NEAR(json["mu_bar_eff"][i], 0.0, 1e-12);
  }
  EXPECT_GT(sliding, 0);
}

// --- estimate
// -------------------------------------------------------------------------------------

class Estimate : public ToolTest {
 protected:
  Estimate() { output_of("load --config small.ini -o a.h5 -q"); }
};

TEST_F(Estimate, is_equation_S1_at_the_normal_forces) {
  const Json json = json_of("analyze estimate a.h5 --json");
  const Values p = json_of("analyze stress a.h5 --json")["p"];
  EXPECT_EQ(json["block"]["p"].get<Values>(), p);
  const double p_mean = std::accumulate(p.begin(), p.end(), 0.0) / 9.0, t_R = json["t_R"];
  EXPECT_NEAR(json["p"], p_mean, 1e-9);
  EXPECT_NEAR(t_R, 2.0001e-3, 1e-7);
  // 4.2 tau_slip / (k_i <t_R>), k_i = 100 sqrt(39.2e9 p/100)
  const auto v = [&](double force) {
    return 4.2 * 0.17 * force / (100.0 * std::sqrt(39.2e9 * force / 100.0) * t_R);
  };
  EXPECT_NEAR(json["v_slow_slip"], v(p_mean), 1e-12);
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_NEAR(json["block"]["v_slow_slip"][i], v(p[i]), 1e-12);
  }
}

TEST_F(Estimate, follows_the_slip_of_one_block) {
  const Json json = json_of("analyze estimate a.h5 --json");
  const Values time = json["relaxation"]["time_over_t_R"];
  const Values slip = json["relaxation"]["slip_over_f_slip_per_k_ij"];
  ASSERT_EQ(time.size(), slip.size());
  ASSERT_GT(time.size(), 100U) << "each junction is pinned once, and some again";
  EXPECT_TRUE(std::is_sorted(time.begin(), time.end()));
  EXPECT_TRUE(std::is_sorted(slip.begin(), slip.end()));
  EXPECT_EQ(slip.front(), 1.0) << "the first pinned junction alone makes up for f_slip";
  EXPECT_NEAR(slip.back(), json["net_slip_over_f_slip_per_k_ij"], 1e-12) << "equal for all seeds";
}

TEST_F(Estimate, depends_on_the_seed_and_on_nothing_else) {
  const std::string command = "analyze estimate a.h5 --json --ensemble 5";
  EXPECT_EQ(output_of(command), output_of(command));
  EXPECT_EQ(output_of(command), output_of(command + " --seed 1")) << "the checkpoint's";
  EXPECT_NE(output_of(command), output_of(command + " --seed 2"));
}

// --- steady-state
// ---------------------------------------------------------------------------------

using SteadyState = ToolTest;

TEST_F(SteadyState, follows_renewal_theory) {
  const Json json = json_of("analyze steady-state --v-from 1e-3 --v-to 1e-1 --points 3 --json");
  const Values v = json["v"], mu = json["mu"], error = json["mu_error"], theory = json["mu_theory"];
  ASSERT_EQ(v.size(), 3U);
  EXPECT_EQ(v.front(), 1e-3);
  EXPECT_NEAR(v[1], 1e-2, 1e-15);
  EXPECT_NEAR(v.back(), 1e-1, 1e-15);
  // at 1 mm/s: T_p = 0.4 sqrt(f_N/kappa) / v with f_N = 1920/5700 N, <t_R> = 2.0001 ms
  const double T_p = 0.4 * std::sqrt(1920.0 / 5700.0 / 39.2e9) / 1e-3, t_R = 2.000134e-3;
  EXPECT_NEAR(theory[0], (T_p * 0.2 + t_R * 0.17) / (T_p + t_R), 1e-8);
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_GT(error[n], 0.0);
    EXPECT_LT(error[n], 1e-3 * mu[n]);
    EXPECT_NEAR(mu[n], theory[n], 4.0 * error[n] + theory[n] / 2000.0);
  }
  EXPECT_NEAR(json["p"], 1920.0 / 57.0, 1e-12);
}

TEST_F(SteadyState, takes_parameters_and_seed) {
  const std::string command = "analyze steady-state --points 1 --v-from 0.01 --json";
  EXPECT_EQ(output_of(command), output_of(command + " --seed 1"));
  EXPECT_NE(json_of(command)["mu"], json_of(command + " --seed 2")["mu"]);
  EXPECT_NEAR(json_of(command + " --set junctions.mu_d=0.1")["mu"][0], 0.1, 0.01);
}

TEST_F(SteadyState, comes_closer_to_the_theory_with_shorter_steps) {
  const auto off = [this](const std::string& steps) {
    const Json json = json_of("analyze steady-state --points 1 --v-from 1 --json" + steps);
    return std::abs(double(json["mu"][0]) - double(json["mu_theory"][0]));
  };
  EXPECT_GT(off(""), 1e-5) << "a junction is pinned for two steps only";
  EXPECT_LT(off(" --steps-per-cycle 40000"), 5e-6);
}

}  // namespace
}  // namespace rupture::testing
