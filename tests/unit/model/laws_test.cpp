// The table of the interface laws.
#include "rupture/model/laws.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "rupture/model/derived.hpp"
#include "rupture/model/state.hpp"
#include "support/sliders.hpp"

namespace rupture {
namespace {

TEST(LawTable, has_a_row_for_every_word_of_the_parameter_in_its_order) {
  EXPECT_EQ(choices(find_parameter("junctions.law")), law_names());
  for (std::size_t i = 0; i < law_table().size(); ++i) {
    Parameters p;
    set_parameter(p, "junctions.law", law_table()[i].name);
    EXPECT_EQ(static_cast<std::size_t>(p.law), i);
    EXPECT_EQ(law_info(p.law).name, law_table()[i].name);
  }
  EXPECT_EQ(law_info(Law::reference).name, "reference");
  EXPECT_EQ(law_info(Law::simplified).name, "simplified");
  EXPECT_EQ(law_info(Law::decaying).name, "decaying");
  EXPECT_EQ(law_info(Law::distance).name, "distance");
}

TEST(LawTable, switches_slow_slip_off_by_a_parameter_of_the_law) {
  for (const Law law : testing::kAllLaws) {
    const std::string_view text = law_info(law).slow_slip_off;
    const ParameterInfo& info = find_parameter(text.substr(0, text.find(' ')));
    EXPECT_EQ(std::count(info.laws.begin(), info.laws.end(), law), 1) << text;
  }
}

TEST(LawTable, shapes_the_state) {
  for (const Law law : testing::kAllLaws) {
    Parameters p;
    p.law = law;
    const State state(p);
    const bool one = law_info(law).springs == SpringsPerBlock::one;
    EXPECT_EQ(state.junctions.attachment.cols(), one ? 1 : p.N_s);
    for (const LawInfo& other : law_table()) {
      if (!other.memory) continue;
      const auto size = (state.junctions.*other.memory->array).size();
      EXPECT_EQ(size, other.name == law_info(law).name ? state.junctions.draws.size() : 0);
    }
  }
}

}  // namespace
}  // namespace rupture
