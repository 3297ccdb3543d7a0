// restart: continuing a run gives what the uninterrupted one gave; changing parameters does not.
#include <cmath>

#include "rupture/checkpoint/file.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

class Restart : public ToolTest {
 protected:
  /// The option leaves the state as it is and adds so many datasets to the record, in this group.
  void expect_added_to_record(const std::string& option, const char* group, std::size_t datasets) {
    const std::string run = "load --config small.ini --until 3e-4 -o ";
    output_of(run + "a.h5 --record a-r.h5");
    output_of(run + "b.h5 --record b-r.h5 " + option);
    EXPECT_EQ(checksum_of("a.h5"), checksum_of("b.h5"));
    const Outcome outcome = run_words({"analyze", "diff", "a-r.h5", "b-r.h5", "--json"});
    EXPECT_EQ(outcome.exit_code, kFailed);
    const Json differences = Json::parse(outcome.out)["differences"];
    EXPECT_EQ(differences.size(), datasets);
    for (const Json& difference : differences) {
      EXPECT_EQ(difference["change"], "only_in_b");
      EXPECT_TRUE(std::string(difference["path"]).starts_with(group));
    }
  }
};

/// Where a run to 6e-4 s is split; the rupture lasts from 1.5e-4 s to 2.5e-4 s.
class Split : public ToolTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(Split, halves_equal_the_whole) {
  for (const char* folder : {"whole", "halves"}) fs::create_directory(path(folder));
  output_of("load --config small.ini -o whole/end.h5 --until 6e-4");
  output_of(std::string("load --config small.ini -o half.h5 --until ") + GetParam());
  output_of("restart half.h5 -o halves/end.h5 --until 6e-4");
  EXPECT_EQ(checksum_of("halves/end.h5"), checksum_of("whole/end.h5"));
  EXPECT_EQ(output_of("analyze diff halves/end.h5 whole/end.h5"), "equal\n");
}

INSTANTIATE_TEST_SUITE_P(BeforeDuringAfter, Split,
                         ::testing::Values("0", "1e-4", "1.9e-4", "2.3e-4", "4e-4", "6e-4"),
                         [](const auto& test) {
                           return std::string("number") + std::to_string(test.index);
                         });

/// Value of one column at each time of a record.
std::map<double, double> column(const Json& loading, const char* name) {
  const std::vector<double> time = loading["time"], values = loading[name];
  std::map<double, double> result;
  for (std::size_t n = 0; n < time.size(); ++n) result[time[n]] = values[n];
  return result;
}

TEST_F(Restart, records_of_the_halves_are_that_of_the_whole) {
  output_of(
      "load --config small.ini -o whole.h5 --until 6e-4 --record whole-r.h5 --record-every 2e-5");
  output_of("load --config small.ini -o half.h5 --until 1.9e-4 --record r1.h5 --record-every 2e-5");
  output_of("restart half.h5 -o end.h5 --until 6e-4 --record r2.h5 --record-every 2e-5");
  EXPECT_EQ(checksum_of("end.h5"), checksum_of("whole.h5"));
  const Json whole = json_of("analyze loading whole-r.h5 --x 0.07 --json");
  for (const char* name : {"F_T", "x_drive", "p", "tau", "u_x"}) {
    auto joined = column(json_of("analyze loading r1.h5 --x 0.07 --json"), name);
    joined.merge(column(json_of("analyze loading r2.h5 --x 0.07 --json"), name));
    for (const auto& [time, value] : column(whole, name)) EXPECT_EQ(joined.at(time), value) << name;
    EXPECT_EQ(joined.size(), whole["time"].size() + 1) << "1.9e-4 s is sampled by the halves only";
  }
}

TEST_F(Restart, ruptures_of_the_halves_are_those_of_the_whole) {
  output_of("load --config small.ini -o whole.h5 --until 6e-4 --record whole-r.h5");
  output_of("load --config small.ini -o half.h5 --until 1.9e-4 --record r1.h5");
  output_of("restart half.h5 -o end.h5 --until 6e-4 --record r2.h5");
  const Json whole = json_of("analyze front whole-r.h5 --json")["t_rupture"];
  const Json first = json_of("analyze front r1.h5 --json")["t_rupture"];
  const Json second = json_of("analyze front r2.h5 --json")["t_rupture"];
  ASSERT_EQ(whole.size(), 9U);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(first[i].is_null() ? second[i] : first[i], whole[i]) << "block " << i;
  }
  EXPECT_FALSE(first[1].is_null());
  EXPECT_TRUE(first[8].is_null());
}

