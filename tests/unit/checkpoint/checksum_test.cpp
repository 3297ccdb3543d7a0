// The content of files. tests/python/package_test.py recomputes the checksums of whole ones.
#include "rupture/checkpoint/checksum.hpp"

#include "fixtures.hpp"
#include "rupture/checkpoint/compare.hpp"

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
