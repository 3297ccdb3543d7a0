// finish: the record of a run that was killed or still runs, as an ordinary record.
#include "rupture/checkpoint/record.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

// A disk that becomes full behind the first flush, of 256 samples.
RunOptions full_disk() {
  RunOptions options;
  options.largest_file = 130000;
  return options;
}

class Finish : public ToolTest {
 protected:
  /// Leaves r.h5.part of a run that was to end at 4e-4 s.
  void interrupt(const std::string& options) const {
    const std::string load = "load --config small.ini -o a.h5 -f --until 4e-4 --record r.h5 ";
    EXPECT_EQ(run(load + options, full_disk()).exit_code, kFailed);
  }
};

TEST_F(Finish, gives_the_record_of_a_run_that_was_to_end_there) {
  for (const char* options :
       {"--record-every 6e-7", "--record-every 8e-7", "--record-every 1e-6 --crossings 0.5"}) {
    interrupt(options);
    const std::string said = output_of("finish r.h5.part -o part.h5 -f --sum");
    EXPECT_EQ(said.find("256 samples up to t = 0.000"), 0U) << said;
    EXPECT_EQ(read("part.h5.sum"), sum_line("part.h5"));
    const Json show = json_of("analyze show part.h5 --json");
    const std::string again = show.at("provenance").back().at("rebuild");
    output_of(again + " --config small.ini -o b.h5 --record whole.h5 -f");
    EXPECT_EQ(checksum_of("part.h5"), checksum_of("whole.h5")) << again;
    EXPECT_EQ(json_of("analyze lineage whole.h5 --json").at("steps").back().at("rebuild"), again);
    EXPECT_GT(read_record(path("part.h5")).ruptures.size(), 0U);
  }
}

TEST_F(Finish, says_what_it_did_as_JSON) {
  interrupt("--record-every 1e-6");
  const Outcome outcome = run("finish r.h5.part -o new.h5 --json");
  EXPECT_EQ(outcome.err.find("256 samples up to t = 0.000255 s\n"), 0U) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["samples"], 256);
  EXPECT_DOUBLE_EQ(json["time"], 255e-6);
  const Json file = {{"path", "new.h5"}, {"holds", "record"}, {"checksum", checksum_of("new.h5")}};
  EXPECT_EQ(json["files"], Json::array({file}));
}

TEST_F(Finish, says_how_much_at_the_end_it_ignored) {
  interrupt("--record-every 1e-6");
  const std::string whole = read("r.h5.part");
  EXPECT_EQ(json_of("finish r.h5.part -o a.h5 -f -q --json")["ignored_bytes"], 0);
  write("r.h5.part", whole + whole.substr(0, 777));
  const Outcome outcome = run("finish r.h5.part -o b.h5 --json");
  EXPECT_EQ(Json::parse(outcome.out)["ignored_bytes"], 777);
  EXPECT_EQ(lines_of(outcome.err).at(1),
            "ignored 777 bytes at the end, which are no complete piece: the run was killed while "
            "it wrote them, or writes them now, or they are damaged");
  EXPECT_EQ(checksum_of("b.h5"), checksum_of("a.h5"));
}

TEST_F(Finish, leaves_the_unfinished_record_to_the_run) {
  interrupt("--record-every 1e-6");
  const std::string before = read("r.h5.part");
  output_of("finish r.h5.part -o r.h5 -q");
  EXPECT_EQ(read("r.h5.part"), before);
  EXPECT_EQ(output_of("analyze verify r.h5").find("intact"), 0U);
  expect_refusal("finish r.h5.part -o r.h5", kFailed, "r.h5 exists; give --force to replace it");
}

/// A run that writes r.h5.part now.
class Running : public ToolTest {
 protected:
  explicit Running(int samples = 4) {
    for (int n = 0; n < samples; ++n) {
      const auto i = static_cast<std::size_t>(Parameters{}.Nx);
      const std::vector<double> values(i, 0.5);
      writer_.append(
          {1e-6 * n, 5 * n, 1.0, 4e-10 * n, std::vector<std::uint16_t>(i), values, values, values});
    }
  }
  RecordWriter writer_{path("r.h5"), Parameters{}, {}, IfExists::refuse, {}, 4};
};

TEST_F(Running, record_can_be_finished_under_another_name) {
  expect_refusal(
      "finish r.h5.part -o ./r.h5", kFailed,
      "a run is writing r.h5.part and will write ./r.h5 when it ends: give another output");
  EXPECT_EQ(output_of("finish r.h5.part -o now.h5").find("4 samples up to t = 3e-06 s\n"), 0U);
  const std::string checksum = checksum_of("now.h5");
  writer_.finish();
  EXPECT_EQ(checksum_of("r.h5"), checksum);
}

class JustStarted : public Running {
 protected:
  JustStarted() : Running(0) {}
};

TEST_F(JustStarted, record_has_nothing_to_finish) {
  expect_refusal("finish r.h5.part -o now.h5", kFailed,
                 "r.h5.part holds no sample yet: its run has to go on, or begin again");
}

}  // namespace
}  // namespace rupture::testing
