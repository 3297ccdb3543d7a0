// analyze: what it measures in records and checkpoints, as text, JSON and CSV.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "rupture/model/parameters.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

/// A rupture that crosses the interface, and what follows with the driving point at rest.
class Analyze : public ToolTest {
 protected:
  Analyze() {
    output_of("load --config small.ini -o half.h5 --until 2e-4");
    output_of("load --config small.ini -o a.h5 --until 3e-4 --record r.h5 --record-every 1e-5");
    output_of(
        "restart half.h5 -o b.h5 --set driving.V=0 --until 6e-3 --record rest.h5 "
        "--record-every 1e-5");
  }

  /// Demands that CSV has this head and that many lines of as many cells below it.
  void expect_csv(const std::string& command, const std::vector<std::string>& head,
                  std::size_t lines) const {
    const auto rows = csv_of(output_of(command + " --csv"));
    ASSERT_FALSE(rows.empty());
    EXPECT_EQ(rows.front(), head);
    EXPECT_EQ(rows.size(), lines + 1) << command;
    for (const auto& row : rows) EXPECT_EQ(row.size(), head.size()) << command;
  }
};

void expect_fields(const Json& json, const std::vector<std::string>& names) {
  for (const auto& name : names) EXPECT_TRUE(json.contains(name)) << name;
}

TEST_F(Analyze, stress_has_the_documented_fields) {
  const Json json = json_of("analyze stress a.h5 --json");
  expect_fields(json, {"time", "x", "p", "tau", "F_T", "F_N"});
  EXPECT_EQ(json["time"], 3e-4);
  for (const char* name : {"x", "p", "tau"}) EXPECT_EQ(json[name].size(), 9U) << name;
  expect_csv("analyze stress a.h5", {"x [m]", "p [N]", "tau [N]"}, 9);
}

TEST_F(Analyze, stress_of_slipping_blocks_is_at_the_slipping_force) {
  output_of("load --config small.ini -o sliding.h5 --until 6e-4");
  const Json json = json_of("analyze stress sliding.h5 --json");
  const std::vector<double> p = json["p"], tau = json["tau"];
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_NEAR(tau[i] / p[i], 0.17, 0.01);
}

TEST_F(Analyze, front_has_the_documented_fields) {
  const Json json = json_of("analyze front r.h5 --json");
  expect_fields(json, {"x", "t_rupture", "v_c", "type", "reached_edge", "fast_slow_fast",
                       "backward_stencils", "x_arrest", "slow"});
  EXPECT_EQ(json["type"], "fast");
  EXPECT_TRUE(json["x_arrest"].is_null());
  EXPECT_TRUE(json["slow"].is_null());
  ASSERT_EQ(json["v_c"].size(), 9U);
  EXPECT_TRUE(json["v_c"][0].is_null());
  EXPECT_GT(json["v_c"][4], 500.0);
  EXPECT_GT(json["t_rupture"][8], json["t_rupture"][2]);
  expect_csv("analyze front r.h5", {"x [m]", "t_rupture [s]", "v_c [m/s]"}, 9);
}

TEST_F(Analyze, front_in_a_window_that_ends_early_is_arrested) {
  const Json json = json_of("analyze front r.h5 --from 0 --to 2e-4 --json");
  EXPECT_EQ(json["type"], "arrested");
  EXPECT_NEAR(json["x_arrest"], 0.0525, 1e-9);
  EXPECT_EQ(output_of("analyze classify r.h5 --to 2e-4"), "arrested\n");
}

TEST_F(Analyze, front_is_slow_where_it_is_below_the_given_speed) {
  const Json json = json_of("analyze front r.h5 --slow-below 3 --json");
  EXPECT_EQ(json["type"], "slow");
  expect_fields(json["slow"], {"x_from", "x_to", "duration", "speed"});
  EXPECT_LT(json["slow"]["speed"], 3 * 1000.0);
}

TEST_F(Analyze, classify_prints_the_type_alone) {
  EXPECT_EQ(output_of("analyze classify r.h5"), "fast\n");
  EXPECT_EQ(json_of("analyze classify r.h5 --json")["type"], "fast");
}

TEST_F(Analyze, texts_call_a_fast_slow_fast_front_so) {
  output_of("restart " RUPTURE_CHECKPOINTS "/second-slow.h5 -o e.h5 --for 4e-3 --record e-r.h5");
  EXPECT_EQ(output_of("analyze classify e-r.h5"), "fast-slow-fast\n");
  EXPECT_NE(output_of("analyze events e-r.h5").find(" fast-slow-fast "), std::string::npos);
  EXPECT_EQ(lines_of(output_of("analyze front e-r.h5 --slow-below 0.005")).back(),
            "fast-slow-fast front; below c_s/10, but not below --slow-below");
  for (const char* command : {"classify", "front"}) {
    const Json json = json_of("analyze " + std::string(command) + " e-r.h5 --json");
    EXPECT_EQ(json["type"], "slow");
    EXPECT_EQ(json["fast_slow_fast"], true);
  }
}