TEST_F(Restart, crossings_of_the_halves_are_those_of_the_whole) {
  const std::string how = " --crossings 0.7,0.2 --record ";
  output_of("prepare --config small.ini --set driving.V=0 --tau-bar 0.6 --sigma-bar 0.2 -o p.h5");
  output_of("restart p.h5 -o whole.h5 --until 1e-4" + how + "whole-r.h5");
  output_of("restart p.h5 -o half.h5 --until 5.58e-5" + how + "r1.h5");  // block 4 in between
  output_of("restart half.h5 -o end.h5 --until 1e-4" + how + "r2.h5");
  for (const std::string level : {"0.2", "0.3", "0.7"}) {
    const auto ruptures_in = [&](const std::string& record) {
      return json_of("analyze front " + record + " --json --ruptured-below " + level)["t_rupture"];
    };
    const Json whole = ruptures_in("whole-r.h5"), first = ruptures_in("r1.h5"),
               second = ruptures_in("r2.h5");
    for (std::size_t i = 0; i < whole.size(); ++i) {
      EXPECT_TRUE(first[i].is_null() || second[i].is_null()) << "block " << i << " at " << level;
      EXPECT_EQ(first[i].is_null() ? second[i] : first[i], whole[i]) << "block " << i;
    }
    EXPECT_FALSE(whole[4].is_null());
    EXPECT_EQ(first[4].is_null(), level == "0.2");
  }
}

// The last sample is the state in the checkpoint, rounded; samples are taken at the same steps
// whether the run was split or not.
TEST_F(Restart, fields_are_those_of_the_states) {
  const std::string how = " --fields 4e-5 --record ";
  output_of("load --config small.ini -o a.h5 --until 1e-4" + how + "a-r.h5");
  output_of("restart a.h5 -o b.h5 --until 3e-4" + how + "b-r.h5");
  output_of("load --config small.ini -o whole.h5 --until 3e-4" + how + "whole-r.h5");
  const Content state = read_content(path("b.h5"));
  const Content first = read_content(path("a-r.h5")), second = read_content(path("b-r.h5")),
                whole = read_content(path("whole-r.h5"));
  const Shape lattice = state.at("/state/u_x").shape;
  const auto of = [&](const Content& record, const std::string& name, std::uint64_t samples) {
    return read_array<float>(record, "/fields/" + name, {samples, lattice[0], lattice[1]});
  };
  for (const std::string name : {"u_x", "u_z"}) {
    const auto values = of(whole, name, 9);  // at 0, 4e-5, ..., 2.8e-4 and 3e-4
    const auto exact = read_array<double>(state, "/state/" + name, lattice);
    EXPECT_TRUE(std::equal(exact.begin(), exact.end(), values.end() - std::ssize(exact),
                           [](double a, float b) { return static_cast<float>(a) == b; }));
    const auto a = of(first, name, 4), b = of(second, name, 7);  // 1e-4 is in both
    EXPECT_TRUE(std::equal(a.begin(), a.end() - std::ssize(exact), values.begin()));
    EXPECT_TRUE(
        std::equal(b.begin() + std::ssize(exact), b.end(), values.begin() + 3 * std::ssize(exact)));
  }
}

TEST_F(Restart, fields_change_nothing_else) {
  expect_added_to_record("--fields 5e-5", "/fields/", 4);
  EXPECT_EQ(output_of("analyze events b-r.h5"), output_of("analyze events a-r.h5"));
}

TEST_F(Restart, crossings_change_nothing_else) {
  expect_added_to_record("--crossings 0.5", "/crossings/", 5);
}

TEST_F(Restart, for_and_until_mean_the_same_end) {
  output_of("load --config small.ini -o a.h5 --until 1e-4");
  output_of("restart a.h5 -o for.h5 --for 2e-4");
  output_of("restart a.h5 -o until.h5 --until 3e-4");
  EXPECT_EQ(checksum_of("for.h5"), checksum_of("until.h5"));
}

