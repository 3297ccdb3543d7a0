// What a record may hold besides its series: crossings of other pinned fractions, and fields.
#include <filesystem>
#include <limits>
#include <utility>

#include "record_fixture.hpp"
#include "rupture/checkpoint/checksum.hpp"

namespace rupture {
namespace {

namespace fs = std::filesystem;
using testing::expect_contains;
using testing::failure_of;
using testing::RecordFile;
using testing::small_parameters;
using testing::small_sample;

class RecordWithParts : public RecordFile {
 protected:
  static constexpr std::size_t kBlocks = 20;  // of small_parameters()
  const RecordParts crossings = {.crossing_levels = {0.2, 0.5}};
  const RecordParts fields = {.fields = Fields::record};
  const RecordParts both = {{0.2, 0.5}, Fields::record};

  RecordWriter writer_of(const char* name, const RecordParts& parts, const Content& rows = {}) {
    return {file(name), small_parameters(), {}, IfExists::replace, rows, 8, parts};
  }
  static FieldSample field_sample(int n) {
    FieldSample sample{0.001 * n, 100 * n, {}, {}};
    for (std::size_t i = 0; i < kBlocks; ++i) {
      sample.u_x.push_back(static_cast<float>(n) + static_cast<float>(i) / 32.0F);
      sample.u_z.push_back(-sample.u_x.back());
    }
    return sample;
  }
  /// Fields are sampled half as often.
  static void append_all(RecordWriter& record, const RecordParts& parts, int from, int to) {
    for (int n = from; n < to; ++n) {
      append(record, n, n + 1);
      if (!parts.crossing_levels.empty()) {
        record.append(std::vector<Rupture>{{100 * n, 0.001 * n, n % 5, n % 3 == 0 ? 0.2 : 0.5}});
      }
      if (parts.fields == Fields::record && n % 2 == 0) record.append(field_sample(n));
    }
  }
  std::string write(const char* name, const RecordParts& parts) {
    auto out = writer_of(name, parts);
    append_all(out, parts, 0, 20);
    return out.finish();
  }
};

TEST_F(RecordWithParts, returns_crossings_by_their_level) {
  write("r.h5", both);
  const Record record = read_record(file("r.h5"));
  expect_samples(record, 20);
  EXPECT_EQ(record.crossing_levels, (std::vector<double>{0.2, 0.5}));
  EXPECT_EQ(record.crossings.size(), 20U);
  EXPECT_EQ(ruptures_below(record, kRupturedFraction), record.ruptures);
  EXPECT_EQ(ruptures_below(record, kRupturedFraction).size(), 5U);
  const auto low = ruptures_below(record, 0.2);
  ASSERT_EQ(low.size(), 7U);
  EXPECT_EQ(low[6], (Rupture{1800, 0.001 * 18, 3, 0.2}));
  EXPECT_EQ(ruptures_below(record, 0.5).size(), 13U);
  EXPECT_EQ(failure_of([&] { ruptures_below(record, 0.4); }),
            "the record has no crossings of a pinned fraction of 0.4, only of 0.2, "
            "0.5, 0.3: record it with --crossings 0.4");
}

TEST_F(RecordWithParts, knows_its_levels_without_any_crossing) {
  auto out = writer_of("r.h5", crossings);
  append(out, 0, 4);
  out.finish();
  EXPECT_TRUE(ruptures_below(read_record(file("r.h5")), 0.5).empty());
}

TEST_F(RecordWithParts, returns_fields_and_their_positions) {
  write("r.h5", both);
  const auto [record, content, ignored_bytes] = read_record_file(file("r.h5"));
  EXPECT_EQ(ignored_bytes, 0U);
  EXPECT_EQ(record.fields, Fields::record);
  EXPECT_EQ(record.field_step.size(), 10U);
  EXPECT_EQ(record.field_step[9], 1800);
  EXPECT_EQ(read_array<double>(content, "/fields/time", {10})[9], 0.001 * 18);
  const auto u_z = read_array<float>(content, "/fields/u_z", {10, 4, 5});
  EXPECT_EQ(std::vector<float>(u_z.end() - kBlocks, u_z.end()), field_sample(18).u_z);
  EXPECT_EQ(read_array<double>(content, "/fields/z", {4}),
            (std::vector<double>{0, 0.01, 0.02, 0.03}));
}

TEST_F(RecordWithParts, that_begins_with_the_rows_of_another_continues_it) {
  for (const RecordParts& parts : {RecordParts{}, crossings, fields, both}) {
    const std::string checksum = write("whole.h5", parts);
    for (const int kept : {0, 1, 8, 13}) {
      const Content rows = rows_until(read_content(file("whole.h5")), 100 * (kept - 1));
      auto out = writer_of("r.h5", parts, rows);
      const Record part = read_record(file("r.h5.part"));
      expect_samples(part, kept);
      EXPECT_EQ(std::ssize(part.crossings), parts.crossing_levels.empty() ? 0 : kept);
      append_all(out, parts, kept, 20);
      EXPECT_EQ(out.finish(), checksum) << kept;
    }
  }
}

TEST_F(RecordWithParts, adds_nothing_but_them_and_they_count) {
  const std::string checksum_without = write("q.h5", {});
  EXPECT_EQ(read_record(file("q.h5")).fields, Fields::omit);
  for (const auto& [group, parts] : {std::pair("/crossings/", crossings), {"/fields/", fields}}) {
    EXPECT_NE(write("r.h5", parts), checksum_without);
    Content content = read_content(file("r.h5"));
    std::erase_if(content, [&group = group](const auto& item) {  // clang 14 captures no binding
      return item.first.starts_with(group);
    });
    EXPECT_EQ(content_checksum(content), checksum_without);
  }
}

TEST_F(RecordWithParts, of_large_sliders_are_flushed_by_their_size) {
  Parameters large = small_parameters();
  large.Nx = 401;
  large.L = 4.0;
  large.Nz = 401;
  FieldSample sample{0.0, 0, std::vector<float>(401 * 401), std::vector<float>(401 * 401)};
  RecordWriter out(file("r.h5"), large, {}, IfExists::refuse, {}, RecordWriter::kFlushEvery,
                   {.fields = Fields::record});
  const auto begun = fs::file_size(file("r.h5.part"));
  out.append(sample);
  EXPECT_GT(fs::file_size(file("r.h5.part")), begun + 8 * 401 * 401);
}

TEST_F(RecordWithParts, with_impossible_values_is_refused) {
  auto out = writer_of("r.h5", fields);
  FieldSample bad = field_sample(0);
  bad.u_x.pop_back();
  EXPECT_EQ(failure_of([&] { out.append(bad); }),
            "a sample has 19 values of u_x; expected Nx Nz = 20");
  auto infinite = writer_of("i.h5", fields);
  bad = field_sample(0);
  bad.u_z[7] = std::numeric_limits<float>::infinity();
  infinite.append(bad);
  expect_contains(failure_of([&] { infinite.flush(); }),
                  "/fields/u_z holds inf at index 7 of [1][4][5]; only finite numbers are stored");
}

}  // namespace
}  // namespace rupture
