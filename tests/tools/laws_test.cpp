// The tools under the other interface laws.
#include <numeric>

#include "tool_test.hpp"

namespace rupture::testing {
namespace {

class OtherLaw : public ToolTest, public ::testing::WithParamInterface<std::string> {
 protected:
  const std::string load_ = "load --config small.ini --set junctions.law=" + GetParam();
};

INSTANTIATE_TEST_SUITE_P(Tools, OtherLaw, ::testing::Values("simplified", "decaying", "distance"),
                         [](const auto& law) { return law.param; });

TEST_P(OtherLaw, loads_and_restarts_to_the_bits_of_one_run) {
  output_of(load_ + " -o whole.h5 --until 4e-4");
  output_of(load_ + " -o half.h5 --until 2e-4");
  output_of("restart half.h5 -o end.h5 --until 4e-4");
  EXPECT_EQ(checksum_of("end.h5"), checksum_of("whole.h5"));
  EXPECT_EQ(json_of("analyze show end.h5 --json")["parameters"]["junctions.law"], GetParam());
  output_of("load --config small.ini -o reference.h5 --until 4e-4");
  EXPECT_NE(checksum_of("reference.h5"), checksum_of("whole.h5"));
}

TEST_P(OtherLaw, records_the_rupture_of_every_block) {
  output_of(load_ + " -o a.h5 --until 4e-4 --record r.h5");
  const Json front = json_of("analyze front r.h5 --json");
  for (const Json& t : front["t_rupture"]) EXPECT_FALSE(t.is_null());
}

TEST_P(OtherLaw, tells_the_stress_that_the_run_had) {
  output_of(load_ + " -o a.h5 --until 2e-4 --record r.h5");
  const std::vector<double> tau = json_of("analyze stress a.h5 --json")["tau"];
  const Json loading = json_of("analyze loading r.h5 --x 0.07 --json");
  const double recorded = loading["tau"].back();
  EXPECT_NEAR(tau[4], recorded, 1e-9 * std::abs(recorded));
}

TEST_F(ToolTest, slow_slip_off_is_refused_with_the_right_word) {
  output_of("load --config small.ini -o a.h5 --set junctions.law=simplified");
  expect_refusal(
      "restart a.h5 -o b.h5 --for 1e-5 --set junctions.f_new=f_slip", kUsage,
      "junctions.f_new = f_slip belongs to the reference and the distance law: to switch "
      "slow slip off under the simplified law, set junctions.v_slow to 0");
  output_of("restart a.h5 -o b.h5 --for 1e-5 --set junctions.v_slow=0");
}

TEST_F(ToolTest, many_junctions_can_change_their_law_and_single_springs_cannot) {
  output_of("load --config small.ini -o a.h5 --until 2e-4");
  output_of("restart a.h5 -o b.h5 --for 1e-5 --set junctions.law=decaying");
  EXPECT_EQ(json_of("analyze show b.h5 --json")["parameters"]["junctions.law"], "decaying");
  output_of("restart a.h5 -o distance.h5 --for 1e-5 --set junctions.law=distance");
  output_of("restart distance.h5 -o back.h5 --for 1e-5 --set junctions.law=reference");
  expect_refusal("restart a.h5 -o c.h5 --for 1e-5 --set junctions.law=simplified", kUsage,
                 "junctions.law cannot change from reference to simplified in a restart: the "
                 "simplified law has one spring per block; start with load --set "
                 "junctions.law=simplified");
  output_of("load --config small.ini -o d.h5 --set junctions.law=simplified");
  expect_refusal_with("restart d.h5 -o c.h5 --for 1e-5 --set junctions.law=reference", kUsage,
                      "junctions.law cannot change from simplified to reference");
}

TEST_F(ToolTest, parameters_of_other_laws_make_no_other_content) {
  output_of("load --config small.ini -o a.h5 --set junctions.law=simplified");
  output_of(
      "load --config small.ini -o b.h5 --set junctions.law=simplified --set "
      "junctions.delta_t_R=1e-4 --set junctions.mu_new=0.05");
  EXPECT_EQ(checksum_of("a.h5"), checksum_of("b.h5"));
  EXPECT_EQ(output_of("analyze diff a.h5 b.h5"), "equal\n");
  EXPECT_EQ(json_of("analyze show b.h5 --json")["parameters"]["junctions.mu_new"], 0.05);
  EXPECT_NE(output_of("analyze checksum --as-schema-2 a.h5"),
            output_of("analyze checksum --as-schema-2 b.h5"));
}

TEST_F(ToolTest, single_springs_have_no_phi) {
  output_of("load --config small.ini -o a.h5 --set junctions.law=simplified");
  const std::string sentence =
      "the checkpoint has junctions.law = simplified: a single spring per block has no "
      "distribution of forces; use a checkpoint of the reference or the decaying or the distance "
      "law";
  expect_refusal("modify-phi a.h5 -o b.h5", kFailed, sentence);
  expect_refusal_with("analyze phi a.h5", kFailed, sentence);
}

TEST_F(ToolTest, decaying_junctions_have_phi) {
  output_of("load --config small.ini -o a.h5 --until 2e-4 --set junctions.law=decaying");
  output_of("modify-phi a.h5 -o b.h5 --slipping pin --sigma-bar 0.1");
  output_of("restart b.h5 -o c.h5 --for 1e-4");
}

}  // namespace
}  // namespace rupture::testing
