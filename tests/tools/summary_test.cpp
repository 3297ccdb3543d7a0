// --json of the programs that write files: what was done, as one object.
#include <set>

#include "tool_test.hpp"

namespace rupture::testing {
namespace {

class Summary : public ToolTest {
 protected:
  /// The object that a command prints; its text goes to standard error.
  Json summary_of(const std::string& command, int code = kDone) const {
    const Outcome outcome = run(command + " --json");
    EXPECT_EQ(outcome.exit_code, code) << outcome.err;
    EXPECT_EQ(lines_of(outcome.out).size(), 1U);
    EXPECT_NE(outcome.err.find("wrote "), std::string::npos) << outcome.err;
    return Json::parse(outcome.out);
  }

  Json file(const std::string& path, const std::string& holds = "checkpoint") const {
    return {{"path", path}, {"holds", holds}, {"checksum", checksum_of(path)}};
  }
};

const std::string kLoad = "load --config small.ini -o a.h5 --until 4e-4";

TEST_F(Summary, of_a_run_that_was_complete_or_resumed) {
  const std::string load = kLoad + " --checkpoint-at 1e-4 --record r.h5 --resume --json";
  const Json whole = json_of(load + " --quiet");
  EXPECT_EQ(whole["files"],
            Json::array({file("a-t0.000100000.h5"), file("a.h5"), file("r.h5", "record")}));
  Json again = json_of(load + " --quiet");
  EXPECT_EQ(again["ending"], "complete");
  EXPECT_EQ(again["steps"], 0);
  EXPECT_EQ(again["files"], Json::array());
  for (const char* key : {"time", "ruptures", "leading_edge_ruptured"}) {
    EXPECT_EQ(again[key], whole[key]) << key;
  }
  fs::remove(path("a.h5"));
  again = json_of(load + " --quiet");
  EXPECT_EQ(again["ending"], "end");
  EXPECT_EQ(again["steps"], 1500);
  for (const char* key : {"time", "ruptures", "leading_edge_ruptured"}) {
    EXPECT_EQ(again[key], whole[key]) << key;
  }
}

TEST_F(Summary, of_modify_phi) {
  output_of("prepare --tau-bar 0.2 --sigma-bar 0.1 --no-trigger -o a.h5");
  const Json json = summary_of("modify-phi a.h5 -o b.h5 --sigma-bar 0.3 --x-to 20mm");
  const Json before = json_of("analyze phi a.h5 --json"),
             after = json_of("analyze phi b.h5 --json");
  EXPECT_EQ(json["x"], before["x"]);
  EXPECT_EQ(json["slipping"], before["slipping"]);
  EXPECT_EQ(json["sigma_bar_before"], before["sigma_bar"]);
  EXPECT_EQ(json["sigma_bar_after"], after["sigma_bar"]);
  EXPECT_EQ(json["changed"], 9);
  EXPECT_LT(json["largest_change"], 1e-9);
  EXPECT_EQ(json["impossible"], Json::array());
  EXPECT_EQ(json["files"], Json::array({file("b.h5")}));
}

/// Names as in `analyze quantities`: keys joined by dots, * for an index.
std::set<std::string> names_in(const Json& json, const std::string& prefix) {
  if (json.is_object()) {
    std::set<std::string> names;
    for (const auto& [key, value] : json.items()) names.merge(names_in(value, prefix + "." + key));
    return names;
  }
  if (json.is_array()) return names_in(json.at(0), prefix + ".*");
  return {prefix};
}

TEST_F(Summary, has_the_fields_that_analyze_quantities_lists) {
  std::map<std::string, std::set<std::string>> listed;
  const Json all = json_of("analyze quantities --json");
  for (const Json& quantity : all["summaries"]) {
    const std::string name = quantity["name"];
    listed[name.substr(0, name.find('.'))].insert(name);
  }
  EXPECT_EQ(names_in(summary_of(kLoad), "load"), listed["load"]);
  EXPECT_EQ(names_in(summary_of("restart a.h5 -o b.h5 --for 1e-5"), "restart"), listed["restart"]);
  const std::string prepare = "prepare --tau-bar 0.2 --tau-bar-trigger 0.9 --no-trigger -o c.h5";
  EXPECT_EQ(names_in(summary_of(prepare), "prepare"), listed["prepare"]);
  EXPECT_EQ(names_in(summary_of("modify-phi c.h5 -o d.h5 --sigma-bar 0.2"), "modify-phi"),
            listed["modify-phi"]);
}

TEST_F(Summary, changes_no_file_but_the_command_line) {
  output_of(kLoad + " --record r.h5 --quiet");
  const std::string checkpoint = checksum_of("a.h5"), record = checksum_of("r.h5");
  json_of(kLoad + " --record r.h5 --force --quiet --json");
  EXPECT_EQ(checksum_of("a.h5"), checkpoint);
  EXPECT_EQ(checksum_of("r.h5"), record);
}

TEST_F(Summary, that_cannot_be_printed_is_said) {
  const Outcome outcome = run(kLoad + " --json --quiet", {.standard_output = "/dev/full"});
  EXPECT_EQ(outcome.exit_code, kFailed);
  EXPECT_EQ(outcome.err, "load: cannot write to standard output\n");
  output_of("analyze verify a.h5");
}

}  // namespace
}  // namespace rupture::testing
