// Records: their series, those in the making, and what they may hold besides (crossings of other
// pinned fractions, and fields). tests/tools/tables/resume.txt continues them.
#include "rupture/checkpoint/record.hpp"

#include <limits>

#include "fixtures.hpp"

namespace rupture::testing {

/// Small ones, of which every number is known.
class RecordFile : public InFolder {
 protected:
  static constexpr std::size_t kNx = 5;  // of small_parameters()

  RecordWriter writer(const char* name, std::size_t flush_every = 256) {
    return {file(name), small_parameters(), small_checkpoint().provenance, IfExists::refuse, {},
            {},         flush_every};
  }

  static void append(RecordWriter& record, int from, int to) {
    for (int n = from; n < to; ++n) {
      record.append(small_sample(kNx, n));
      if (n % 4 == 0) record.append(std::vector<Rupture>{{100 * n, 0.001 * n, n % 5}});
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
      const auto row = [&](const auto& series) {
        return std::vector(series.row(n).begin(), series.row(n).end());
      };
      EXPECT_EQ(row(record.pinned), sample.pinned);
      EXPECT_EQ(row(record.p), sample.p);
      EXPECT_EQ(row(record.tau), sample.tau);
      EXPECT_EQ(row(record.u_x), sample.u_x);
    }
  }
};

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
  EXPECT_EQ(message_of<Failure>([&] { out.finish({}, 0); }),
            file("r.h5.part").string() + ": it does not begin at step 0, as its run did");
  EXPECT_EQ(names(), std::vector<std::string>{"r.h5.part"});
  out.finish({}, 100);
  EXPECT_EQ(read_record(file("r.h5")).step.front(), 100);
}

// --- in the making: what a run that goes on, or was killed, has written so far

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

// --- with crossings of other pinned fractions, and fields

class RecordWithParts : public RecordFile {};

// 0.55 * 100 is more than 55: earlier builds recorded the crossing when 55 were still pinned.
TEST_F(RecordWithParts, may_have_a_crossing_at_its_level_or_below) {
  Parameters p = small_parameters();
  p.kappa = p.kappa[0] * static_cast<double>(p.N_s) / 100;  // as stiff
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

// What is held is more than the memory that there is for it.
TEST_F(RecordWithParts, has_held_samples_if_their_event_spans) {
  const RecordParts parts = {.run = {.id = "r", .every_in_spanning_events = 1e-3}};
  Parameters wide = small_parameters();
  wide.Nx = 401;
  wide.L = 4.0;
  wide.M *= 100;
  constexpr int many = 4000;
  for (const std::int64_t last : {399, 400}) {
    RecordWriter out(file("r.h5"), wide, {}, IfExists::replace, {}, parts);
    out.append(small_sample(401, 0));
    for (std::int64_t i = 100; i <= last; ++i) {
      out.append(std::vector<Rupture>{{100 * i, 0.001 * static_cast<double>(i), i}});
    }
    const auto begun = fs::file_size(file("r.h5.part"));
    for (int n = 401; n < many; ++n) out.hold(small_sample(401, n));
    EXPECT_GT(fs::file_size(file("r.h5.part")), begun + RecordWriter::kMostHeld);
    out.append(small_sample(401, many));
    out.finish();
    EXPECT_EQ(read_record(file("r.h5")).step.size(), last == 400 ? many - 399U : 2U);
  }
}

TEST_F(RecordWithParts, with_impossible_values_is_refused) {
  const RecordParts fields = {.fields = Fields::record};
  RecordWriter out(file("r.h5"), small_parameters(), {}, IfExists::refuse, {}, fields);
  EXPECT_EQ(message_of<Failure>([&] { out.append(small_sample(4, 1)); }),
            "a sample has 4 values of pinned; expected Nx = 5");
  const std::vector<float> zeros(20);
  EXPECT_EQ(message_of<Failure>([&] {
              out.append(FieldSample{0.0, 0, {0.0F}, zeros});
            }),
            "a sample has 1 values of u_x; expected Nx Nz = 20");
  RecordWriter infinite(file("i.h5"), small_parameters(), {}, IfExists::refuse, {}, fields);
  FieldSample bad = {0.0, 0, zeros, zeros};
  bad.u_z[7] = std::numeric_limits<float>::infinity();
  infinite.append(bad);
  expect_contains(message_of<Failure>([&] { infinite.flush(); }),
                  "/fields/u_z holds inf at index 7 of [1][4][5]; only finite numbers are stored");
}

}  // namespace rupture::testing