TEST_F(Analyze, classify_has_no_series_to_print_as_csv) {
  expect_refusal_with("analyze classify r.h5 --csv", kUsage, "unknown option '--csv'");
}

TEST_F(Analyze, events_have_the_documented_fields) {
  const Json json = json_of("analyze events r.h5 --json");
  ASSERT_EQ(json["events"].size(), 1U);
  const Json& event = json["events"][0];
  expect_fields(
      event, {"number", "t_start", "t_end", "x_first", "x_last", "spanning", "type", "reached_edge",
              "fast_slow_fast", "backward_stencils", "F_T_before", "F_T_after"});
  EXPECT_NEAR(event["t_start"], 1.526e-4, 1e-9);
  EXPECT_NEAR(event["t_end"], 2.53e-4, 1e-9);
  EXPECT_NEAR(event["x_last"], 0.14, 1e-12);
  EXPECT_EQ(event["spanning"], true);
  EXPECT_EQ(event["type"], "fast");
}

TEST_F(Analyze, record_without_rupture_has_no_events) {
  output_of("load --config small.ini -o quiet.h5 --until 1e-4 --record quiet-r.h5");
  EXPECT_EQ(json_of("analyze events quiet-r.h5 --json").dump(), R"({"events":[]})");
  EXPECT_EQ(lines_of(output_of("analyze events quiet-r.h5 --csv")).size(), 1U);
  const Json front = json_of("analyze front quiet-r.h5 --json");
  EXPECT_EQ(front["type"], "none");
  for (const auto& time : front["t_rupture"]) EXPECT_TRUE(time.is_null());
  EXPECT_TRUE(json_of("analyze slip quiet-r.h5 --x 0.07 --json")["t_rupture"].is_null());
}

TEST_F(Analyze, slip_starts_at_zero_and_grows) {
  const Json json = json_of("analyze slip rest.h5 --x 0.0701 --json");
  expect_fields(json,
                {"x", "t_rupture", "t_arrest", "fast_slip", "slow_slip", "slow_from", "slow_to",
                 "slow_speed", "slow_speed_error", "slow_r_squared", "time", "slip"});
  EXPECT_NEAR(json["x"], 0.07, 1e-12);  // the nearest block
  EXPECT_NEAR(json["t_rupture"], 2.016e-4, 1e-7);
  EXPECT_GT(json["t_arrest"], json["t_rupture"]);
  EXPECT_GT(json["fast_slip"], 0.0);
  EXPECT_EQ(json["slip"][0], 0.0);
  EXPECT_GT(json["slip"].back(), 1e-6);
  const Json edge = json_of("analyze slip rest.h5 --x 0.14 --json");  // where it slips forwards
  EXPECT_NEAR(edge["slow_speed"], 0.66e-3, 0.01e-3);
  EXPECT_NEAR(edge["slow_speed_error"], 0.02e-3, 0.01e-3);
  expect_csv("analyze slip rest.h5 --x 0.07", {"time [s]", "slip [m]"}, json["time"].size());
}

TEST_F(Analyze, slow_slip_of_blocks_behind_a_slow_front) {
  output_of("prepare --tau-bar 0.1 --sigma-bar 0.1 -o p.h5");
  output_of("restart p.h5 -o q.h5 --until-quiet --record q-r.h5 --record-every 2e-5");
  const std::string command = "analyze slow-slip q-r.h5 --skip-below-x 0.0275";
  const Json json = json_of(command + " --json");
  expect_fields(json, {"type", "slow", "blocks", "front_speed", "speed", "estimate", "per_block"});
  expect_fields(json["per_block"],
                {"x", "t_from", "t_to", "speed", "r_squared", "v_c", "estimate"});
  EXPECT_EQ(json["per_block"]["x"].size(), 15U);
  EXPECT_EQ(json["blocks"], 15);
  EXPECT_NEAR(json["front_speed"], 9.06, 0.01);
  EXPECT_NEAR(json["speed"]["mean"], 1.018e-3, 0.001e-3);
  EXPECT_LT(json["speed"]["min"], json["speed"]["mean"]);
  EXPECT_GT(json["speed"]["max"], json["speed"]["mean"]);
  EXPECT_NEAR(json["estimate"], 1.0464e-3, 1e-7);
  EXPECT_EQ(json_of(command + " --x-from 0.04 --x-to 0.05 --json")["blocks"], 5);
  EXPECT_EQ(json_of(command + " --longest 2 --shortest 2 --json")["blocks"], 3);
  EXPECT_EQ(json_of(command + " --to-last-stencil --json")["blocks"], 16);
  expect_csv(
      command,
      {"x [m]", "t_from [s]", "t_to [s]", "speed [m/s]", "R^2", "v_c [m/s]", "estimate [m/s]"}, 15);
}

