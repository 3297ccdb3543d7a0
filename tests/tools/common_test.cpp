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
      "also", "json", "csv"}},
    {"analyze front",
     {"event", "quiet-time", "from", "to", "slow-below", "skip-below-x", "stencil",
      "stencils-at-ends", "ruptured-below", "also", "json", "csv"}},
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

TEST_F(Common, analyze_help_names_every_command) {
  const std::string help = output_of("analyze --help");
  for (const auto& [command, options] : kInterfaces) {
    const auto space = command.find(' ');
    if (space == std::string::npos) continue;
    EXPECT_NE(help.find("\n  " + command.substr(space + 1) + " "), std::string::npos) << command;
  }
}

TEST_F(Common, analyze_help_is_a_command_too) {
  EXPECT_EQ(output_of("analyze help"), output_of("analyze --help"));
  EXPECT_EQ(output_of("analyze help help"), output_of("analyze --help"));
  for (const std::string command : {"events", "slow-slip", "diff"}) {
    EXPECT_EQ(output_of("analyze help " + command), output_of("analyze " + command + " --help"));
  }
}

}  // namespace
}  // namespace rupture::testing
