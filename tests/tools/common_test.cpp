// Tests of the options that all tools have: --help, --version, --quiet, unknown options.
#include <fmt/core.h>

#include <algorithm>
#include <ostream>

#include "rupture/forces/kernels.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

/// A tool or a command of analyze, and the long options that it has beside kOfEvery.
struct Interface {
  std::string command;
  std::vector<std::string> options;
};

std::ostream& operator<<(std::ostream& out, const Interface& interface) {
  return out << interface.command;
}

const std::vector<std::string> kOfEvery = {"help", "describe", "version"};

const std::vector<Interface> kInterfaces = {
    {"load",
     {"until", "checkpoint-at", "checkpoint-every", "record", "record-every", "crossings", "fields",
      "threads", "on-alarm", "resume", "dry-run", "json", "output", "force", "sum", "quiet",
      "config", "set", "seed"}},
    {"prepare",
     {"tau-bar", "sigma-bar", "shape", "x-trigger", "tau-bar-trigger", "no-trigger", "output",
      "force", "sum", "quiet", "json", "config", "set", "seed"}},
    {"restart",
     {"until",  "for",          "until-quiet", "arrived-below", "checkpoint-at", "checkpoint-every",
      "record", "record-every", "crossings",   "fields",        "threads",       "on-alarm",
      "resume", "dry-run",      "json",        "output",        "force",         "sum",
      "quiet",  "config",       "set",         "seed"}},
    {"modify-phi",
     {"shape", "sigma-bar", "x-from", "x-to", "slipping", "output", "force", "sum", "quiet",
      "json"}},
    {"parameters", {"json"}},
    {"finish", {"output", "force", "sum", "quiet", "json"}},
    {"seal", {"original", "output", "force", "sum", "quiet", "json"}},
    {"analyze events",
     {"quiet-time", "slow-below", "skip-below-x", "stencil", "stencils-at-ends", "ruptured-below",
      "json", "csv"}},
    {"analyze front",
     {"event", "quiet-time", "from", "to", "slow-below", "skip-below-x", "stencil",
      "stencils-at-ends", "ruptured-below", "json", "csv"}},
    {"analyze classify",
     {"event", "quiet-time", "from", "to", "slow-below", "skip-below-x", "stencil",
      "stencils-at-ends", "ruptured-below", "json"}},
    {"analyze slip", {"x", "from", "to", "json", "csv"}},
    {"analyze slow-slip",
     {"event", "quiet-time", "x-from", "x-to", "longest", "shortest", "to-last-stencil", "from",
      "to", "slow-below", "skip-below-x", "stencil", "stencils-at-ends", "ruptured-below", "json",
      "csv"}},
    {"analyze loading", {"x", "json", "csv"}},
    {"analyze stress", {"json", "csv"}},
    {"analyze phi", {"bins", "json", "csv"}},
    {"analyze strength", {"shape", "sigma-bar", "json", "csv"}},
    {"analyze estimate", {"ensemble", "seed", "json", "csv"}},
    {"analyze steady-state",
     {"v-from", "v-to", "points", "steps-per-cycle", "json", "csv", "config", "set", "seed"}},
    {"analyze quantities", {"json"}},
    {"analyze checksum", {"as-schema-2"}},
    {"analyze verify", {"manifest"}},
    {"analyze diff", {"common", "json"}},
    {"analyze show", {"json"}},
    {"analyze lineage", {"commands", "output", "from", "json"}},
};

class EveryTool : public ToolTest, public ::testing::WithParamInterface<Interface> {
 protected:
  static std::vector<std::string> all_options() {
    auto all = GetParam().options;
    all.insert(all.end(), kOfEvery.begin(), kOfEvery.end());
    return all;
  }
};

TEST_P(EveryTool, help_names_every_option) {
  const std::string help = output_of(GetParam().command + " --help");
  EXPECT_EQ(help.find("Usage: rupture " + GetParam().command + " "), 0U) << help;
  for (const auto& option : all_options()) {
    EXPECT_NE(help.find("--" + option + " "), std::string::npos) << option;
  }
}

TEST_P(EveryTool, help_names_no_other_option) {
  const std::string help = output_of(GetParam().command + " --help");
  const auto lines = lines_of(help.substr(0, help.find("\nParameters")));
  const auto found = std::count_if(lines.begin(), lines.end(),
                                   [](const auto& line) { return line.starts_with("  -"); });
  EXPECT_EQ(static_cast<std::size_t>(found), all_options().size()) << help;
}

