// Records: their series, what they may hold besides (crossings of other pinned fractions, and
// fields), and those in the making.
#include "rupture/checkpoint/record.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <limits>

#include "fixtures.hpp"

namespace rupture {
namespace {

namespace fs = std::filesystem;
using testing::expect_contains;
using testing::message_of;
using testing::slurp;
using testing::small_parameters;
using testing::small_sample;
using testing::spill;

/// Small ones, of which every number is known.
class RecordFile : public testing::InFolder {
 protected:
  static constexpr std::size_t kNx = 5, kBlocks = 20;  // of small_parameters()

  RecordWriter writer(const char* name, std::size_t flush_every = 256,
                      IfExists if_exists = IfExists::refuse) {
    return {file(name), small_parameters(), testing::small_checkpoint().provenance, if_exists, {},
            {},         flush_every};
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
  static void append(RecordWriter& record, int from, int to, const RecordParts& parts = {}) {
    for (int n = from; n < to; ++n) {
      record.append(small_sample(kNx, n));
      if (n % 4 == 0) record.append(std::vector<Rupture>{{100 * n, 0.001 * n, n % 5}});
      if (!parts.crossing_levels.empty()) {
        record.append(std::vector<Rupture>{{100 * n, 0.001 * n, n % 5, n % 3 == 0 ? 0.2 : 0.5}});
      }
      if (parts.fields == Fields::record && n % 2 == 0) record.append(field_sample(n));
    }
  }

  static void expect_samples(const Record& record, int count) {
    ASSERT_EQ(record.time.size(), static_cast<std::size_t>(count));
    ASSERT_EQ(record.u_x.rows(), count);
    for (int n = 0; n < count; ++n) {
      const Sample sample = small_sample(kNx, n);
      const auto at = static_cast<std::size_t>(n);
      EXPECT_EQ(record.time[at], sample.time);
      EXPECT_EQ(record.step[at], sample.step);
      EXPECT_EQ(record.F_T[at], sample.F_T);
      EXPECT_EQ(record.x_drive[at], sample.x_drive);
      for (std::size_t i = 0; i < kNx; ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        EXPECT_EQ(record.pinned(n, column), sample.pinned[i]);
        EXPECT_EQ(record.p(n, column), sample.p[i]);
        EXPECT_EQ(record.tau(n, column), sample.tau[i]);
        EXPECT_EQ(record.u_x(n, column), sample.u_x[i]);
      }
    }
  }
};

TEST_F(RecordFile, returns_what_was_appended) {
  auto out = writer("r.h5", 7);
  append(out, 0, 40);
  const std::string checksum = out.finish({}, SumFile::write);
  const Record record = read_record(file("r.h5"));
  expect_samples(record, 40);
  EXPECT_EQ(record.parameters, small_parameters());
  EXPECT_EQ(record.provenance, testing::small_checkpoint().provenance);
  ASSERT_EQ(record.ruptures.size(), 10U);
  EXPECT_EQ(record.ruptures[9], (Rupture{3600, 0.001 * 36, 1}));
  EXPECT_EQ(verify_file(file("r.h5")).checksum, checksum);
  EXPECT_EQ(identify(file("r.h5")), FileKind::record);
  EXPECT_EQ(slurp(file("r.h5.sum")), "content-sha256 " + checksum + "  r.h5\n");
  EXPECT_EQ(names(), (std::vector<std::string>{"r.h5", "r.h5.sum"}));
}

TEST_F(RecordFile, has_the_same_bytes_however_often_it_was_flushed) {
  auto often = writer("a.h5", 1);
  append(often, 0, 100);
  auto rarely = writer("b.h5", 1000);
  append(rarely, 0, 100);
  EXPECT_EQ(often.finish(), rarely.finish());
  EXPECT_EQ(slurp(file("a.h5")), slurp(file("b.h5")));
}

TEST_F(RecordFile, may_be_empty) {
  auto out = writer("r.h5");
  out.finish();
  const Record record = read_record(file("r.h5"));
  EXPECT_TRUE(record.time.empty());
  EXPECT_TRUE(record.ruptures.empty());
  EXPECT_EQ(record.p.cols(), 5);
}

TEST_F(RecordFile, does_not_overwrite_a_file_that_appeared_meanwhile) {
  auto out = writer("r.h5");
  append(out, 0, 3);
  spill(file("r.h5"), "precious");
  expect_contains(message_of<Failure>([&] { out.finish(); }), "exists; give --force to replace it");
  EXPECT_EQ(slurp(file("r.h5")), "precious");
  expect_samples(read_record(file("r.h5.part")), 3);
}

TEST_F(RecordFile, whose_steps_do_not_ascend_is_refused) {
  auto out = writer("r.h5");
  append(out, 0, 4);
  append(out, 2, 4);
  const std::string sentence = file("r.h5.part").string() +
                               ": /series/step holds 300 and then 200; expected ascending steps";
  EXPECT_EQ(message_of<Failure>([&] { out.finish(); }), sentence);
  EXPECT_EQ(message_of<Failure>([&] { read_record(file("r.h5.part")); }), sentence);
  EXPECT_EQ(names(), std::vector<std::string>{"r.h5.part"});
}

TEST_F(RecordFile, that_does_not_begin_where_its_run_did_is_not_completed) {
  auto out = writer("r.h5");
  append(out, 1, 4);
  EXPECT_EQ(message_of<Failure>([&] { out.finish({}, SumFile::omit, 0); }),
            file("r.h5.part").string() + ": it does not begin at step 0, as its run did");
  EXPECT_EQ(names(), std::vector<std::string>{"r.h5.part"});
  out.finish({}, SumFile::omit, 100);
  EXPECT_EQ(read_record(file("r.h5")).step.front(), 100);
}

TEST_F(RecordFile, refuses_nan_at_the_next_flush) {
  auto out = writer("r.h5", 4);
  append(out, 0, 3);
  Sample bad = small_sample(kNx, 3);
  bad.tau[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of<Failure>([&] { out.append(bad); }),
            file("r.h5.part").string() +
                ": /series/tau holds nan at index 17 of [4][5]; only finite numbers are stored");
}

TEST_F(RecordFile, keeps_the_rows_that_did_not_fit_on_the_disk) {
  auto out = writer("r.h5", 4);
  append(out, 0, 3);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit full = {fs::file_size(file("r.h5.part")) + 100, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &full);
  expect_contains(message_of<Failure>([&] { append(out, 3, 4); }), "File too large");
  ::setrlimit(RLIMIT_FSIZE, &before);
  append(out, 4, 8);
  out.finish();
  expect_samples(read_record(file("r.h5")), 8);
}

// --- in the making: what a run that goes on, or was killed, has written so far

TEST_F(RecordFile, in_the_making_is_readable_up_to_its_last_flush) {
  auto out = writer("r.h5", 8);
  expect_samples(read_record(file("r.h5.part")), 0);
  append(out, 0, 20);
  const Record record = read_record(file("r.h5.part"));
  expect_samples(record, 16);
  EXPECT_EQ(identify(file("r.h5.part")), FileKind::open_record);
  EXPECT_FALSE(fs::exists(file("r.h5")));
  out.flush();
  expect_samples(read_record(file("r.h5.part")), 20);
}

TEST_F(RecordFile, in_the_making_ends_before_its_first_damaged_piece) {
  auto out = writer("r.h5", 4);
  append(out, 0, 4);
  const std::size_t intact = fs::file_size(file("r.h5.part"));
  append(out, 4, 12);
  const std::string whole = slurp(file("r.h5.part"));
  for (std::size_t at = intact; at < intact + kHeaderSize + 1000; at += 7) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    spill(file("damaged.part"), damaged);
    expect_samples(read_record(file("damaged.part")), 4);
  }
}

TEST_F(RecordFile, in_the_making_is_refused_if_its_first_piece_is_damaged) {
  auto out = writer("r.h5", 4);
  append(out, 0, 8);
  std::string bytes = slurp(file("r.h5.part"));
  bytes[600] = static_cast<char>(bytes[600] ^ 1);
  spill(file("damaged.part"), bytes);
  EXPECT_EQ(
      message_of<Failure>([&] { read_record(file("damaged.part")); }),
      file("damaged.part").string() + ": the first piece of the unfinished record is damaged");
}

TEST_F(RecordFile, with_pieces_that_do_not_fit_together_is_refused) {
  auto out = writer("r.h5", 4);
  append(out, 0, 4);
  Parameters wider = small_parameters();
  wider.Nx = 6;
  RecordWriter other(file("q.h5"), wider, {}, IfExists::refuse, {}, {}, 4);
  for (int n = 0; n < 4; ++n) other.append(small_sample(6, n));
  spill(file("mixed.part"), slurp(file("r.h5.part")) + slurp(file("q.h5.part")));
  expect_contains(message_of<Failure>([&] { read_record(file("mixed.part")); }),
                  "do not continue those of the previous pieces");
}

TEST_F(RecordFile, has_one_writer_at_a_time) {
  auto out = writer("r.h5", 4);
  append(out, 0, 4);
  expect_contains(message_of<Failure>([&] { writer("r.h5", 4, IfExists::replace); }),
                  "another run is writing " + file("r.h5.part").string());
  expect_samples(read_record(file("r.h5.part")), 4);
}

// --- with crossings of other pinned fractions, and fields

class RecordWithParts : public RecordFile {
 protected:
  const RecordParts crossings = {.crossing_levels = {0.2, 0.5}};
  const RecordParts fields = {.fields = Fields::record};
  const RecordParts both = {{0.2, 0.5}, Fields::record};

