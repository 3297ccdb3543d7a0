// analyze estimate: the relaxation of one block; the numbers are in tables/estimate.txt.
#include <algorithm>

#include "tool_test.hpp"

namespace rupture::testing {
namespace {

class Estimate : public ToolTest {
 protected:
  Estimate() { output_of("load --config small.ini -o a.h5 -q"); }
};

TEST_F(Estimate, follows_the_slip_of_one_block) {
  const Json json = json_of("analyze estimate a.h5 --json");
  const std::vector<double> time = json["relaxation"]["time_over_t_R"];
  const std::vector<double> slip = json["relaxation"]["slip_over_f_slip_per_k_ij"];
  ASSERT_EQ(time.size(), slip.size());
  ASSERT_GT(time.size(), 100U) << "each junction is pinned once, and some again";
  EXPECT_TRUE(std::is_sorted(time.begin(), time.end()));
  EXPECT_TRUE(std::is_sorted(slip.begin(), slip.end()));
  EXPECT_EQ(slip.front(), 1.0) << "the first pinned junction alone makes up for f_slip";
  EXPECT_NEAR(slip.back(), json["net_slip_over_f_slip_per_k_ij"], 1e-12) << "equal for all seeds";
}

TEST_F(Estimate, depends_on_the_seed_and_on_nothing_else) {
  const std::string command = "analyze estimate a.h5 --json --ensemble 5";
  EXPECT_EQ(output_of(command), output_of(command));
  EXPECT_EQ(output_of(command), output_of(command + " --seed 1")) << "the checkpoint's";
  EXPECT_NE(output_of(command), output_of(command + " --seed 2"));
}

}  // namespace
}  // namespace rupture::testing
