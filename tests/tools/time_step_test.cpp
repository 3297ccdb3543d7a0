// restart with another time step: the time of the state goes on, whatever dt it had before.
#include "rupture/checkpoint/checkpoint.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

/// Starts from 1e-4 s, step 500; the rupture lasts from 1.5e-4 s to 2.5e-4 s.
class TimeStep : public ToolTest {
 protected:
  TimeStep() { output_of("load --config small.ini -o a.h5 --until 1e-4"); }
  State state_of(const std::string& file) const { return read_checkpoint(path(file)).state; }
};

constexpr const char* kHalved = " --set numerics.dt=1e-7";

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

}  // namespace
}  // namespace rupture::testing
