// load and restart --dry-run: what a run would need, compared with what it needs.
#include <cstdint>

#include "tool_test.hpp"

namespace rupture::testing {
namespace {

class DryRun : public ToolTest {
 protected:
  /// The forecast for a command; demands that it changed no file.
  Json forecast(const std::string& command) const {
    const Files before = files();
    const Json json = json_of(command + " --dry-run --json");
    EXPECT_EQ(files(), before) << command;
    return json;
  }

  /// Bytes of the checkpoints and records that have come since, as forecasts count them.
  double size_of_new_files(const Files& before) const {
    double size = 0.0;
    for (const auto& [name, bytes] : files()) {
      if (!before.contains(name)) {
        size += static_cast<double>(bytes.size());
      }
    }
    return size;
  }

  /// Demands that the forecast of memory and disk is within 15 % of what the run needs.
  void expect_forecast_holds(const std::string& command) const {
    const Json json = forecast(command);
    const Files before = files();
    const Outcome outcome = run(command + " -q");
    ASSERT_EQ(outcome.exit_code, kDone) << outcome.err;
    const double disk = size_of_new_files(before);
    EXPECT_NEAR(json["disk"], disk, 0.15 * disk) << command;
    if (RUPTURE_SANITIZED) return;  // needs several times the memory
    const auto memory = static_cast<double>(outcome.peak_memory);
    EXPECT_NEAR(json["memory"], memory, 0.15 * memory) << command;
  }
};

/// A lattice whose equilibrium needs more memory than anything else.
constexpr const char* kWide =
    " --set slider.Nx=113 --set slider.Nz=61 --set numerics.dt=1e-7 --set driving.h=0.005";

/// The same with more blocks, solved in another order.
constexpr const char* kWider =
    " --set slider.Nx=141 --set slider.Nz=76 --set numerics.dt=1e-7 --set driving.h=0.005";

TEST_F(DryRun, SLOW_memory_and_disk_of_load) {
  expect_forecast_holds(std::string("load -o a.h5 --until 1e-5 --checkpoint-every 5e-6") + kWide);
  expect_forecast_holds(std::string("load -o c.h5 --until 1e-5 --checkpoint-every 5e-6") + kWider);
  expect_forecast_holds("load -o b.h5 --until 2e-4 --record b-r.h5 --record-every 2e-6");
  expect_forecast_holds("load -o d.h5 --until 2e-3 --record d-r.h5 --fields 2e-6");
}

TEST_F(DryRun, SLOW_memory_and_disk_of_restart) {
  output_of(std::string("load -o a.h5 -q") + kWide);
  expect_forecast_holds("restart a.h5 -o b.h5 --for 1e-5 --checkpoint-every 2e-6");
  expect_forecast_holds("restart a.h5 -o c.h5 --for 5e-4 --record c-r.h5 --record-every 1e-7");
}

TEST_F(DryRun, counts_what_the_run_will_do) {
  const Json load = forecast(
      "load --config small.ini -o a.h5 --until 1e-4 --checkpoint-every 3e-5 --checkpoint-at 0 "
      "--threads 2");
  EXPECT_EQ(load["steps"], 500);
  EXPECT_DOUBLE_EQ(load["simulated_time"], 1e-4);
  EXPECT_EQ(load["at_most"], false);
  EXPECT_EQ(load["blocks"], 45);
  EXPECT_EQ(load["junctions"], 900);
  EXPECT_EQ(load["threads"], 2);
  EXPECT_EQ(load["checkpoints"], 5);  // at 0, 3e-5, 6e-5, 9e-5 and the end
  EXPECT_GT(load["time_per_step"], 0.0);
  EXPECT_GT(load["time"], 500 * load["time_per_step"].get<double>());  // and the equilibrium

  output_of("load --config small.ini -o a.h5 --until 1e-4");
  const Json restart = forecast("restart a.h5 -o b.h5 --until 3e-4");
  EXPECT_EQ(restart["steps"], 1000);
  EXPECT_DOUBLE_EQ(restart["time"], 1000 * restart["time_per_step"].get<double>());
}

TEST_F(DryRun, counts_the_samples_of_the_record) {
  output_of("load --config small.ini -o a.h5 --until 1.3e-5");
  const std::string command =
      "restart a.h5 -o b.h5 --until 1.1e-4 --record r.h5 --record-every 2e-5";
  const std::string text = output_of(command + " --dry-run");
  output_of(command);
  const std::size_t samples = json_of("analyze loading r.h5 --json")["time"].size();
  EXPECT_NE(text.find("record of " + std::to_string(samples) + " samples"), std::string::npos)
      << text;
}

TEST_F(DryRun, of_a_resumed_run_is_what_is_left) {
  const std::string half = "load --config small.ini -o a.h5 --until 1e-4 --checkpoint-every 5e-5";
  const std::string whole = "load --config small.ini -o a.h5 --until 3e-4 --checkpoint-every 5e-5";
  output_of(half);
  EXPECT_EQ(forecast(half + " --resume --sum")["steps"], 0);  // which would write the sums
  EXPECT_EQ(forecast(half + " --resume")["checkpoints"], 0);
  fs::remove(path("a.h5"));
  const Json json = forecast(whole + " --resume");
  EXPECT_EQ(json["steps"], 1000);
  EXPECT_EQ(json["checkpoints"], 5);
}

TEST_F(DryRun, text_is_for_people) {
  const auto lines = lines_of(output_of("load -o a.h5 --until 1.2 --record r.h5 --dry-run"));
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[0], "steps    6,000,000, 1.2 s simulated");
  EXPECT_EQ(lines[1], "slider   1,767 blocks, 5,700 junctions");
  EXPECT_TRUE(lines[3].starts_with("memory   about ")) << lines[3];
  EXPECT_EQ(lines[4],
            "disk     about 18 MB: 1 checkpoint of 0.24 MB; record of 12,001 samples, 18 MB, and "
            "24 bytes for each rupture of a block");
  EXPECT_TRUE(lines[5].starts_with("time     about ")) << lines[5];
  const auto with_fields =
      lines_of(output_of("load -o a.h5 --until 1.2 --record r.h5 --fields 1e-3 --dry-run"));
  EXPECT_EQ(with_fields[4],
            "disk     about 35 MB: 1 checkpoint of 0.24 MB; record of 12,001 samples and 1,201 of "
            "all blocks, 35 MB, and 24 bytes for each rupture of a block");
}

}  // namespace
}  // namespace rupture::testing
