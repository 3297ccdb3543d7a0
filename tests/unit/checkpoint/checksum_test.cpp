// tests/python/package_test.py recomputes the checksums of whole files.
#include "rupture/checkpoint/checksum.hpp"

#include "fixtures.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

// --- which parameters count: what the law uses, and of the later ones what differs from its
// default

constexpr const char* kNewPath = "/parameters/junctions/new";

Content content_of(Law law) {
  Parameters parameters;
  parameters.law = law;
  return parameters_content(parameters);
}

// The content after one parameter was given another value than its default.
Content changed(Law law, const ParameterInfo& info) {
  Parameters parameters;
  const bool whole = std::holds_alternative<std::int64_t Parameters::*>(info.member);
  std::string text = whole ? "7" : "0.7";  // valid in every row, and no default
  if (!info.valid.words.empty()) text = info.valid.words.back();
  if (may_vary_along_x(info)) text += " from 0 to 10mm";
  set_parameter(parameters, info.name, text);
  parameters.law = law;
  return parameters_content(parameters);
}

// The table of a later build that has one parameter more, with the default 0.0015.
std::vector<ParameterInfo> table_with_new(std::vector<Law> laws) {
  std::vector<ParameterInfo> table = parameter_table();
  ParameterInfo added = find_parameter("junctions.v_slow");
  added.name = "junctions.new";
  added.laws = std::move(laws);
  added.since = Since::later;
  table.push_back(added);
  return table;
}

Content content_with_new(double value) {
  Content content = content_of(Law::reference);
  content[kNewPath] = make_scalar(value, "m/s");
  return content;
}

TEST(CountedParameters, stay_what_they_were_when_a_parameter_is_added) {
  for (const Law law : kAllLaws) {
    const Content counted = counted_parameters(content_of(law));
    EXPECT_EQ(counted_parameters(content_of(law), table_with_new({})), counted);
    EXPECT_EQ(counted_parameters(content_of(law), table_with_new({law})), counted);
  }
  const Content counted = counted_parameters(content_of(Law::reference));
  EXPECT_EQ(counted_parameters(content_with_new(0.0015), table_with_new({})), counted);
}

TEST(CountedParameters, have_a_later_one_only_away_from_its_default) {
  EXPECT_TRUE(counted_parameters(content_with_new(0.002), table_with_new({})).contains(kNewPath));
  const auto used = table_with_new({Law::reference});
  EXPECT_TRUE(counted_parameters(content_with_new(0.002), used).contains(kNewPath));
  const auto unused = table_with_new({Law::decaying});
  EXPECT_FALSE(counted_parameters(content_with_new(0.002), unused).contains(kNewPath));
}

TEST(CountedParameters, are_those_that_the_law_uses) {
  for (const ParameterInfo& info : parameter_table()) {
    if (info.name == "junctions.law") continue;
    for (const Law law : kAllLaws) {
      EXPECT_EQ(content_checksum(changed(law, info)) != content_checksum(content_of(law)),
                is_used(info, law))
          << info.name;
    }
  }
}

}  // namespace rupture::testing