TEST_F(Analyze, front_goes_by_the_conventions_given) {
  output_of("prepare --config small.ini --set driving.V=0 --tau-bar 0.6 --sigma-bar 0.2 -o p.h5");
  output_of("restart p.h5 -o q.h5 --until 1e-4 --record q-r.h5 --crossings 0.2,0.7");
  const auto first_rupture = [&](const std::string& level) {
    const std::string with = " q-r.h5 --json --ruptured-below " + level;
    const Json event = json_of("analyze events" + with)["events"][0];
    EXPECT_EQ(event["t_start"], json_of("analyze front" + with)["t_rupture"][2]);
    return double{event["t_start"]};
  };
  EXPECT_LT(first_rupture("0.7"), first_rupture("0.3"));
  EXPECT_LT(first_rupture("0.3"), first_rupture("0.2"));

  const Json wide = json_of("analyze front r.h5 --json --stencil 7")["v_c"];
  EXPECT_TRUE(wide[2].is_null());
  EXPECT_FALSE(wide[3].is_null());
  const std::string slow = "analyze front r.h5 --json --slow-below 3 --stencil 3";
  const auto x_from = [&](const std::string& rule) {
    return double{json_of(slow + " --stencils-at-ends " + rule)["slow"]["x_from"]};
  };
  EXPECT_GT(x_from("neither"), x_from("slow"));
  EXPECT_EQ(x_from("neither"), x_from("fast"));
  EXPECT_EQ(json_of(slow)["slow"]["x_from"], x_from("neither"));
}

TEST_F(Analyze, front_slow_for_less_than_a_stencil_is_slow_without_numbers) {
  const std::string front = "analyze front r.h5 --slow-below 3 --stencil 7";
  const Json json = json_of(front + " --json");
  EXPECT_EQ(json["type"], "slow");
  EXPECT_TRUE(json["slow"].is_null());
  EXPECT_EQ(lines_of(output_of(front)).back(), "slow front; slow for less than a stencil");
}

TEST_F(Analyze, slow_slip_of_no_block_has_no_speed) {
  const Json json = json_of("analyze slow-slip r.h5 --json");
  EXPECT_EQ(json["blocks"], 0);
  EXPECT_TRUE(json["speed"]["mean"].is_null());
  EXPECT_TRUE(json["front_speed"].is_null());
  EXPECT_TRUE(json["estimate"].is_null());
  EXPECT_NE(output_of("analyze slow-slip r.h5").find("0 blocks slip at - mm/s"), std::string::npos);
  expect_refusal("analyze slow-slip r.h5 --x-from 0.1 --x-to 0.05", kUsage,
                 "there is no block between --x-from and --x-to");
}

TEST_F(Analyze, slip_counts_from_the_start_of_the_window) {
  const Json json = json_of("analyze slip rest.h5 --x 0.07 --from 1e-3 --to 2e-3 --json");
  EXPECT_NEAR(json["time"].front(), 1e-3, 1e-9);
  EXPECT_NEAR(json["time"].back(), 2e-3, 1e-9);
  EXPECT_EQ(json["slip"][0], 0.0);
}

TEST_F(Analyze, loading_holds_the_series) {
  const Json json = json_of("analyze loading r.h5 --x 0.07 --json");
  for (const char* name : {"time", "F_T", "x_drive", "p", "tau", "u_x"}) {
    EXPECT_EQ(json[name].size(), 31U) << name;
  }
  EXPECT_EQ(json["F_N"], 1920.0);
  expect_csv("analyze loading r.h5", {"time [s]", "F_T [N]", "x_drive [m]"}, 31);
  expect_csv("analyze loading r.h5 --x 0",
             {"time [s]", "F_T [N]", "x_drive [m]", "p [N]", "tau [N]", "u_x [m]"}, 31);
}

TEST_F(Analyze, record_ends_with_the_stress_of_the_checkpoint) {
  const Json loading = json_of("analyze loading r.h5 --x 0.07 --json");
  const Json stress = json_of("analyze stress a.h5 --json");
  EXPECT_EQ(loading["F_T"].back(), stress["F_T"]);
  EXPECT_EQ(loading["p"].back(), stress["p"][4]);
  EXPECT_NEAR(loading["tau"].back(), stress["tau"][4], 1e-12);
}

