// parameters: each row of the table, alone, by group and as JSON.
#include "rupture/model/parameters.hpp"

#include <fmt/format.h>

#include "rupture/model/error.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

using ParametersTool = ToolTest;

bool accepts(const std::string& name, const std::string& value) {
  Parameters parameters;
  try {
    set_parameter(parameters, name, value);
    return true;
  } catch (const UsageError&) {
    return false;
  }
}

TEST_F(ParametersTool, lists_all_in_a_line_each) {
  const auto lines = lines_of(output_of("parameters"));
  ASSERT_EQ(lines.size(), parameter_table().size() + 1);
  for (std::size_t i = 0; i < parameter_table().size(); ++i) {
    EXPECT_TRUE(lines[i + 1].starts_with(fmt::format("  {} ", parameter_table()[i].name)));
  }
}

TEST_F(ParametersTool, tells_of_a_number_and_of_a_choice_of_words) {
  EXPECT_EQ(output_of("parameters junctions.t_R junctions.f_new slider.Nx"),
            R"(junctions.t_R
  mean slipping time
  symbol   t_R
  unit     s
  default  0.002
  value    above 0 and at most 1000
  laws     reference, simplified, decaying

junctions.f_new
  force of a newly pinned junction; f_slip switches slow slip off
  symbol   f_new
  default  zero
  value    zero or f_slip
  laws     reference, distance

slider.Nx
  number of blocks along x
  symbol   N_x
  unit     1
  default  57
  value    of at least 3 and at most 65536
  laws     reference, simplified, decaying, distance
  restart  cannot change it
)");
}

TEST_F(ParametersTool, a_group_is_all_its_parameters) {
  const Json rows = json_of("parameters driving --json").at("parameters");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[2].at("name"), "driving.V");
  EXPECT_EQ(rows[2].at("minimum"), -10);
  EXPECT_EQ(rows[2].at("minimum_excluded"), false);
}

TEST_F(ParametersTool, json_has_the_ranges_that_are_enforced) {
  for (const Json& row : json_of("parameters --json").at("parameters")) {
    const std::string name = row.at("name");
    Parameters parameters;
    if (row.contains("words")) {
      EXPECT_NO_THROW(set_parameter(parameters, name, std::string(row.at("words").back())));
    } else {
      EXPECT_NO_THROW(set_parameter(parameters, name, row.at("maximum").dump())) << name;
      EXPECT_EQ(row.at("minimum_excluded"), !accepts(name, row.at("minimum").dump())) << name;
    }
  }
}

TEST_F(ParametersTool, refuses_other_names) {
  expect_refusal("parameters t_r", kUsage,
                 "unknown parameter 't_r': did you mean 'junctions.t_R'?");
  expect_refusal_with("parameters sliders", kUsage, "unknown parameter 'sliders'");
}

}  // namespace
}  // namespace rupture::testing
