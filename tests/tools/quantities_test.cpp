// analyze quantities: parameters as in a file, and one line for each quantity.
#include <algorithm>
#include <set>

#include "tool_test.hpp"

namespace rupture::testing {
namespace {

class Quantities : public ToolTest {};

TEST_F(Quantities, parameters_are_those_of_a_file) {
  output_of("load -o a.h5 -q");
  const Json in_file = json_of("analyze show a.h5 --json")["parameters"];
  const Json listed = json_of("analyze quantities --json")["parameters"];
  EXPECT_EQ(listed.size(), in_file.size());
  for (const Json& parameter : listed) {
    const std::string name = parameter["name"];
    EXPECT_EQ(parameter["default"], in_file.at(name)) << name;
    EXPECT_NE(parameter["help"], "") << name;
  }
  EXPECT_EQ(listed, json_of("parameters --json")["parameters"]);
  const auto law = std::find_if(listed.begin(), listed.end(), [](const Json& parameter) {
    return parameter["name"] == "junctions.law";
  });
  EXPECT_EQ((*law)["unit"], "");
}

TEST_F(Quantities, each_is_named_once_with_its_meaning) {
  const Json json = json_of("analyze quantities --json");
  Json quantities = json["quantities"];
  EXPECT_FALSE(quantities.empty());
  EXPECT_FALSE(json["summaries"].empty());
  quantities.insert(quantities.end(), json["summaries"].begin(), json["summaries"].end());
  std::set<std::string> names;
  for (const Json& quantity : quantities) {
    const std::string name = quantity["name"];
    EXPECT_TRUE(names.insert(name).second) << name << " is listed twice";
    EXPECT_NE(quantity["help"], "") << name;
  }
}

TEST_F(Quantities, text_has_one_line_each) {
  const Json json = json_of("analyze quantities --json");
  const auto lines = lines_of(output_of("analyze quantities"));
  EXPECT_EQ(lines.size(),
            json["parameters"].size() + json["quantities"].size() + json["summaries"].size() + 5);
  const auto speed = std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
    return line.find(" front.slow.speed ") != std::string::npos;
  });
  ASSERT_NE(speed, lines.end());
  EXPECT_NE(speed->find("[m/s]  median front speed in the slow stretch"), std::string::npos);
}

}  // namespace
}  // namespace rupture::testing