TEST_F(Restart, checkpoints_on_the_way_are_those_of_the_whole) {
  output_of("load --config small.ini -o whole.h5 --until 3e-4 --checkpoint-every 1e-4");
  output_of("restart whole-t0.000100000.h5 -o end.h5 --until 3e-4 --checkpoint-every 1e-4");
  EXPECT_EQ(checksum_of("end-t0.000200000.h5"), checksum_of("whole-t0.000200000.h5"));
  EXPECT_FALSE(fs::exists(path("end-t0.000100000.h5")));
}

TEST_F(Restart, seed_given_before_the_first_break_is_that_of_the_whole_run) {
  output_of("load --config small.ini -o whole.h5 --seed 7 --until 6e-4");
  output_of("load --config small.ini -o loaded.h5 --until 1e-4");
  output_of("restart loaded.h5 -o end.h5 --set numerics.seed=7 --until 6e-4");
  EXPECT_EQ(checksum_of("end.h5"), checksum_of("whole.h5"));
  output_of("restart loaded.h5 -o other.h5 --until 6e-4");
  EXPECT_EQ(run("analyze diff other.h5 end.h5").exit_code, kFailed) << "seeds make a difference";
}

TEST_F(Restart, zero_speed_stops_the_driving_point_where_it_is) {
  output_of("load --config small.ini -o a.h5 --until 5e-5 --record r1.h5");
  output_of("restart a.h5 -o b.h5 --set driving.V=0 --for 2e-4 --record r2.h5");
  const std::vector<double> before = json_of("analyze loading r1.h5 --json")["x_drive"];
  const std::vector<double> after = json_of("analyze loading r2.h5 --json")["x_drive"];
  ASSERT_GE(after.size(), 3U);
  for (const double x : after) EXPECT_EQ(x, before.back());
}

TEST_F(Restart, driving_force_stays_constant_at_rest) {
  output_of("load --config small.ini --set driving.V=0.05 -o a.h5 --until 5e-4");
  output_of("restart a.h5 -o rest.h5 --set driving.V=0 --for 2e-2");
  output_of("restart rest.h5 -o b.h5 --for 1e-3 --record r.h5");
  const std::vector<double> F_T = json_of("analyze loading r.h5 --json")["F_T"];
  ASSERT_GT(F_T.front(), 10.0);
  for (const double force : F_T) EXPECT_NEAR(force, F_T.front(), 1e-9 * F_T.front());
}

TEST_F(Restart, provenance_is_a_chain_of_tools) {
  output_of("load --config small.ini -o a.h5 --until 5e-5");
  output_of("restart a.h5 -o b.h5 --set driving.V=0 --for 1e-5");
  const Json chain = json_of("analyze show b.h5 --json")["provenance"];
  ASSERT_EQ(chain.size(), 2U);
  EXPECT_EQ(chain[0]["tool"], "load");
  EXPECT_EQ(chain[0]["parent_checksum"], "");
  EXPECT_EQ(chain[1]["tool"], "restart");
  EXPECT_EQ(chain[1]["parent_checksum"], checksum_of("a.h5"));
  const std::string command_line = chain[1]["command_line"];
  EXPECT_NE(command_line.find("restart a.h5 -o b.h5 --set driving.V=0 --for 1e-5"),
            std::string::npos);
  for (const char* field : {"version", "commit", "compiler"}) EXPECT_NE(chain[1][field], "");
}

TEST_F(Restart, until_quiet_stops_when_nothing_breaks_any_more) {
  output_of("load --config small.ini -o a.h5");
  const std::string out =
      output_of("restart a.h5 -o b.h5 --set driving.V=0 --until-quiet 1e-4 --until 1e-2");
  EXPECT_NE(out.find("t = 0.0001 s (no junction broke any more), 500 steps"), std::string::npos)
      << out;
}

TEST_F(Restart, until_quiet_without_time_means_five_mean_slipping_times) {
  output_of("load --config small.ini -o a.h5");
  const std::string out =
      output_of("restart a.h5 -o b.h5 --set driving.V=0 --set junctions.t_R=2e-4 --until-quiet");
  EXPECT_NE(out.find("t = 0.001 s (no junction broke any more), 5000 steps"), std::string::npos)
      << out;
}

