// analyze: what two commands say of the same files agrees; the rest is in tables/analyze.txt.
#include "rupture/model/parameters.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

using Analyze = ToolTest;

TEST_F(Analyze, front_goes_by_the_conventions_given) {
  output_of("prepare --config small.ini --set driving.V=0 --tau-bar 0.6 --sigma-bar 0.2 -o p.h5");
  output_of("restart p.h5 -o q.h5 --until 1e-4 --record q-r.h5 --crossings 0.2,0.7");
  double before = 0.0;
  for (const std::string level : {"0.7", "0.3", "0.2"}) {
    const std::string with = " q-r.h5 --json --ruptured-below " + level;
    const Json event = json_of("analyze events" + with)["events"][0];
    EXPECT_EQ(event["t_start"], json_of("analyze front" + with)["t_rupture"][2]);
    EXPECT_GT(event["t_start"], before);
    before = event["t_start"];
  }
}

TEST_F(Analyze, measures_in_several_ways_by_one_call) {
  output_of("prepare --config small.ini --set driving.V=0 --tau-bar 0.6 --sigma-bar 0.2 -o p.h5");
  output_of("restart p.h5 -o q.h5 --until 1e-4 --record q-r.h5 --crossings 0.2,0.7");
  for (const std::string command : {"events", "front"}) {
    for (const std::string form : {" --json", " --csv", ""}) {
      const std::string measure = "analyze " + command + " q-r.h5 --skip-below-x 0.03" + form;
      EXPECT_EQ(
          output_of(measure + " --ruptured-below 0.7 --also=--stencil=3;--ruptured-below=0.3"),
          output_of(measure + " --ruptured-below 0.7") +
              output_of(measure + " --ruptured-below 0.7 --stencil 3") + output_of(measure));
    }
  }
}

TEST_F(Analyze, shows_every_parameter) {
  output_of("load --config small.ini -o a.h5");
  const Json json = json_of("analyze show a.h5 --json");
  EXPECT_EQ(json["checksum"], checksum_of("a.h5"));
  EXPECT_EQ(json["parameters"].size(), parameter_table().size());
  EXPECT_TRUE(json["parameters"]["driving.V"].is_number_float());
  EXPECT_TRUE(json["parameters"]["slider.Nx"].is_number_integer());
}

class EachLaw : public ToolTest, public ::testing::WithParamInterface<std::string> {};

INSTANTIATE_TEST_SUITE_P(Tools, EachLaw,
                         ::testing::Values("reference", "simplified", "decaying", "distance"),
                         [](const auto& law) { return law.param; });

TEST_P(EachLaw, has_the_stress_and_the_ruptures_that_were_recorded) {
  output_of(
      "load --config small.ini -o a.h5 --until 4e-4 --checkpoint-at 2e-4 --record r.h5 --set "
      "junctions.law=" +
      GetParam());
  const Json front = json_of("analyze front r.h5 --json");
  for (const Json& t : front["t_rupture"]) EXPECT_FALSE(t.is_null());
  const Json loading = json_of("analyze loading r.h5 --x 0.07 --json");
  for (const auto& [file, n] : {std::pair{"a-t0.000200000.h5", 2U}, {"a.h5", 4U}}) {
    const Json stress = json_of(std::string("analyze stress ") + file + " --json");
    EXPECT_EQ(loading["F_T"][n], stress["F_T"]);
    EXPECT_EQ(loading["p"][n], stress["p"][4]);
    const double tau = stress["tau"][4];
    EXPECT_NEAR(loading["tau"][n], tau, 1e-9 * std::abs(tau));
  }
}

}  // namespace
}  // namespace rupture::testing
