#include "rupture/checkpoint/checksum.hpp"

#include <set>

#include "fixtures.hpp"

namespace rupture {
namespace {

Content example() {
  const std::vector<double> values = {0.5, -1.25};
  return {{"/parameters/slider/L", make_scalar(0.14, "m")},
          {"/parameters/junctions/f_new", make_text("zero")},
          {"/state/u_x", make_array(std::span(values), {1, 2}, "m")}};
}

TEST(Sha256, agrees_with_the_published_test_vectors) {
  EXPECT_EQ(sha256({}), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256(testing::bytes_of("abc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(ContentChecksum, is_what_it_has_always_been) {
  // Computed with the Python of docs/schema.md; a change here breaks every stored checksum.
  EXPECT_EQ(content_checksum_of_schema_2(example()),
            "e50eee69396f97f53890922ef4bf7816e4537ac5ea6e548d27127a519ebfa919");
}

TEST(ContentChecksum, ignores_units_and_provenance) {
  Content other = example();
  other.at("/state/u_x").unit = "mm";
  other["/provenance/0000/tool"] = make_text("load");
  EXPECT_EQ(content_checksum(other), content_checksum(example()));
}

TEST(ContentChecksum, changes_with_path_type_shape_value_and_presence) {
  std::set<std::string> seen = {content_checksum(example())};
  const auto expect_new = [&](const Content& content) {
    EXPECT_TRUE(seen.insert(content_checksum(content)).second);
  };
  Content moved = example();
  moved["/state/u_z"] = moved.at("/state/u_x");
  expect_new(moved);
  moved.erase("/state/u_x");
  expect_new(moved);
  Content typed = example();
  typed.at("/state/u_x").type = DataType::int64;
  expect_new(typed);
  Content shaped = example();
  shaped.at("/state/u_x").shape = {2, 1};
  expect_new(shaped);
  Content valued = example();
  valued.at("/state/u_x").bytes[0] = std::byte{1};
  expect_new(valued);
  Content worded = example();
  worded["/parameters/junctions/f_new"] = make_text("f_slip");
  expect_new(worded);
}

TEST(ContentChecksum, covers_series_and_ruptures_too) {
  EXPECT_TRUE(is_checksummed("/series/p"));
  EXPECT_TRUE(is_checksummed("/ruptures/step"));
  EXPECT_TRUE(is_checksummed("/crossings/step"));
  EXPECT_FALSE(is_checksummed("/provenance/0000/tool"));
  EXPECT_FALSE(is_checksummed("/statement"));
}

}  // namespace
}  // namespace rupture
