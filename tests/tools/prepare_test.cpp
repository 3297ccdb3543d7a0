// prepare: a checkpoint with the prestress that was asked for, from which restart runs the event.
#include <algorithm>
#include <cmath>

#include "tool_test.hpp"

namespace rupture::testing {
namespace {

/// Nine blocks 17.5 mm apart, two of them in the trigger region.
const std::string kPrepare = "prepare --config small.ini --set driving.V=0 ";

class Prepare : public ToolTest {
 protected:
  std::vector<double> numbers(const std::string& command, const char* what) const {
    return json_of("analyze " + command + " --json")[what];
  }
};

TEST_F(Prepare, writes_the_prestress) {
  output_of(kPrepare + "-o a.h5 --tau-bar 0.2 --sigma-bar 0.1 --no-trigger");
  const auto p = numbers("stress a.h5", "p"), tau = numbers("stress a.h5", "tau");
  const auto sigma_bar = numbers("phi a.h5", "sigma_bar");
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_DOUBLE_EQ(p[i], 1920.0 / 9);
    EXPECT_NEAR(tau[i] / p[i], i < 2 ? 0.239 : 0.216, 1e-9);
    EXPECT_NEAR(sigma_bar[i], 0.1, 1e-4);
  }
  EXPECT_NEAR(json_of("analyze stress a.h5 --json")["F_T"], (2 * 0.239 + 7 * 0.216) * 1920 / 9,
              1e-6);
}

TEST_F(Prepare, depins_the_trigger_region) {
  output_of(kPrepare + "-o a.h5 --tau-bar 0.2");
  const auto slipping = numbers("phi a.h5", "slipping");
  for (std::size_t i = 0; i < slipping.size(); ++i) EXPECT_EQ(slipping[i], i < 2 ? 1.0 : 0.0);
  output_of(kPrepare + "-o b.h5 --tau-bar 0.2 --x-trigger 0.06");
  EXPECT_EQ(numbers("phi b.h5", "slipping")[3], 1.0);
  EXPECT_EQ(numbers("phi b.h5", "slipping")[4], 0.0);
}

TEST_F(Prepare, says_what_it_made) {
  const std::string out = output_of(kPrepare + "-o a.h5 --tau-bar 0.2 --sigma-bar 0.1");
  EXPECT_NE(out.find("tau/p = 0.216000 beyond x = 0.0225 m, within "), std::string::npos) << out;
  EXPECT_NE(out.find("the largest possible is 0.466"), std::string::npos) << out;
  EXPECT_NE(
      out.find("2 of 9 blocks are depinned\nwrote a.h5  content-sha256 " + checksum_of("a.h5")),
      std::string::npos)
      << out;
}

TEST_F(Prepare, sets_support_and_speed_itself) {
  output_of("prepare -o a.h5 --tau-bar 0.2");
  const Json shown = json_of("analyze show a.h5 --json");
  EXPECT_EQ(shown["parameters"]["slider.support"], "ceiling");
  EXPECT_EQ(shown["parameters"]["driving.V"], 0.0);
  ASSERT_EQ(shown["provenance"].size(), 1U);
  EXPECT_EQ(shown["provenance"][0]["tool"], "prepare");
}

TEST_F(Prepare, its_event_runs_or_arrests_as_the_stress_allows) {
  output_of(kPrepare + "-o high.h5 --tau-bar 0.8");
  output_of(kPrepare + "-o low.h5 --tau-bar 0");
  for (const std::string name : {"high", "low"}) {
    output_of("restart " + name + ".h5 -o after.h5 -f --until-quiet 1e-3 --record " + name +
              "-record.h5");
  }
  EXPECT_EQ(json_of("analyze classify high-record.h5 --json")["type"], "fast");
  EXPECT_EQ(json_of("analyze classify low-record.h5 --json")["type"], "none");
}

TEST_F(Prepare, takes_single_springs_too) {
  const std::string out =
      output_of(kPrepare + "-o a.h5 --tau-bar 0.8 --set junctions.law=simplified");
  const std::size_t within = out.find(" m, within ");
  ASSERT_NE(within, std::string::npos) << out;
  EXPECT_LT(std::stod(out.substr(within + 11)), 1e-12) << out;
  output_of("restart a.h5 -o b.h5 --until-quiet 1e-3 --record r.h5");
  EXPECT_EQ(json_of("analyze classify r.h5 --json")["type"], "fast");
}

TEST_F(Prepare, its_support_cannot_change) {
  output_of(kPrepare + "-o a.h5 --tau-bar 0.2");
  expect_refusal("restart a.h5 -o b.h5 --for 1e-5 --set slider.support=foundation", kUsage,
                 "slider.support cannot change in a restart: the state was made with ceiling");
}

TEST_F(Prepare, refuses_what_is_impossible) {
  expect_refusal("prepare -o a.h5", kUsage,
                 "the option '--tau-bar' is required but missing; see rupture prepare --help");
  expect_refusal("prepare -o a.h5 --tau-bar 0.1 --sigma-bar 0.6", kUsage,
                 "sigma-bar = 0.6 would put junctions beyond f_thres: the largest possible value "
                 "is 0.5248");
  output_of("prepare -o limit.h5 --tau-bar 0.1 --sigma-bar 0.5248");
  expect_refusal("prepare -o a.h5 --tau-bar 1.1", kUsage,
                 "tau-bar = 1.1 would put junctions beyond f_thres: the largest possible value is "
                 "1, the smallest -2.478");
  expect_refusal("prepare -o a.h5 --tau-bar 0.1 --sigma-bar -1", kUsage,
                 "--sigma-bar -1 makes no sense: give a number of at least 0");
  expect_refusal("prepare -o a.h5 --tau-bar 0.1 --shape round", kUsage,
                 "--shape round is unknown: choose uniform or bell");
  expect_refusal("prepare -o a.h5 --tau-bar 0.1 --set driving.V=1", kUsage,
                 "driving.V = 1 m/s: a prepared interface is not driven; give restart a --set "
                 "driving.V");
  expect_refusal("prepare -o a.h5 --tau-bar 0.1 --set slider.support=foundation", kUsage,
                 "a prepared interface needs slider.support = ceiling");
  expect_refusal("prepare b.h5 -o a.h5 --tau-bar 0.1", kUsage,
                 "'b.h5' is not expected: prepare reads no checkpoint; see rupture prepare --help");
}

}  // namespace
}  // namespace rupture::testing
