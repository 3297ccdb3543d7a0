#include "rupture/checkpoint/content.hpp"

#include "fixtures.hpp"

namespace rupture {
namespace {

Content two_by_three() {
  const std::vector<double> values = {1, 2, 3, 4, 5, 6};
  return {{"/state/a", make_array(std::span(values), {2, 3}, "m")}};
}

TEST(Content, returns_arrays_scalars_and_texts_as_they_were_put_in) {
  Content content = two_by_three();
  content["/n"] = make_scalar<std::int64_t>(-7, "1");
  content["/t"] = make_text("gaussian");
  EXPECT_EQ(read_array<double>(content, "/state/a", {2, 3}),
            (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(read_scalar<std::int64_t>(content, "/n"), -7);
  EXPECT_EQ(read_text(content, "/t"), "gaussian");
  EXPECT_EQ(content.at("/state/a").unit, "m");
}

TEST(Content, keeps_an_empty_text_empty) {
  EXPECT_EQ(make_text("").bytes.size(), 1U);
  EXPECT_EQ(read_text({{"/t", make_text("")}}, "/t"), "");
}

}  // namespace
}  // namespace rupture
