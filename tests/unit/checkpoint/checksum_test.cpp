// The content of files. tests/python/package_test.py recomputes the checksums of whole ones, and
// with them which parameters count.
#include "rupture/checkpoint/checksum.hpp"

#include "fixtures.hpp"
#include "rupture/checkpoint/compare.hpp"

namespace rupture::testing {

// --- datasets, and where and by how much they differ (whole files: tests/tools/tables/diff.txt)

Content with(const std::vector<double>& values) {
  return {{"/state/a", make_array(std::span(values), {values.size()}, "m")}};
}

TEST(Content, refuses_a_text_with_a_null) {
  EXPECT_EQ(message_of<Failure>([] { make_text(std::string_view("a\0b", 3)); }),
            "a text to be stored contains a null byte; texts are null-padded");
}

TEST(Content, refuses_an_array_whose_bytes_do_not_fill_its_shape) {
  Content content = with({1, 2, 3});
  content.at("/state/a").bytes.pop_back();
  EXPECT_EQ(message_of<Failure>([&] { read_array<double>(content, "/state/a", {3}); }),
            "/state/a holds 23 bytes, which is not float64 of shape [3]");
}

struct Measured {
  std::vector<double> a, b;
  std::uint64_t count, first;
  Largest<double> absolute, relative;
  Largest<std::uint64_t> ulp;
};

TEST(Diff, measures_values_and_says_where_each_difference_is_largest) {
  const std::vector<Measured> rows = {
      {{1, 2, 3, 4}, {1, std::nextafter(2.0, 3.0), 3, 5}, 2, 1, {1, 3}, {0.2, 3}, {1ULL << 50U, 3}},
      {{1, 1e3, 0}, {2, 1010, 5e-324}, 3, 0, {10, 1}, {1, 2}, {1ULL << 52U, 0}},
      {{0, 1, 2, 3}, {0, 1, 3, 4}, 2, 2, {1, 2}, {1.0 / 3, 2}, {1ULL << 51U, 2}},  // the first
      {{1, 0.0}, {1, -0.0}, 1, 1, {0, 1}, {0, 1}, {1, 1}},
      {{-5e-324}, {5e-324}, 1, 0, {1e-323, 0}, {2, 0}, {3, 0}}};
  for (const Measured& row : rows) {
    const auto found = diff(with(row.a), with(row.b));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].path, "/state/a");
    EXPECT_EQ(found[0].change, Change::values);
    EXPECT_EQ(found[0].count, row.count);
    EXPECT_EQ(found[0].first, row.first);
    EXPECT_EQ(found[0].absolute.value, row.absolute.value);
    EXPECT_EQ(found[0].absolute.index, row.absolute.index);
    EXPECT_DOUBLE_EQ(found[0].relative.value, row.relative.value);
    EXPECT_EQ(found[0].relative.index, row.relative.index);
    EXPECT_EQ(found[0].ulp.value, row.ulp.value);
    EXPECT_EQ(found[0].ulp.index, row.ulp.index);
  }
}

}  // namespace rupture::testing