TEST_F(Restart, until_quiet_stops_when_an_event_has_spanned) {
  output_of("load --config small.ini -o a.h5 --until 1e-4");
  const std::string out = output_of("restart a.h5 -o b.h5 --until-quiet");
  EXPECT_NE(out.find("(an event spanned the interface)"), std::string::npos) << out;
  const double end = json_of("analyze stress b.h5 --json")["time"];
  EXPECT_NEAR(end, 2.6e-4, 1e-12);  // the edge ruptures at 2.53e-4 s; looked at every 100 steps
}

TEST_F(Restart, until_quiet_waits_for_the_pinned_fraction_that_was_asked_for) {
  output_of("prepare --tau-bar 0.21 --sigma-bar 0.285 -o a.h5");  // not all break at once
  const std::string command = "restart a.h5 -f -o b.h5 --record r.h5 --crossings 0.2 --until-quiet";
  const auto arrival = [&] {
    return json_of("analyze front r.h5 --json --ruptured-below 0.2")["t_rupture"].back();
  };
  const double end = json_of(command + " --json -q")["time"];
  EXPECT_TRUE(arrival().is_null());
  const Json later = json_of(command + " --arrived-below 0.2 --json -q");
  EXPECT_EQ(later["ending"], "spanned");
  EXPECT_GT(double{arrival()}, end);
  EXPECT_LE(later["time"], double{arrival()} + 2e-5);
}

TEST_F(Restart, arrived_below_needs_a_fraction_at_which_blocks_have_ruptured) {
  output_of("load --config small.ini -o a.h5 --until 1e-4");
  const std::string command = "restart a.h5 -o b.h5 --arrived-below ";
  expect_refusal(command + "0.2 --for 1e-4", kUsage,
                 "--arrived-below says when --until-quiet ends a run: give both");
  expect_refusal(
      command + "0.4 --until-quiet", kUsage,
      "--arrived-below 0.4 makes no sense: a block ruptures at 0.3, so give at most that");
  expect_refusal(command + "0 --until-quiet", kUsage,
                 "--arrived-below 0 makes no sense: a pinned fraction is above 0 and at most 1");
}

TEST_F(Restart, until_quiet_ends_a_split_run_where_it_ends_the_whole) {
  output_of("load --config small.ini -o a.h5 --until 1e-4");
  output_of("restart a.h5 -o whole.h5 --until-quiet");
  output_of("restart a.h5 -o half.h5 --until 1.77e-4");
  output_of("restart half.h5 -o end.h5 --until-quiet");
  EXPECT_EQ(checksum_of("end.h5"), checksum_of("whole.h5"));
}

TEST_F(Restart, changed_junction_law_changes_the_rest_of_the_run) {
  output_of("load --config small.ini -o a.h5 --until 2e-4");
  output_of("restart a.h5 -o same.h5 --for 5e-3");
  output_of("restart a.h5 -o off.h5 --for 5e-3 --set junctions.f_new=f_slip");
  output_of("restart a.h5 -o long.h5 --for 5e-3 --set junctions.t_R=8e-3");
  EXPECT_NE(checksum_of("off.h5"), checksum_of("same.h5"));
  EXPECT_NE(checksum_of("long.h5"), checksum_of("same.h5"));
  EXPECT_EQ(json_of("analyze show off.h5 --json")["parameters"]["junctions.f_new"], "f_slip");
}

TEST_F(Restart, takes_parameters_from_a_configuration_too) {
  output_of("load --config small.ini -o a.h5 --until 5e-5");
  write("stop.ini", "[driving]\nV = 0\n");
  output_of("restart a.h5 --config stop.ini -o b.h5 --for 1e-4");
  output_of("restart a.h5 --set driving.V=0 -o c.h5 --for 1e-4");
  EXPECT_EQ(checksum_of("b.h5"), checksum_of("c.h5"));
}

TEST_F(Restart, no_time_means_a_copy) {
  output_of("load --config small.ini -o a.h5 --until 1e-4");
  output_of("restart a.h5 -o b.h5 --for 0");
  EXPECT_EQ(checksum_of("a.h5"), checksum_of("b.h5"));
}

}  // namespace
}  // namespace rupture::testing
