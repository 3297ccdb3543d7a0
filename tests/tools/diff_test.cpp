// analyze diff: where and by how much two files differ.
#include <fmt/format.h>

#include <utility>

#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/dynamics/simulation.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

class Diff : public ToolTest {
 protected:
  Diff() { output_of("load --config small.ini -o a.h5 --until 1e-4 --record r.h5 -q"); }

  /// Writes b.h5, which differs from a.h5 in three values of u_x, [2][1], [2][3] and [4][0], in
  /// one count, and in a choice.
  void write_other() const {
    Checkpoint other = read_checkpoint(path("a.h5"));
    other.state.u_x(1, 2) = -0.5;
    other.state.u_x(3, 2) *= 2.0;
    other.state.u_x(0, 4) *= -1.0;
    other.state.junctions.draws(7, 99) = 6;
    other.parameters.slipping_times = SlippingTimes::exponential;
    other.state = continued(std::move(other.state), other.parameters);
    write_checkpoint(path("b.h5"), other, IfExists::refuse);
  }
};

TEST_F(Diff, tells_equal_from_different) {
  EXPECT_EQ(output_of("analyze diff a.h5 a.h5"), "equal\n");
  EXPECT_EQ(json_of("analyze diff a.h5 a.h5 --json")["equal"], true);
  output_of(
      "load --set slider.Nx=9 --set slider.Nz=5 --set slider.H=0.07 --set driving.h=0.0175 "
      "--set driving.V=1 --output other.h5 --until 1e-4");
  EXPECT_EQ(output_of("analyze diff other.h5 a.h5"), "equal\n");
  expect_refusal("analyze diff a.h5", kUsage, "1 files were given: name the two to compare");
}

TEST_F(Diff, says_where_and_by_how_much) {
  write_other();
  const Checkpoint a = read_checkpoint(path("a.h5"));
  const double first = a.state.u_x(1, 2);
  const Outcome outcome = run("analyze diff a.h5 b.h5");
  EXPECT_EQ(outcome.exit_code, kFailed);
  EXPECT_EQ(outcome.err, "");
  const auto lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 9U) << outcome.out;
  EXPECT_EQ(lines[0], "/parameters/junctions/slipping_times: 'gaussian' and 'exponential'");
  EXPECT_EQ(lines[1], "/state/junctions/draws: 1 of 900 differ, the first at [7][99]: 0 and 6");
  EXPECT_EQ(lines[2], "    largest absolute difference 6.000e+00 at [7][99]: 0 and 6");
  EXPECT_EQ(lines[3], "    largest relative difference 1.000e+00 at [7][99]: 0 and 6");
  EXPECT_EQ(lines[4],
            fmt::format("/state/u_x: 3 of 45 differ, the first at [2][1]: {} and -0.5", first));
  EXPECT_EQ(lines[5], fmt::format("    largest absolute difference {:.3e} at [2][1]: {} and -0.5",
                                  0.5 + first, first));
  EXPECT_TRUE(lines[6].starts_with("    largest relative difference 2.000e+00 at [4][0]: "))
      << lines[6];
  EXPECT_TRUE(lines[7].starts_with("    largest difference ")) << lines[7];
  EXPECT_NE(lines[7].find(" ULP at [4][0]: "), std::string::npos) << lines[7];
  EXPECT_EQ(lines[8], "3 of 40 datasets differ");
}

TEST_F(Diff, says_the_same_as_json) {
  write_other();
  const Json json = Json::parse(run("analyze diff a.h5 b.h5 --json").out);
  EXPECT_EQ(json["equal"], false);
  EXPECT_EQ(json["datasets"], 40);
  ASSERT_EQ(json["differences"].size(), 3U);
  EXPECT_EQ(json["differences"][0]["b"], "exponential");
  EXPECT_FALSE(json["differences"][1].contains("ulp"));
  const Json& u_x = json["differences"][2];
  EXPECT_EQ(u_x["path"], "/state/u_x");
  EXPECT_EQ(u_x["change"], "values");
  EXPECT_EQ(u_x["count"], 3);
  EXPECT_EQ(u_x["first"]["index"], Json({2, 1}));
  EXPECT_EQ(u_x["first"]["a"], read_checkpoint(path("a.h5")).state.u_x(1, 2));
  EXPECT_EQ(u_x["absolute"]["index"], Json({2, 1}));
  EXPECT_EQ(u_x["absolute"]["b"], -0.5);
  EXPECT_EQ(u_x["ulp"]["index"], Json({4, 0}));
  EXPECT_GT(u_x["ulp"]["largest"], std::uint64_t{1} << 62U);
}

TEST_F(Diff, puts_a_scalar_in_one_line) {
  output_of("load --config small.ini -o b.h5 --until 1e-4 --set driving.K=2e6 -q");
  EXPECT_EQ(lines_of(run("analyze diff a.h5 b.h5").out).front(),
            "/parameters/driving/K: 4000000 and 2000000, 2.000e+06 absolute, 5.000e-01 relative, "
            "4503599627370496 ULP");
}

TEST_F(Diff, names_datasets_of_one_file_alone) {
  const std::string text = run("analyze diff a.h5 r.h5").out;
  EXPECT_NE(text.find("/state/u_x: only in the first file\n"), std::string::npos) << text;
  EXPECT_NE(text.find("/series/u_x: only in the second file\n"), std::string::npos) << text;
  const Json json = Json::parse(run("analyze diff a.h5 r.h5 --json").out);
  EXPECT_EQ(json["differences"][0]["change"], "only_in_b");
}

TEST_F(Diff, compares_the_common_rows_of_records) {
  output_of("load --config small.ini -o long.h5 --until 2e-4 --record long-r.h5 -q");
  const Outcome shapes = run("analyze diff r.h5 long-r.h5");
  EXPECT_EQ(shapes.exit_code, kFailed);
  EXPECT_NE(shapes.out.find("/series/p: shapes differ: [2][9] and [3][9]\n"), std::string::npos)
      << shapes.out;
  const Json json = Json::parse(run("analyze diff r.h5 long-r.h5 --json").out);
  EXPECT_EQ(json["differences"].back()["b"]["shape"], Json({3}));
  EXPECT_TRUE(output_of("analyze diff r.h5 long-r.h5 --common").ends_with("equal\n"));
  EXPECT_EQ(output_of("analyze diff a.h5 a.h5 --common"), "equal\n");
}

}  // namespace
}  // namespace rupture::testing
