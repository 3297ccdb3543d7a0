// restart with another time step: the time of the state goes on, whatever dt it had before.
#include <algorithm>
#include <cmath>

#include "rupture/checkpoint/checkpoint.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

/// Starts from 1e-4 s, step 500; the rupture lasts from 1.5e-4 s to 2.5e-4 s.
class TimeStep : public ToolTest {
 protected:
  TimeStep() { output_of("load --config small.ini -o a.h5 --until 1e-4"); }
  State state_of(const std::string& file) const { return read_checkpoint(path(file)).state; }
  double time_of(const std::string& file) const {
    return json_of("analyze stress " + file + " --json")["time"];
  }
};

constexpr const char* kHalved = " --set numerics.dt=1e-7";

TEST_F(TimeStep, halved_takes_twice_as_many_steps_from_where_the_state_is) {
  output_of(std::string("restart a.h5 -o b.h5 --for 2e-5") + kHalved);
  const State before = state_of("a.h5"), after = state_of("b.h5");
  EXPECT_EQ(before.clock, Clock{});
  EXPECT_EQ(after.clock, (Clock{500, 500 * 2e-7}));
  EXPECT_EQ(after.step, 700);
  EXPECT_EQ(time_of("b.h5"), 500 * 2e-7 + 200 * 1e-7);
  const Json needs =
      json_of(std::string("restart a.h5 -o c.h5 --for 2e-5 --dry-run --json") + kHalved);
  EXPECT_EQ(needs["steps"], 200);
  EXPECT_NEAR(needs["simulated_time"].get<double>(), 2e-5, 1e-18);
}

TEST_F(TimeStep, for_and_until_mean_the_same_end) {
  output_of(std::string("restart a.h5 -o for.h5 --for 2e-4") + kHalved);
  output_of(std::string("restart a.h5 -o until.h5 --until 3e-4") + kHalved);
  EXPECT_EQ(checksum_of("for.h5"), checksum_of("until.h5"));
  expect_refusal(std::string("restart a.h5 -o b.h5 --until 9e-5") + kHalved, kUsage,
                 "--until 9e-05 is before the checkpoint's time 0.0001 s");
  expect_refusal("restart for.h5 -o b.h5 --until 5e-4 --checkpoint-at 2e-4", kUsage,
                 "--checkpoint-at 0.0002 is outside the run, 0.0003 s to 0.0005 s");
}

TEST_F(TimeStep, changed_and_changed_back_goes_on_in_time) {
  output_of(std::string("restart a.h5 -o b.h5 --for 5e-5") + kHalved);
  output_of("restart b.h5 -o c.h5 --for 5e-5 --set numerics.dt=2e-7 --checkpoint-at 1.6e-4");
  EXPECT_EQ(state_of("c.h5").clock, (Clock{1000, 500 * 2e-7 + 500 * 1e-7}));
  EXPECT_EQ(state_of("c.h5").step, 1250);
  EXPECT_NEAR(time_of("c.h5"), 2e-4, 1e-18);
  EXPECT_NEAR(time_of("c-t0.000160000.h5"), 1.6e-4, 1e-18);
}

TEST_F(TimeStep, changed_at_time_zero_is_as_if_it_had_always_been) {
  output_of("load --config small.ini -o zero.h5");
  output_of(std::string("restart zero.h5 -o b.h5 --until 2e-4") + kHalved);
  output_of(std::string("load --config small.ini -o c.h5 --until 2e-4") + kHalved);
  EXPECT_EQ(checksum_of("b.h5"), checksum_of("c.h5"));
}

TEST_F(TimeStep, unchanged_leaves_the_clock_alone) {
  output_of("restart a.h5 -o b.h5 --for 1e-5 --set numerics.dt=2e-7");
  output_of("restart a.h5 -o c.h5 --for 1e-5");
  EXPECT_EQ(checksum_of("b.h5"), checksum_of("c.h5"));
}

TEST_F(TimeStep, halves_of_a_run_with_a_changed_one_equal_the_whole) {
  for (const char* folder : {"whole", "halves"}) fs::create_directory(path(folder));
  output_of(std::string("restart a.h5 -o whole/end.h5 --until 3e-4") + kHalved);
  output_of(std::string("restart a.h5 -o half.h5 --until 1.903e-4") + kHalved);
  output_of("restart half.h5 -o halves/end.h5 --until 3e-4");
  EXPECT_EQ(output_of("analyze diff halves/end.h5 whole/end.h5"), "equal\n");
}

TEST_F(TimeStep, changed_moves_the_driving_point_on_at_its_speed) {
  output_of(std::string("restart a.h5 -o b.h5 --for 2e-5 --record r.h5 --record-every 1e-7") +
            kHalved);
  const Json loading = json_of("analyze loading r.h5 --json");
  ASSERT_EQ(loading["time"].size(), 201U);
  const double start = state_of("a.h5").drive.origin_position;  // that of t = 0
  for (std::size_t n = 0; n <= 200; ++n) {
    const double t = loading["time"][n];
    EXPECT_NEAR(loading["x_drive"][n].get<double>(), start + 1.0 * t, 1e-18) << n;  // V = 1 m/s
  }
}

TEST_F(TimeStep, changed_leaves_samples_at_multiples_of_their_interval) {
  output_of("load --config small.ini -o odd.h5 --until 1.11e-4");
  output_of(
      "restart odd.h5 -o b.h5 --until 3e-4 --record r.h5 --record-every 1e-5 --set "
      "numerics.dt=5e-8 --checkpoint-every 1e-4");
  const std::vector<double> times = json_of("analyze loading r.h5 --json")["time"];
  ASSERT_EQ(times.size(), 20U);
  EXPECT_NEAR(times[0], 1.11e-4, 1e-18);
  for (std::size_t n = 1; n < times.size(); ++n) {
    EXPECT_NEAR(times[n], 1e-5 * static_cast<double>(11 + n), 1e-18);
  }
  const Json ruptures = json_of("analyze front r.h5 --json")["t_rupture"];
  for (const auto& t : ruptures) EXPECT_TRUE(t.is_null() || (t > 1.11e-4 && t < 3e-4)) << t;
  EXPECT_TRUE(fs::exists(path("b-t0.000200000.h5")));
}

TEST_F(TimeStep, changed_is_resumed_to_the_bits_of_the_uninterrupted_run) {
  const std::string run =
      std::string(
          "restart a.h5 -o x.h5 --until 3e-4 --checkpoint-every 6e-5 --record r.h5 "
          "--record-every 2.5e-5") +
      kHalved;
  output_of(run);
  const std::string whole = checksum_of("x.h5"), record = checksum_of("r.h5");
  for (const char* later : {"x.h5", "x-t0.000300000.h5", "x-t0.000240000.h5"}) {
    fs::remove(path(later));
  }
  const std::string said = output_of(run + " --resume");
  EXPECT_NE(said.find("resuming from x-t0.000180000.h5"), std::string::npos) << said;
  EXPECT_EQ(checksum_of("x.h5"), whole);
  EXPECT_EQ(checksum_of("r.h5"), record);
  EXPECT_EQ(output_of(run + " --resume"), "x.h5 is complete\n");
}

TEST_F(TimeStep, beyond_the_stability_limit_is_refused) {
  expect_refusal("restart a.h5 -o b.h5 --for 1e-4 --set numerics.dt=1e-5", kUsage,
                 "numerics.dt = 1e-05 s is unstable: the limit for this lattice is 4.066e-06 s");
}

}  // namespace
}  // namespace rupture::testing
