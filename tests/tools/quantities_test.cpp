// analyze quantities: its list is what the commands print, no more and no less.
#include <algorithm>
#include <set>

#include "tool_test.hpp"

namespace rupture::test {
namespace {

/// Numbers, texts and truth values by name: keys joined by dots, * for an index.
using Leaves = std::map<std::string, Json>;

void add_leaves(const std::string& name, const Json& json, Leaves& leaves) {
  for (const auto& [key, value] : json.items()) {
    const std::string below = name + "." + (json.is_array() ? "*" : key);
    if (value.is_structured()) {
      add_leaves(below, value, leaves);
    } else if (const auto [leaf, is_new] = leaves.emplace(below, value);
               !is_new && leaf->second.is_null()) {
      leaf->second = value;
    }
  }
}

/// A null is no leaf where another time there was an object or an array.
void drop_absent_objects(Leaves& leaves) {
  std::erase_if(leaves, [&](const auto& leaf) {
    const auto below = leaves.lower_bound(leaf.first + ".");
    return leaf.second.is_null() && below != leaves.end() &&
           below->first.starts_with(leaf.first + ".");
  });
}

class Quantities : public ToolTest {
 protected:
  /// Output of all commands that measure something, for a rupture with a slow stretch.
  Leaves printed() const {
    output_of("prepare --tau-bar 0.1 --sigma-bar 0.1 -o p.h5 -q");
    output_of("restart p.h5 -o a.h5 --until-quiet --record r.h5 --record-every 2e-5 -q");
    Leaves leaves;
    for (const std::string command :
         {"front r.h5", "classify r.h5", "events r.h5", "slip r.h5 --x 0.07", "slow-slip r.h5",
          "loading r.h5 --x 0.07", "stress a.h5", "phi a.h5", "strength a.h5",
          "strength --shape bell --sigma-bar 0.1", "estimate a.h5", "steady-state --points 1"}) {
      add_leaves(command.substr(0, command.find(' ')), json_of("analyze " + command + " --json"),
                 leaves);
    }
    drop_absent_objects(leaves);
    return leaves;
  }
};

TEST_F(Quantities, AreExactlyWhatTheCommandsPrint) {
  const Leaves leaves = printed();
  const Json quantities = json_of("analyze quantities --json")["quantities"];
  std::set<std::string> listed;
  for (const Json& quantity : quantities) {
    const std::string name = quantity["name"];
    EXPECT_TRUE(listed.insert(name).second) << name << " is listed twice";
    EXPECT_NE(quantity["help"], "") << name;
    if (!leaves.contains(name)) {
      ADD_FAILURE() << name << " is listed, but no command prints it";
    } else if (const Json& value = leaves.at(name); !value.is_null()) {
      EXPECT_EQ(quantity["unit"] != "", value.is_number()) << name << " = " << value;
    }
  }
  for (const auto& [name, value] : leaves) {
    EXPECT_TRUE(listed.contains(name)) << name << " is printed, but not listed";
  }
}

TEST_F(Quantities, ParametersAreThoseOfAFile) {
  output_of("load -o a.h5 -q");
  const Json in_file = json_of("analyze show a.h5 --json")["parameters"];
  const Json listed = json_of("analyze quantities --json")["parameters"];
  EXPECT_EQ(listed.size(), in_file.size());
  for (const Json& parameter : listed) {
    const std::string name = parameter["name"];
    EXPECT_EQ(parameter["default"], in_file.at(name)) << name;
    EXPECT_NE(parameter["help"], "") << name;
  }
  EXPECT_EQ(listed[0], Json({{"name", "slider.L"},
                             {"unit", "m"},
                             {"default", 0.14},
                             {"help", "length of the slider along x"}}));
  const auto law = std::find_if(listed.begin(), listed.end(), [](const Json& parameter) {
    return parameter["name"] == "junctions.law";
  });
  EXPECT_EQ((*law)["unit"], "");
}

TEST_F(Quantities, TextHasOneLineEach) {
  const Json json = json_of("analyze quantities --json");
  const auto lines = lines_of(output_of("analyze quantities"));
  EXPECT_EQ(lines.size(), json["parameters"].size() + json["quantities"].size() + 3);
  const auto speed = std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
    return line.find(" front.slow.speed ") != std::string::npos;
  });
  ASSERT_NE(speed, lines.end());
  EXPECT_NE(speed->find("[m/s]  median front speed in the slow stretch"), std::string::npos);
}

}  // namespace
}  // namespace rupture::test
