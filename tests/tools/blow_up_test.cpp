// Runs that cannot be followed: what they say, and what they keep.
#include "rupture/checkpoint/checkpoint.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

class BlowUp : public ToolTest {
 protected:
  /// wild.h5: one block moves at 1e200 m/s.
  BlowUp() {
    output_of("load --config small.ini -o good.h5 --until 2e-4 -q");
    Checkpoint checkpoint = read_checkpoint(path("good.h5"));
    checkpoint.state.v_x(3, 2) = 1e200;
    write_checkpoint(path("wild.h5"), checkpoint, IfExists::refuse);
  }
};

TEST_F(BlowUp, stops_the_run) {
  expect_refusal_with("restart wild.h5 -o out.h5 --for 1e-4", kFailed,
                      "numerical blow-up at t = 0.000200");
  expect_refusal_with("restart wild.h5 -o out.h5 --for 1e-4", kFailed, "in block (");
}

TEST_F(BlowUp, keeps_the_last_checkpoint) {
  const Outcome outcome =
      run("restart wild.h5 -o out.h5 --for 1e-4 --checkpoint-at 2e-4 --record r.h5");
  EXPECT_EQ(outcome.exit_code, kFailed);
  expect_one_sentence(outcome.err, "restart", "numerical blow-up at t = 0.000200");
  EXPECT_FALSE(fs::exists(path("out.h5")));
  EXPECT_FALSE(fs::exists(path("r.h5")));
  EXPECT_EQ(checksum_of("out-t0.000200000.h5"), checksum_of("wild.h5"));
  expect_refusal("analyze verify r.h5.part", kFailed,
                 "r.h5.part: an unfinished record cannot be verified: its run has not ended");
}

TEST_F(BlowUp, loses_no_sample) {
  EXPECT_EQ(run("restart wild.h5 -o out.h5 --for 1e-4 --record r.h5").exit_code, kFailed);
  EXPECT_EQ(json_of("analyze loading r.h5.part --json")["time"].size(), 1U);
}

}  // namespace
}  // namespace rupture::testing
