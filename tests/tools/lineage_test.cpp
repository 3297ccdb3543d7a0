// analyze lineage: scripts for odd names, changed chains, other schemas; see tables/lineage.txt.
#include "rupture/checkpoint/checkpoint.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

class Lineage : public ToolTest {
 protected:
  /// Lets a file say that its steps were others.
  void change_chain(const std::string& file,
                    const std::function<void(std::vector<ProvenanceEntry>&)>& change) const {
    Checkpoint checkpoint = read_checkpoint(path(file));
    change(checkpoint.provenance);
    write_checkpoint(path(file), checkpoint, IfExists::replace);
  }

  std::vector<std::string> rebuilds_of(const std::string& file) const {
    std::vector<std::string> commands;
    for (const auto& entry : read_checkpoint(path(file)).provenance) {
      commands.push_back(entry.rebuild);
    }
    return commands;
  }
};

TEST_F(Lineage, of_a_resumed_run) {
  const std::string command =
      "load --config small.ini -o a.h5 --until 2e-4 --checkpoint-every 1e-4 --record r.h5";
  output_of(command);
  const std::string whole = checksum_of("a.h5"), whole_record = checksum_of("r.h5");
  for (const char* file : {"a.h5", "a-t0.000200000.h5"}) fs::remove(path(file));
  output_of(command + " --resume");
  EXPECT_EQ(rebuilds_of("a.h5").back(), "restart --until 0.0002");
  EXPECT_EQ(checksum_of("a.h5"), whole);
  EXPECT_EQ(checksum_of("r.h5"), whole_record);
  expect_rebuilt("a.h5");
  expect_rebuilt("r.h5");
}

TEST_F(Lineage, takes_paths_with_spaces_and_quotes) {
  fs::create_directory(path("it's a folder"));
  const std::string start = "it's a folder/$HOME.h5", end = "\"end\" of 'it'\n.h5";
  run_words({"load", "--config", "small.ini", "-o", start, "--until", "1e-4"});
  run_words({"restart", start, "-o", end, "--for", "1e-5"});
  expect_rebuilt(end);
  const std::string script = script_for(end, {"--from", path(start), "-o", "a 'new' $name.h5"});
  const Outcome outcome = run_script(script);
  EXPECT_EQ(outcome.exit_code, kDone) << outcome.err;
  EXPECT_EQ(checksum_in("again/a 'new' $name.h5"), checksum_in(end)) << script;
}

TEST_F(Lineage, takes_paths_that_are_no_utf8) {
  run_words({"load", "--config", "small.ini", "-o", "\xff.h5"});
  expect_rebuilt("\xff.h5");
  for (const char* command : {"lineage", "show"}) {
    const Outcome outcome = run_words({"analyze", command, "\xff.h5", "--json"});
    EXPECT_EQ(outcome.exit_code, kDone) << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out)["checksum"].dump(),
              '"' + checksum_in("\xff.h5").substr(0, 64) + '"');
  }
}

TEST_F(Lineage, script_checks_every_file) {
  output_of("load --config small.ini -o a.h5 --until 1e-4");
  output_of("restart a.h5 -o b.h5 --for 1e-5");
  const std::string good = script_for("b.h5");
  for (const std::string& file : {std::string("step-0000.h5"), std::string("rebuilt.h5")}) {
    std::string bad = good;
    const std::size_t at = bad.find("check " + file + " ") + 7 + file.size();
    bad[at] = bad[at] == '0' ? '1' : '0';
    const Outcome outcome = run_script(bad);
    EXPECT_EQ(outcome.exit_code, kFailed);
    EXPECT_NE(outcome.err.find(file + " has another content checksum than"), std::string::npos)
        << outcome.err;
  }
}

// Under the first law the parameter does not count, so that a parent without it would do as well.
TEST_F(Lineage, names_parameters_where_the_law_uses_them) {
  output_of("load --config small.ini -o a.h5 --set junctions.mu_new=0.05");
  output_of("load --config small.ini -o plain.h5");
  ASSERT_EQ(checksum_of("a.h5"), checksum_of("plain.h5"));
  output_of("restart a.h5 -o b.h5 --for 1e-4 --set junctions.law=decaying");
  const auto commands = rebuilds_of("b.h5");
  EXPECT_EQ(commands[0].find("mu_new"), std::string::npos) << commands[0];
  EXPECT_NE(commands[1].find("--set junctions.mu_new=0.05"), std::string::npos) << commands[1];
  expect_rebuilt("b.h5");
}

TEST_F(Lineage, checks_steps_by_sums_of_schema_2) {
  output_of("load --config small.ini -o a.h5 --set junctions.law=simplified");
  output_of("restart a.h5 -o b.h5 --for 1e-5");
  change_chain("b.h5", [](auto& chain) {
    chain[0].rebuild += " --set junctions.mu_new=0.05";  // as builds of schema 2 said it
  });
  output_of(
      "load --config small.ini -o odd.h5 --set junctions.law=simplified --set "
      "junctions.mu_new=0.05");
  const std::string early = run_words({"analyze", "checksum", "--as-schema-2", "odd.h5"}).out;
  ASSERT_NE(early.substr(0, 64), checksum_of("odd.h5"));
  change_chain("b.h5", [&](auto& chain) { chain[1].parent_checksum = early.substr(0, 64); });
  expect_rebuilt("b.h5");
}

