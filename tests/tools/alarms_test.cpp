// Alarms: a run whose result is meaningless ends with a sentence, unless the user lets it go on.
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

/// Makes the driving spring all but too stiff for the time step; nothing damps it.
constexpr std::string_view kUnstable = " --set slider.damping=0 --set driving.K=1.6e11";
class Alarms : public ToolTest {
 protected:
  Alarms() { output_of("load --config small.ini -o a.h5 --until 1e-4"); }

  Outcome restart_unstable(const std::string& options) const {
    return run("restart a.h5 -o b.h5 " + options + std::string(kUnstable));
  }
};

TEST_F(Alarms, stop_a_bounded_instability_and_keep_what_was_written_before) {
  const Outcome outcome =
      restart_unstable("--for 2e-3 --checkpoint-at 1.01e-4 1.5e-3 --record r.h5");
  EXPECT_EQ(outcome.exit_code, kFailed);
  expect_one_sentence(outcome.err, "restart",
                      "restart: the energy account from t = 0.000101 s to 0.001 s is off by ");
  expect_one_sentence(outcome.err, "restart", "(the fastest block, (0, 1), moves at ");
  expect_one_sentence(outcome.err, "restart", "; --on-alarm report goes on nevertheless");
  EXPECT_FALSE(fs::exists(path("b.h5")));
  EXPECT_FALSE(fs::exists(path("b-t0.001500000.h5")));
  output_of("analyze verify b-t0.000101000.h5");
  EXPECT_FALSE(fs::exists(path("r.h5")));
  const std::vector<double> time = json_of("analyze loading r.h5.part --json")["time"];
  ASSERT_FALSE(time.empty());
  EXPECT_NEAR(time.back(), 9e-4, 1.1e-4);
}

TEST_F(Alarms, are_reported_once_where_the_user_goes_on) {
  for (const std::string quiet : {"", "--quiet "}) {
    const Outcome outcome = restart_unstable(quiet + "--force --for 3e-3 --on-alarm report");
    EXPECT_EQ(outcome.exit_code, kDone);
    expect_one_sentence(outcome.err, "restart", "alarm: the energy account from ");
    output_of("analyze verify b.h5");
  }
}

TEST_F(Alarms, warn_of_lowered_strength_unless_quiet) {
  const std::string command = "restart a.h5 -o b.h5 --force --for 1e-3 --set junctions.mu_s=0.18";
  const Outcome outcome = run(command);
  EXPECT_EQ(outcome.exit_code, kDone);
  expect_one_sentence(outcome.err, "restart", "restart: warning: ");
  expect_one_sentence(
      outcome.err, "restart",
      "junctions that bear more than they can at t = 0.0001 s: 200, the first in block 1");
  output_of(command + " --quiet");
}

}  // namespace
}  // namespace rupture::testing
