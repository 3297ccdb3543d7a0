// restart: continuing a run gives what the uninterrupted one gave; changing parameters does not.
#include <cmath>

#include "rupture/checkpoint/file.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

using Restart = ToolTest;

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

TEST_F(Restart, driving_force_stays_constant_at_rest) {
  output_of("load --config small.ini --set driving.V=0.05 -o a.h5 --until 5e-4");
  output_of("restart a.h5 -o rest.h5 --set driving.V=0 --for 2e-2");
  output_of("restart rest.h5 -o b.h5 --for 1e-3 --record r.h5");
  const std::vector<double> F_T = json_of("analyze loading r.h5 --json")["F_T"];
  ASSERT_GT(F_T.front(), 10.0);
  for (const double force : F_T) EXPECT_NEAR(force, F_T.front(), 1e-9 * F_T.front());
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

}  // namespace
}  // namespace rupture::testing
