// rupture TOOL: runs the programs, finds them, lists them, and is not in their way.
#include <csignal>

#include "tool_test.hpp"

namespace rupture::testing {
namespace {

namespace fs = std::filesystem;

class Rupture : public ToolTest {
 protected:
  /// A copy of `rupture` in PREFIX/bin, and a folder for tools.
  Rupture() {
    fs::create_directories(path("bin"));
    fs::create_directories(path("libexec/rupture"));
    fs::copy(fs::path(RUPTURE_BIN_DIR) / "rupture", path("bin/rupture"));
  }

  void add_tool(const std::string& name, const std::string& script) const {
    write("libexec/rupture/" + name, "#!/bin/sh\n" + script + "\n");
    fs::permissions(path("libexec/rupture/" + name), fs::perms::owner_all);
  }

  Outcome run_installed(const std::vector<std::string>& arguments) const {
    std::vector<std::string> words = {path("bin/rupture")};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return run_program(words, {});
  }
};

TEST_F(Rupture, runs_tools_with_their_arguments_output_and_exit_code) {
  output_of("rupture load --config small.ini -o a.h5 -q");
  EXPECT_EQ(output_of("rupture analyze checksum a.h5"), output_of("analyze checksum a.h5"));
  const Outcome refused = run("rupture load --config small.ini -o a.h5");
  EXPECT_EQ(refused.exit_code, kFailed);
  EXPECT_EQ(refused.err, "load: a.h5 exists; give --force to replace it\n");
}

TEST_F(Rupture, finds_the_tools_of_an_installed_one) {
  add_tool("load", "printf '%s|' \"$@\"; exit 7");
  const Outcome ran = run_installed({"load", "", "two words", "--help"});
  EXPECT_EQ(ran.exit_code, 7);
  EXPECT_EQ(ran.out, "|two words|--help|");
}

TEST_F(Rupture, runs_what_stands_there_and_is_no_other_process) {
  add_tool("new", "kill -TERM $$");
  EXPECT_EQ(run_installed({"new"}).exit_code, -SIGTERM);
}

TEST_F(Rupture, says_in_its_own_help_what_tools_say_of_themselves) {
  add_tool("load", R"(echo '{"name": "load", "summary": "drives"}')");
  add_tool("prepare", "echo not JSON; exit 1");
  const std::string help = run_installed({"help"}).out;
  EXPECT_NE(help.find("\n  load         drives\n"), std::string::npos) << help;
  EXPECT_NE(help.find("\n  prepare      \n"), std::string::npos) << help;
  EXPECT_NE(help.find("\n  restart      \n"), std::string::npos) << help;
}

TEST_F(Rupture, SLOW_lists_every_tool_with_a_summary) {
  const Json tools = json_of("rupture --describe").at("tools");
  const std::string help = output_of("rupture help");
  EXPECT_GE(tools.size(), 5U);
  for (const Json& tool : tools) {
    const std::string name = tool.at("name"), summary = tool.at("summary");
    EXPECT_NE(help.find("\n  " + name + " "), std::string::npos) << name;
    EXPECT_NE(help.find(summary), std::string::npos) << name;
    EXPECT_EQ(tool, json_of(name + " --describe"));
  }
  EXPECT_EQ(output_of("rupture --help"), help);
  EXPECT_EQ(output_of("rupture help help"), help);
}

TEST_F(Rupture, help_of_a_tool_is_the_tools_own) {
  EXPECT_EQ(output_of("rupture help load"), output_of("load --help"));
  EXPECT_EQ(output_of("rupture help analyze front"), output_of("analyze front --help"));
}

TEST_F(Rupture, says_where_it_misses_the_programs_if_it_was_copied) {
  write("libexec/rupture/restart", "not executable");
  for (const std::string folder : {"libexec/rupture", "bin"}) {
    const Outcome copied = run_installed({"restart"});
    EXPECT_EQ(copied.exit_code, kFailed);
    EXPECT_EQ(copied.err, "rupture: there is no program restart in " + path(folder).string() +
                              ": install rupture, or link to it instead of copying it\n");
    fs::remove_all(path("libexec"));
  }
}

TEST_F(Rupture, shows_its_help_where_no_tool_is_given) {
  const Outcome alone = run("rupture");
  EXPECT_EQ(alone.exit_code, kUsage);
  EXPECT_EQ(alone.out, "");
  EXPECT_EQ(alone.err, output_of("rupture help"));
}

}  // namespace
}  // namespace rupture::testing