  RecordWriter writer_of(const char* name, const RecordParts& parts, const Content& rows = {}) {
    return {file(name), small_parameters(), {}, IfExists::replace, rows, parts, 8};
  }
  std::string write(const char* name, const RecordParts& parts) {
    auto out = writer_of(name, parts);
    append(out, 0, 20, parts);
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
  EXPECT_EQ(message_of<Failure>([&] { ruptures_below(record, 0.4); }),
            "the record has no crossings of a pinned fraction of 0.4, only of 0.2, "
            "0.5, 0.3: record it with --crossings 0.4");
}

TEST_F(RecordWithParts, knows_its_levels_without_any_crossing) {
  auto out = writer_of("r.h5", crossings);
  append(out, 0, 4);
  out.finish();
  EXPECT_TRUE(ruptures_below(read_record(file("r.h5")), 0.5).empty());
}

// 0.55 * 100 is more than 55: earlier builds recorded the crossing when 55 were still pinned.
TEST_F(RecordWithParts, may_have_a_crossing_at_its_level_or_below) {
  Parameters p = small_parameters();
  p.kappa *= static_cast<double>(p.N_s) / 100;  // as stiff
  p.N_s = 100;
  for (const int crossed : {1, 2}) {
    const RecordParts parts = {.crossing_levels = {0.55}};
    RecordWriter out(file("r.h5"), p, {}, IfExists::replace, {}, parts, 8);
    for (const int n : {0, 1, 2}) {
      Sample sample = small_sample(kNx, n);
      sample.pinned.assign(kNx, static_cast<std::uint16_t>(56 - n));
      out.append(sample);
      if (n != crossed) continue;
      for (std::int64_t i = 0; i < static_cast<std::int64_t>(kNx); ++i) {
        out.append(std::vector<Rupture>{{100 * n, 0.001 * n, i, 0.55}});
      }
    }
    out.finish();
    EXPECT_EQ(read_record(file("r.h5")).crossings.size(), kNx);
  }
}

TEST_F(RecordWithParts, returns_fields_and_their_positions) {
  write("r.h5", both);
  const auto [record, content, ignored_bytes] = read_record_file(file("r.h5"));
  EXPECT_EQ(ignored_bytes, 0U);
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
      const Content rows = rows_until(read_file(file("whole.h5")).content, 100 * (kept - 1));
      auto out = writer_of("r.h5", parts, rows);
      const Record part = read_record(file("r.h5.part"));
      expect_samples(part, kept);
      EXPECT_EQ(std::ssize(part.crossings), parts.crossing_levels.empty() ? 0 : kept);
      append(out, kept, 20, parts);
      EXPECT_EQ(out.finish(), checksum) << kept;
    }
  }
}

TEST_F(RecordWithParts, of_large_sliders_are_flushed_by_their_size) {
  Parameters large = small_parameters();
  large.Nx = 401;
  large.L = 4.0;
  large.Nz = 401;
  FieldSample sample{0.0, 0, std::vector<float>(401 * 401), std::vector<float>(401 * 401)};
  RecordWriter out(file("r.h5"), large, {}, IfExists::refuse, {}, {.fields = Fields::record});
  const auto begun = fs::file_size(file("r.h5.part"));
  out.append(sample);
  EXPECT_GT(fs::file_size(file("r.h5.part")), begun + 8 * 401 * 401);
}

TEST_F(RecordWithParts, with_impossible_values_is_refused) {
  auto out = writer_of("r.h5", fields);
  EXPECT_EQ(message_of<Failure>([&] { out.append(small_sample(4, 1)); }),
            "a sample has 4 values of pinned; expected Nx = 5");
  FieldSample bad = field_sample(0);
  bad.u_x.pop_back();
  EXPECT_EQ(message_of<Failure>([&] { out.append(bad); }),
            "a sample has 19 values of u_x; expected Nx Nz = 20");
  auto infinite = writer_of("i.h5", fields);
  bad = field_sample(0);
  bad.u_z[7] = std::numeric_limits<float>::infinity();
  infinite.append(bad);
  expect_contains(message_of<Failure>([&] { infinite.flush(); }),
                  "/fields/u_z holds inf at index 7 of [1][4][5]; only finite numbers are stored");
}

}  // namespace
}  // namespace rupture
