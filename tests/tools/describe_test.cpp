// What all programs say of themselves, to --help, --describe and --version, and take what they say.
#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

#include "rupture/forces/kernels.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

/// Each program or command of analyze, and the options that it has besides help, describe and
/// version.
constexpr const char* kPrograms =
    R"(load: until checkpoint-at checkpoint-every record record-every crossings fields threads on-alarm
  resume dry-run json output force sum quiet config set seed
prepare: tau-bar sigma-bar shape x-trigger tau-bar-trigger no-trigger output force sum quiet json
  config set seed
restart: until for until-quiet arrived-below checkpoint-at checkpoint-every record record-every
  crossings fields threads on-alarm resume dry-run json output force sum quiet config set seed
modify-phi: shape sigma-bar x-from x-to slipping output force sum quiet json
parameters: json
finish: output force sum quiet json
seal: original output force sum quiet json
analyze events: quiet-time slow-below skip-below-x stencil stencils-at-ends ruptured-below also
  json csv
analyze front: event quiet-time from to slow-below skip-below-x stencil stencils-at-ends
  ruptured-below also json csv
analyze classify: event quiet-time from to slow-below skip-below-x stencil stencils-at-ends
  ruptured-below json
analyze slip: x from to json csv
analyze slow-slip: event quiet-time x-from x-to longest shortest to-last-stencil from to slow-below
  skip-below-x stencil stencils-at-ends ruptured-below json csv
analyze loading: x json csv
analyze stress: json csv
analyze phi: bins json csv
analyze strength: shape sigma-bar json csv
analyze estimate: ensemble seed json csv
analyze steady-state: v-from v-to points steps-per-cycle json csv config set seed
analyze quantities: json
analyze checksum: as-schema-2
analyze verify: manifest
analyze diff: common json
analyze show: json
analyze lineage: commands output from json
)";

struct Program {
  std::string name;
  std::set<std::string> options = {"help", "describe", "version"};
};

std::ostream& operator<<(std::ostream& out, const Program& program) {
  return out << program.name;
}

std::vector<Program> programs() {
  std::vector<Program> all;
  for (const std::string& line : lines_of(kPrograms)) {
    const std::size_t colon = line.find(':');
    if (colon != line.npos) all.push_back({line.substr(0, colon)});
    std::istringstream words(line.substr(colon + 1));  // from 0 without a colon
    for (std::string word; words >> word;) all.back().options.insert(word);
  }
  return all;
}

/// A value that an option takes, or nothing for a flag.
std::string value_for(const Json& option) {
  static const std::map<std::string, std::string> values = {
      {"flag", ""},         {"number", "0.5"},      {"integer", "7"},       {"text", "word"},
      {"parameter", "a=1"}, {"input file", "a.h5"}, {"output file", "b.h5"}};
  const std::string kind = option.at("kind");
  return kind == "choice" ? std::string(option.at("words")[0]) : values.at(kind);
}

/// " --NAME VALUE", or " --NAME" of a flag.
std::string given(const Json& option) {
  const std::string value = value_for(option), name = option.at("name");
  return " --" + name + (value.empty() ? "" : " " + value);
}

const Json& option_named(const Json& program, const std::string& name) {
  const Json& options = program.at("options");
  const auto found = std::find_if(options.begin(), options.end(),
                                  [&](const Json& option) { return option.at("name") == name; });
  if (found == options.end()) throw std::out_of_range(name);
  return *found;
}

using Describe = ToolTest;

class EachProgram : public ToolTest, public ::testing::WithParamInterface<Program> {
 protected:
  const std::string name = GetParam().name;
  const Json program = json_of(name + " --describe");
  const std::string help = output_of(name + " --help");
};

TEST_P(EachProgram, describes_all_options_with_the_texts_of_help) {
  EXPECT_EQ(lines_of(output_of(name + " --describe")).size(), 1U);
  const std::string synopsis = program.at("synopsis"), usage = "Usage: rupture " + name + " ";
  EXPECT_TRUE(help.starts_with("Usage: rupture " + synopsis + "\n")) << help;
  EXPECT_TRUE(help.starts_with(usage)) << help;
  EXPECT_EQ(std::string(program.at("purpose")).find('\n'), std::string::npos);
  std::set<std::string> described;
  for (const Json& option : program.at("options")) {
    described.insert(option.at("name"));
    EXPECT_NE(help.find("--" + std::string(option.at("name")) + " "), std::string::npos) << option;
    const std::string unit = option.at("unit"), kind = option.at("kind");
    EXPECT_EQ(unit.empty(), kind != "number" && kind != "integer") << option;
    if (unit.empty() || unit == "1") continue;
    const std::string value = option.at("value");
    EXPECT_NE(help.find(value + " [" + unit + "]"), std::string::npos) << option;
  }
  EXPECT_EQ(described, GetParam().options);
  const auto lines = lines_of(help.substr(0, help.find("\nParameters")));
  EXPECT_EQ(std::ranges::count_if(lines, [](const auto& line) { return line.starts_with("  -"); }),
            std::ssize(described))
      << help;
}