TEST_F(Lineage, shows_one_line_per_step) {
  output_of("load --config small.ini -o a.h5 --until 1e-4");
  output_of("restart a.h5 -o b.h5 --for 1e-5");
  const auto lines = lines_of(output_of("analyze lineage b.h5"));
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_TRUE(lines[0].starts_with("0 " + checksum_of("a.h5").substr(0, 12) + "  rupture "));
  EXPECT_TRUE(lines[1].starts_with("1 " + checksum_of("b.h5").substr(0, 12) + "  rupture "));
  EXPECT_TRUE(lines[1].ends_with(": restart --until 0.00011")) << lines[1];
  const Json json = json_of("analyze lineage b.h5 --json");
  EXPECT_EQ(json["kind"], "a checkpoint");
  EXPECT_EQ(json["checksum"], checksum_of("b.h5"));
  ASSERT_EQ(json["steps"].size(), 2U);
  EXPECT_EQ(json["steps"][0]["checksum"], json["steps"][1]["parent_checksum"]);
  EXPECT_EQ(json["steps"][1]["checksum"], json["checksum"]);
  for (const char* field : {"tool", "version", "commit", "command_line", "compiler", "rebuild"}) {
    EXPECT_NE(json["steps"][1][field], "") << field;
  }
}

TEST_F(Lineage, of_files_of_schema_1_starts_from_the_last_of_them) {
  output_of("load --config small.ini -o old.h5 --until 1e-4");
  change_chain("old.h5", [](auto& chain) { chain[0].rebuild = ""; });
  output_of("restart old.h5 -o new.h5 --for 1e-5");
  EXPECT_NE(output_of("analyze lineage new.h5").find("(as typed) "), std::string::npos);
  expect_refusal("analyze lineage new.h5 --commands", kFailed,
                 "new.h5: step 0 (load) has no command, because it was taken by a build with files "
                 "of schema version 1: give the file it wrote, with content checksum " +
                     checksum_of("old.h5") + ", as --from FILE");
  expect_refusal("analyze lineage old.h5 --commands", kFailed,
                 "old.h5: step 0 (load) has no command, because it was taken by a build with files "
                 "of schema version 1; analyze show prints what was typed");
  const Outcome outcome = run_script(script_for("new.h5", {"--from", path("old.h5")}));
  EXPECT_EQ(outcome.exit_code, kDone) << outcome.err;
  EXPECT_EQ(checksum_in("again/rebuilt.h5"), checksum_in("new.h5"));
}

TEST_F(Lineage, refuses_a_chain_without_beginning) {
  output_of("load --config small.ini -o a.h5");
  change_chain("a.h5", [](auto& chain) { chain[0].parent_checksum = "abc"; });
  expect_refusal("analyze lineage a.h5 --commands", kFailed,
                 "a.h5: its first step started from a file of which only the content checksum is "
                 "known, abc: give that file as --from FILE");
  change_chain("a.h5", [](auto& chain) { chain.clear(); });
  expect_refusal("analyze lineage a.h5 --commands", kFailed,
                 "a.h5 does not say which steps led to it");
}

TEST_F(Lineage, prints_no_control_characters) {
  output_of("load --config small.ini -o a.h5");
  const std::size_t lines = lines_of(output_of("analyze show a.h5")).size();
  const std::string wild = "\x1b[2J\n\xc2\x9bX";
  change_chain("a.h5", [&](auto& chain) { chain[0] = {wild, wild, wild, wild, wild, "", wild}; });
  EXPECT_EQ(lines_of(output_of("analyze show a.h5")).size(), lines);
  for (const char* command : {"analyze show a.h5", "analyze lineage a.h5"}) {
    EXPECT_EQ(output_of(command).find_first_of("\x1b\x9b"), std::string::npos) << command;
  }
}

TEST_F(Lineage, refuses_to_print_commands_of_others) {
  output_of("load --config small.ini -o a.h5");
  for (const std::string command : {"load; rm x", "rm -r x", "load\nrm x", "load $(rm x)"}) {
    change_chain("a.h5", [&](auto& chain) { chain[0].rebuild = command; });
    expect_refusal_with("analyze lineage a.h5 --commands", kFailed,
                        "a.h5: step 0 is no command of rupture and will not be run: ");
  }
  change_chain("a.h5", [&](auto& chain) {
    chain[0].rebuild = "load --until 0";
    chain[0].command_line = chain[0].version = chain[0].compiler = "x\nexit 7";
  });
  EXPECT_EQ(script_for("a.h5").find("\nexit 7"), std::string::npos);
}

TEST_F(Lineage, refuses_a_start_that_is_no_ancestor) {
  output_of("load --config small.ini -o a.h5");
  expect_refusal("analyze lineage a.h5 --commands --from a.h5", kFailed,
                 "no step to a.h5 started from a.h5, whose content checksum is " +
                     checksum_of("a.h5") + "; see analyze lineage a.h5");
}

TEST_F(Lineage, of_an_unfinished_record_has_no_commands) {
  output_of("load --config small.ini -o a.h5 --until 2e-4");
  Checkpoint wild = read_checkpoint(path("a.h5"));
  wild.state.v_x(3, 2) = 1e200;
  write_checkpoint(path("wild.h5"), wild, IfExists::refuse);
  EXPECT_EQ(run("restart wild.h5 -o b.h5 --for 1e-4 --record r.h5").exit_code, kFailed);
  EXPECT_EQ(lines_of(output_of("analyze lineage r.h5.part")).size(), 2U);
  expect_refusal("analyze lineage r.h5.part --commands", kFailed,
                 "r.h5.part is an unfinished record, which has no checksum to reach");
}

}  // namespace
}  // namespace rupture::testing