TEST_P(EveryTool, version_names_tool_version_commit_and_instruction_set) {
  const std::string version = output_of(GetParam().command + " --version");
  EXPECT_TRUE(version.starts_with(GetParam().command + " (rupture ")) << version;
  EXPECT_NE(version.find(", commit "), std::string::npos) << version;
  EXPECT_TRUE(version.ends_with(fmt::format(", {})\n", kernels().name))) << version;
}

TEST_P(EveryTool, suggests_an_option_for_a_mistyped_one) {
  expect_refusal(GetParam().command + " --versoin", kUsage,
                 "unknown option '--versoin': did you mean '--version'? See rupture " +
                     GetParam().command + " --help");
}

std::string test_name(const ::testing::TestParamInfo<Interface>& info) {
  std::string name = info.param.command;
  for (char& c : name) {
    if (c == ' ' || c == '-') c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Tools, EveryTool, ::testing::ValuesIn(kInterfaces), test_name);

using Common = ToolTest;

TEST_F(Common, help_of_tools_that_take_parameters_says_who_lists_them) {
  for (const std::string tool : {"load", "prepare", "restart"}) {
    EXPECT_NE(output_of(tool + " --help").find("\nParameters: rupture parameters lists "),
              std::string::npos);
  }
}

TEST_F(Common, analyze_help_names_every_command) {
  const std::string help = output_of("analyze --help");
  for (const auto& [command, options] : kInterfaces) {
    const auto space = command.find(' ');
    if (space == std::string::npos) continue;
    EXPECT_NE(help.find("\n  " + command.substr(space + 1) + " "), std::string::npos) << command;
  }
  EXPECT_NE(output_of("analyze --version").find("analyze (rupture "), std::string::npos);
}

TEST_F(Common, analyze_help_is_a_command_too) {
  EXPECT_EQ(output_of("analyze help"), output_of("analyze --help"));
  EXPECT_EQ(output_of("analyze help help"), output_of("analyze --help"));
  for (const std::string command : {"events", "slow-slip", "diff"}) {
    EXPECT_EQ(output_of("analyze help " + command), output_of("analyze " + command + " --help"));
  }
  expect_refusal("analyze help stres", kUsage,
                 "unknown command 'stres': did you mean 'stress'? See rupture analyze --help");
  expect_refusal("analyze help front slip", kUsage,
                 "'slip' is one word too many: name one command");
}

TEST_F(Common, analyze_suggests_a_command) {
  expect_refusal("analyze stres a.h5", kUsage,
                 "unknown command 'stres': did you mean 'stress'? See rupture analyze --help");
  expect_refusal_with("analyze", kUsage, "no command was given: name one of ");
}

TEST_F(Common, quiet_tools_print_nothing) {
  EXPECT_EQ(output_of("load --config small.ini -o a.h5 --until 1e-4 --record a-r.h5 "
                      "--checkpoint-at 5e-5 --quiet"),
            "");
  EXPECT_EQ(output_of("restart a.h5 -o b.h5 --for 1e-5 --record b-r.h5 -q"), "");
  EXPECT_EQ(output_of("prepare --tau-bar 0.1 -o d.h5 -q"), "");
  EXPECT_EQ(output_of("modify-phi a.h5 -o c.h5 --sigma-bar 0.1 -q"), "");
}

TEST_F(Common, writing_tools_print_the_checksum_of_what_they_wrote) {
  output_of("load --config small.ini -o a.h5 -q");
  const std::string restarted = output_of("restart a.h5 -o b.h5 --for 1e-5");
  EXPECT_NE(restarted.find("wrote b.h5  content-sha256 " + checksum_of("b.h5") + "\n"),
            std::string::npos);
  const std::string modified = output_of("modify-phi a.h5 -o c.h5");
  EXPECT_NE(modified.find("wrote c.h5  content-sha256 " + checksum_of("c.h5") + "\n"),
            std::string::npos);
}

TEST_F(Common, sums_are_written_on_request_only) {
  const std::vector<std::string> commands = {
      "load --config small.ini -o a.h5 --until 1e-4 --checkpoint-at 5e-5 --record r.h5",
      "restart a.h5 -o b.h5 --for 2e-5 --checkpoint-at 1.1e-4 --record s.h5",
      "prepare --tau-bar 0.1 -o c.h5", "modify-phi a.h5 -o d.h5"};
  for (const auto& command : commands) output_of(command);
  const Files without = files();
  for (const auto& command : commands) output_of(command + " --sum --force");
  for (const auto& [name, bytes] : without) {
    EXPECT_FALSE(name.ends_with(".sum")) << name;
    if (!name.ends_with(".h5")) continue;
    EXPECT_EQ(read(name + ".sum"), sum_line(name));
  }
}

TEST_F(Common, sums_of_files_that_are_replaced_are_never_those_of_others) {
  output_of("load --config small.ini -o a.h5 --record r.h5 --sum");
  const std::string sum = read("a.h5.sum");
  output_of("load --config small.ini -o a.h5 --record r.h5 --force");
  EXPECT_EQ(read("a.h5.sum"), sum) << "of the same content";
  output_of("load --config small.ini -o a.h5 --record r.h5 --until 1e-5 --force");
  EXPECT_FALSE(fs::exists(path("a.h5.sum")));
  EXPECT_FALSE(fs::exists(path("r.h5.sum")));
}

TEST_F(Common, standard_output_is_no_file_to_write) {
  output_of("load --config small.ini -o a.h5");
  const auto sentence = [](const std::string& option) {
    return "--" + option +
           " - is no file: checkpoints and records do not go to standard output; give the path of "
           "a file";
  };
  for (const char* command : {"load --config small.ini", "restart a.h5 --for 1e-5",
                              "prepare --tau-bar 0.1", "modify-phi a.h5"}) {
    expect_refusal(std::string(command) + " -o -", kUsage, sentence("output"));
  }
  for (const char* command : {"load --config small.ini", "restart a.h5 --for 1e-5"}) {
    expect_refusal(std::string(command) + " -o b.h5 --record -", kUsage, sentence("record"));
  }
  expect_refusal("analyze lineage a.h5 --commands -o -", kUsage, sentence("output"));
}

TEST_F(Common, output_option_is_required) {
  expect_refusal("load", kUsage,
                 "the option '--output' is required but missing; see rupture load --help");
  expect_refusal("load -o", kUsage,
                 "the required argument for option '--output' is missing; see rupture load --help");
}

TEST_F(Common, existing_files_are_only_replaced_when_forced) {
  output_of("load --config small.ini -o a.h5 -q");
  output_of("load --config small.ini -o r.h5 --record rec.h5 -q");
  constexpr const char* exists = "a.h5 exists; give --force to replace it";
  expect_refusal("load --config small.ini -o a.h5", kFailed, exists);
  expect_refusal("load --config small.ini -o b.h5 --record a.h5 --until 1e-5", kFailed, exists);
  expect_refusal("prepare --tau-bar 0.1 -o a.h5", kFailed, exists);
  expect_refusal("load --config small.ini -o b.h5 --record rec.h5", kFailed,
                 "rec.h5 exists; give --force to replace it");

  const std::string before = checksum_of("a.h5");
  output_of("restart r.h5 -o a.h5 --for 1e-5 --force");
  EXPECT_NE(checksum_of("a.h5"), before);
  output_of("modify-phi r.h5 -o a.h5 -f");
  output_of("load --config small.ini -o a.h5 --record rec.h5 -f");
  EXPECT_EQ(checksum_of("a.h5"), before);
}

TEST_F(Common, the_input_is_never_replaced_not_even_by_force) {
  output_of("load --config small.ini -o a.h5 -q");
  constexpr const char* never = "a.h5 is the input, which is never changed: give another output";
  for (const std::string force : {"", " --force"}) {
    expect_refusal("restart a.h5 -o a.h5 --for 1e-5" + force, kUsage, never);
    expect_refusal("modify-phi a.h5 -o a.h5" + force, kUsage, never);
  }
}

TEST_F(Common, existing_intermediate_checkpoints_are_only_replaced_when_forced) {
  write("a-t0.000050000.h5", "precious");
  const std::string command = "load --config small.ini -o a.h5 --until 1e-4 --checkpoint-at 5e-5";
  expect_refusal(command, kFailed, "a-t0.000050000.h5 exists; give --force to replace it");
  output_of(command + " --force");
  EXPECT_DOUBLE_EQ(json_of("analyze stress a-t0.000050000.h5 --json")["time"], 5e-5);
}

}  // namespace
}  // namespace rupture::testing
