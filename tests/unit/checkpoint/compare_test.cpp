#include "rupture/checkpoint/compare.hpp"

#include <limits>

#include "fixtures.hpp"

namespace rupture {
namespace {

Content with(const std::vector<double>& values) {
  return {{"/state/a", make_array(std::span(values), {values.size()}, "m")}};
}

TEST(UlpDistance, counts_representable_numbers) {
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_EQ(ulp_distance(1.0, 1.0), 0U);
  EXPECT_EQ(ulp_distance(1.0, next), 1U);
  EXPECT_EQ(ulp_distance(next, 1.0), 1U);
  EXPECT_EQ(ulp_distance(1.0, 2.0), std::uint64_t{1} << 52U);
  EXPECT_EQ(ulp_distance(-0.0, 0.0), 1U);
  EXPECT_EQ(ulp_distance(-5e-324, 5e-324), 3U);
}

TEST(Diff, of_equal_contents_is_empty) {
  EXPECT_TRUE(diff(with({1, 2}), with({1, 2})).empty());
}

TEST(Diff, measures_values) {
  const auto found = diff(with({1, 2, 3, 4}), with({1, std::nextafter(2.0, 3.0), 3, 5}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].path, "/state/a");
  EXPECT_EQ(found[0].change, Change::values);
  EXPECT_EQ(found[0].count, 2U);
  EXPECT_EQ(found[0].first, 1U);
  EXPECT_EQ(found[0].largest_absolute, 1.0);
  EXPECT_EQ(found[0].largest_relative, 0.2);
  EXPECT_EQ(found[0].largest_ulp, std::uint64_t{1} << 50U);
}

TEST(Diff, sees_the_sign_of_zero) {
  const auto found = diff(with({0.0}), with({-0.0}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].count, 1U);
  EXPECT_EQ(found[0].largest_absolute, 0.0);
  EXPECT_EQ(found[0].largest_relative, 0.0);
  EXPECT_EQ(found[0].largest_ulp, 1U);
}

TEST(Diff, measures_integers_without_ulp) {
  const auto found = diff({{"/n", make_scalar<std::uint32_t>(3, "1")}},
                          {{"/n", make_scalar<std::uint32_t>(5, "1")}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].largest_absolute, 2.0);
  EXPECT_EQ(found[0].largest_relative, 0.4);
  EXPECT_EQ(found[0].largest_ulp, 0U);
}

TEST(Diff, finds_the_first_byte_of_a_text_that_differs) {
  const auto found = diff({{"/t", make_text("gauss")}}, {{"/t", make_text("gausz and more")}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].change, Change::values);
  EXPECT_EQ(found[0].first, 4U);
}

TEST(Diff, names_other_shapes_types_and_missing_datasets_in_order_of_path) {
  Content a = with({1, 2});
  Content b = with({1, 2, 3});
  a["/state/z"] = make_scalar(1.0, "m");
  b["/state/z"] = make_scalar<std::int64_t>(1, "m");
  a["/state/c"] = make_text("a");
  b["/state/b"] = make_text("b");
  const auto found = diff(a, b);
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[0].change, Change::shape);
  EXPECT_EQ(found[1].path, "/state/b");
  EXPECT_EQ(found[1].change, Change::only_in_b);
  EXPECT_EQ(found[2].path, "/state/c");
  EXPECT_EQ(found[2].change, Change::only_in_a);
  EXPECT_EQ(found[3].change, Change::type);
}

TEST(Diff, of_checksummed_parts_ignores_provenance) {
  Content a = with({1});
  a["/provenance/0000/tool"] = make_text("load");
  EXPECT_TRUE(diff(checksummed_part(a), checksummed_part(with({1}))).empty());
}

}  // namespace
}  // namespace rupture
