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

TEST_F(ParametersTool, restart_keeps_what_its_row_says) {
  output_of("load --config small.ini -o a.h5");
  const Json was = json_of("analyze show a.h5 --json")["parameters"];
  for (const auto& info : parameter_table()) {
    const bool whole = was[info.name].is_number_integer();
    const std::string other =
        info.valid.words.empty() ? (whole ? "7" : "0.7") : std::string(info.valid.words.back());
    const std::string sentence =
        fmt::format("{} cannot change in a restart: the state was made with ", info.name);
    const Outcome outcome =
        run(fmt::format("restart a.h5 -o b.h5 -f --for 0 --set {}={}", info.name, other));
    const bool kept = outcome.err.find(sentence) != std::string::npos;
    EXPECT_EQ(kept, info.restart == Restart::must_keep) << info.name << ": " << outcome.err;
  }
}

}  // namespace
}  // namespace rupture::testing