TEST_P(EachProgram, takes_the_options_that_it_describes) {
  std::string all;
  for (const Json& option : program.at("options")) {
    if (option.at("name") != "describe" && option.at("name") != "version") all += given(option);
  }
  EXPECT_EQ(output_of(name + all), help);
}

TEST_P(EachProgram, needs_one_of_those_that_are_needed) {
  const Json& groups = program.at("one_needed");
  for (const Json& missing : groups) {
    std::string command = name + (program.at("input").is_null() ? "" : " none.h5");
    for (const Json& group : groups) {
      if (group != missing) command += given(option_named(program, group[0]));
    }
    expect_refusal_with(command, kUsage, "--" + std::string(missing.back()));
  }
}

TEST_P(EachProgram, says_its_version_and_suggests_an_option_for_a_mistyped_one) {
  const std::string version = output_of(name + " --version");
  EXPECT_TRUE(version.starts_with(name + " (rupture ")) << version;
  EXPECT_NE(version.find(", commit "), std::string::npos) << version;
  EXPECT_TRUE(version.ends_with(fmt::format(", {})\n", kernels().name))) << version;
  expect_refusal(
      name + " --versoin", kUsage,
      "unknown option '--versoin': did you mean '--version'? See rupture " + name + " --help");
}

INSTANTIATE_TEST_SUITE_P(Tools, EachProgram, ::testing::ValuesIn(programs()), [](const auto& test) {
  std::string name = test.param.name;
  std::ranges::replace_if(
      name, [](char c) { return c == ' ' || c == '-'; }, '_');
  return name;
});

TEST_F(Describe, says_what_restart_does) {
  const Json restart = json_of("restart --describe");
  EXPECT_EQ(restart.at("input"), "checkpoint");
  EXPECT_EQ(restart.at("outputs"), Json::array({"record", "checkpoint"}));
  EXPECT_EQ(restart.at("parameters"), true);
  EXPECT_EQ(restart.at("one_needed"),
            Json::array({Json::array({"until", "for", "until-quiet"}), Json::array({"output"})}));
  const Json expected = {{"name", "record-every"}, {"short", nullptr}, {"kind", "number"},
                         {"value", "T"},           {"unit", "s"},      {"default", 1e-4}};
  Json option = option_named(restart, "record-every");
  option.erase("help");
  EXPECT_EQ(option, expected);
  EXPECT_EQ(option_named(restart, "output").at("short"), "o");
  EXPECT_EQ(option_named(restart, "on-alarm").at("words"), Json::array({"stop", "report"}));
  EXPECT_EQ(option_named(restart, "on-alarm").at("default"), "stop");
}

TEST_F(Describe, says_what_commands_read) {
  EXPECT_EQ(json_of("analyze front --describe").at("input"), "record");
  EXPECT_EQ(json_of("analyze stress --describe").at("input"), "checkpoint");
  EXPECT_EQ(json_of("analyze show --describe").at("input"), "file");
  EXPECT_EQ(json_of("analyze quantities --describe").at("input"), nullptr);
  EXPECT_EQ(json_of("analyze lineage --describe").at("outputs"), Json::array({"report"}));
  EXPECT_EQ(json_of("load --describe").at("input"), nullptr);
}

TEST_F(Describe, covers_all_commands_of_analyze) {
  const std::string help = output_of("analyze --help");
  const Json analyze = json_of("analyze --describe"), &commands = analyze.at("commands");
  EXPECT_TRUE(help.starts_with("Usage: rupture " + std::string(analyze.at("synopsis"))));
  std::size_t count = 0;
  for (const Program& program : programs()) {
    if (!program.name.starts_with("analyze ")) continue;
    EXPECT_NE(help.find("\n  " + program.name.substr(8) + " "), std::string::npos) << program;
    EXPECT_EQ(std::ranges::count(commands, json_of(program.name + " --describe")), 1) << program;
    ++count;
  }
  EXPECT_EQ(commands.size(), count);
  const auto lines = lines_of(help);
  EXPECT_EQ(std::ranges::count_if(lines, [](const auto& line) { return line.starts_with("  "); }),
            count + 1)
      << "with help";
}

TEST_F(Describe, analyze_help_is_a_command_too) {
  EXPECT_EQ(output_of("analyze help"), output_of("analyze --help"));
  EXPECT_EQ(output_of("analyze help help"), output_of("analyze --help"));
  for (const std::string command : {"events", "slow-slip", "diff"}) {
    EXPECT_EQ(output_of("analyze help " + command), output_of("analyze " + command + " --help"));
  }
}

}  // namespace
}  // namespace rupture::testing
