// --describe: programs say of themselves what they take, and take what they say.
#include <algorithm>
#include <stdexcept>

#include "tool_test.hpp"

namespace rupture::testing {
namespace {

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

class Describe : public ToolTest {
 protected:
  /// The descriptions of all programs and of all commands of analyze.
  std::vector<Json> programs() const {
    std::vector<Json> all;
    for (const std::string tool :
         {"load", "prepare", "restart", "modify-phi", "finish", "seal", "parameters"}) {
      all.push_back(json_of(tool + " --describe"));
    }
    const Json analyze = json_of("analyze --describe");
    all.insert(all.end(), analyze.at("commands").begin(), analyze.at("commands").end());
    return all;
  }
};

TEST_F(Describe, is_one_line) {
  for (const Json& program : programs()) {
    const std::string name = program.at("name"), text = output_of(name + " --describe");
    EXPECT_EQ(lines_of(text).size(), 1U) << name;
    Json own = Json::parse(text);
    if (program.contains("summary")) own["summary"] = program.at("summary");
    EXPECT_EQ(own, program) << "in analyze --describe";
  }
}

TEST_F(Describe, has_the_texts_of_help) {
  for (const Json& program : programs()) {
    const std::string name = program.at("name"), synopsis = program.at("synopsis");
    EXPECT_TRUE(output_of(name + " --help").starts_with("Usage: rupture " + synopsis + "\n"))
        << name;
    EXPECT_EQ(std::string(program.at("purpose")).find('\n'), std::string::npos) << name;
  }
}

TEST_F(Describe, names_options_that_are_taken_with_their_kind_of_value) {
  for (const Json& program : programs()) {
    std::string all;
    for (const Json& option : program.at("options")) {
      const std::string name = option.at("name");
      if (name != "describe" && name != "version") all += given(option);
    }
    const std::string name = program.at("name");
    EXPECT_EQ(output_of(name + all), output_of(name + " --help"));
  }
}

TEST_F(Describe, numbers_have_units_as_in_help) {
  for (const Json& program : programs()) {
    const std::string name = program.at("name"), help = output_of(name + " --help");
    for (const Json& option : program.at("options")) {
      const std::string unit = option.at("unit"), kind = option.at("kind");
      EXPECT_EQ(unit.empty(), kind != "number" && kind != "integer") << option;
      if (unit.empty() || unit == "1") continue;
      const std::string value = option.at("value");
      EXPECT_NE(help.find(value + " [" + unit + "]"), std::string::npos) << option;
    }
  }
}

TEST_F(Describe, one_of_the_needed_is_needed) {
  for (const Json& program : programs()) {
    const Json& groups = program.at("one_needed");
    const bool reads = !program.at("input").is_null();
    for (const Json& missing : groups) {
      std::string command = std::string(program.at("name")) + (reads ? " none.h5" : "");
      for (const Json& group : groups) {
        if (group != missing) command += given(option_named(program, group[0]));
      }
      expect_refusal_with(command, kUsage, "--" + std::string(missing.back()));
    }
  }
}

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
  const Json analyze = json_of("analyze --describe");
  EXPECT_TRUE(help.starts_with("Usage: rupture " + std::string(analyze.at("synopsis"))));
  const auto lines = lines_of(help);
  const auto listed = std::count_if(lines.begin(), lines.end(),
                                    [](const auto& line) { return line.starts_with("  "); });
  EXPECT_EQ(static_cast<std::size_t>(listed), analyze.at("commands").size() + 1) << "with help";
}

}  // namespace
}  // namespace rupture::testing