TEST_F(Analyze, phi_counts_all_junctions) {
  const Json json = json_of("analyze phi half.h5 --bins 20 --json");
  expect_fields(json,
                {"x", "mean", "sigma", "sigma_bar", "slipping", "f_thres", "f_slip", "histogram"});
  ASSERT_EQ(json["histogram"].size(), 9U);
  for (const auto& histogram : json["histogram"]) {
    const std::vector<int> counts = histogram;
    EXPECT_EQ(counts.size(), 20U);
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0), 100);
  }
  EXPECT_NEAR(json["f_slip"][0].get<double>() / json["f_thres"][0].get<double>(), 0.17 / 0.4,
              1e-12);
  expect_csv("analyze phi half.h5",
             {"x [m]", "mean [N]", "sigma [N]", "sigma_bar", "slipping", "f_thres [N]"}, 9);
}

TEST_F(Analyze, text_is_for_people) {
  for (const std::string command :
       {"stress a.h5", "phi a.h5", "front r.h5", "events r.h5", "slip r.h5 --x 0.07",
        "loading r.h5", "show a.h5", "show r.h5"}) {
    EXPECT_GE(lines_of(output_of("analyze " + command)).size(), 1U) << command;
  }
}

TEST_F(Analyze, refuses_what_makes_no_sense) {
  expect_refusal("analyze stress", kUsage, "no file was given: name a checkpoint");
  expect_refusal("analyze front", kUsage, "no file was given: name a record");
  expect_refusal("analyze stress a.h5 b.h5", kUsage,
                 "'b.h5' is one file too many: name only a checkpoint");
  expect_refusal("analyze stress a.h5 --json --csv", kUsage,
                 "--json and --csv exclude each other: give one");
  expect_refusal("analyze phi a.h5 --bins 0", kUsage, "--bins 0 makes no sense: give 1 to 100000");
  expect_refusal("analyze phi a.h5 --bins many", kUsage,
                 "--bins many is not a whole number of this size; see rupture analyze phi --help");
  expect_refusal("analyze slip r.h5", kUsage,
                 "the option '--x' is required but missing; see rupture analyze slip --help");
  expect_refusal("analyze slip r.h5 --x 1", kUsage,
                 "--x 1 is beyond the interface, which ends at 0.14 m");
  expect_refusal("analyze front r.h5 --from 2e-4 --to 1e-4", kUsage,
                 "the time window is empty: --to is before --from");
  expect_refusal("analyze front r.h5 --slow-below nan", kUsage,
                 "--slow-below nan makes no sense: give a number of at least 0");
  expect_refusal("analyze events r.h5 --quiet-time -1", kUsage,
                 "--quiet-time -1 makes no sense: give a number of at least 0");
}

TEST_F(Analyze, refuses_a_billion_bins) {
  if (RUPTURE_SANITIZED) GTEST_SKIP() << "AddressSanitizer needs more memory than the limit";
  expect_refusal_with("analyze phi a.h5 --bins 2000000000", kUsage, "--bins",
                      {.memory = std::uint64_t{4} << 30U});
}

TEST_F(Analyze, refuses_a_window_outside_the_record) {
  expect_refusal_with("analyze slip r.h5 --x 0.07 --from 5", kUsage, "--from 5");
}

// --- checksum, show ---------------------------------------------------------------

TEST_F(Analyze, checksum_is_64_digits_and_a_newline) {
  const std::string text = output_of("analyze checksum a.h5");
  EXPECT_EQ(text.find_first_not_of("0123456789abcdef"), 64U);
  EXPECT_EQ(text.substr(64), "\n");
}

TEST_F(Analyze, checksum_does_not_depend_on_the_command_line) {
  output_of(
      "load --set slider.Nx=9 --set slider.Nz=5 --set slider.H=0.07 --set driving.h=0.0175 "
      "--set driving.V=1 --output other.h5 --until 3e-4");
  EXPECT_EQ(checksum_of("other.h5"), checksum_of("a.h5"));
}

TEST_F(Analyze, show_names_kind_parameters_and_provenance) {
  const Json json = json_of("analyze show r.h5 --json");
  EXPECT_EQ(json["kind"], "a record");
  EXPECT_EQ(json["checksum"], checksum_of("r.h5"));
  EXPECT_EQ(json["parameters"].size(), parameter_table().size());
  EXPECT_EQ(json["parameters"]["driving.V"], 1.0);
  EXPECT_TRUE(json["parameters"]["driving.V"].is_number_float());
  EXPECT_EQ(json["parameters"]["slider.Nx"], 9);
  EXPECT_TRUE(json["parameters"]["slider.Nx"].is_number_integer());
  EXPECT_EQ(json["parameters"]["junctions.law"], "reference");
  EXPECT_EQ(json["provenance"].size(), 1U);
  const std::string text = output_of("analyze show a.h5");
  EXPECT_NE(text.find("a.h5: checkpoint at t = 0.0003 s, step 1500"), std::string::npos) << text;
}

}  // namespace
}  // namespace rupture::testing
