#include "rupture/checkpoint/record.hpp"

#include <algorithm>
#include <limits>

#include "record_fixture.hpp"
#include "rupture/checkpoint/checksum.hpp"

namespace rupture {
namespace {

namespace fs = std::filesystem;
using testing::expect_contains;
using testing::failure_of;
using testing::RecordFile;
using testing::slurp;
using testing::small_parameters;
using testing::small_sample;
using testing::spill;

TEST_F(RecordFile, returns_what_was_appended) {
  auto out = writer("r.h5", 7);
  append(out, 0, 40);
  const std::string checksum = out.finish({}, SumFile::write);
  const Record record = read_record(file("r.h5"));
  expect_samples(record, 40);
  EXPECT_EQ(record.complete, Complete::yes);
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
  append(often, 0, 20);
  auto rarely = writer("b.h5", 1000);
  append(rarely, 0, 20);
  EXPECT_EQ(often.finish(), rarely.finish());
  EXPECT_EQ(slurp(file("a.h5")), slurp(file("b.h5")));
}

TEST_F(RecordFile, says_where_the_blocks_are_outside_its_checksum) {
  auto out = writer("r.h5");
  append(out, 0, 3);
  out.finish();
  Content content = read_content(file("r.h5"));
  EXPECT_EQ(read_array<double>(content, "/series/x", {5}),
            (std::vector<double>{0, 0.01, 0.02, 0.03, 0.04}));
  const std::string checksum = content_checksum(content);
  content.erase("/series/x");  // as earlier builds wrote records
  EXPECT_EQ(write_content(file("q.h5"), FileKind::record, content, IfExists::refuse), checksum);
  expect_samples(read_record(file("q.h5")), 3);
}

TEST_F(RecordFile, grows_over_many_chunks) {
  auto out = writer("r.h5");
  append(out, 0, 20000);
  out.finish();
  const Record record = read_record(file("r.h5"));
  ASSERT_EQ(record.time.size(), 20000U);
  EXPECT_EQ(record.p(19999, 4), 19999 + 0.25);
  EXPECT_EQ(record.ruptures.size(), 5000U);
}

TEST_F(RecordFile, may_be_empty) {
  auto out = writer("r.h5");
  out.finish();
  const Record record = read_record(file("r.h5"));
  EXPECT_TRUE(record.time.empty());
  EXPECT_TRUE(record.ruptures.empty());
  EXPECT_EQ(record.p.cols(), 5);
}

TEST_F(RecordFile, is_not_started_where_it_could_not_be_finished) {
  spill(file("r.h5"), "precious");
  EXPECT_EQ(failure_of([&] { writer("r.h5"); }),
            file("r.h5").string() + " exists; give --force to replace it");
  spill(file("q.h5.part"), "precious");
  EXPECT_EQ(failure_of([&] { writer("q.h5"); }),
            file("q.h5.part").string() + " exists; give --force to replace it");
  auto forced = writer("r.h5", 256, IfExists::replace);
  EXPECT_EQ(slurp(file("r.h5")), "precious");
  forced.finish();
  EXPECT_TRUE(read_record(file("r.h5")).time.empty());
}

TEST_F(RecordFile, does_not_overwrite_a_file_that_appeared_meanwhile) {
  auto out = writer("r.h5");
  append(out, 0, 3);
  spill(file("r.h5"), "precious");
  expect_contains(failure_of([&] { out.finish(); }), "exists; give --force to replace it");
  EXPECT_EQ(slurp(file("r.h5")), "precious");
  expect_samples(read_record(file("r.h5.part")), 3);
}

TEST_F(RecordFile, whose_steps_do_not_ascend_is_refused) {
  auto out = writer("r.h5");
  append(out, 0, 4);
  append(out, 2, 4);
  const std::string sentence = file("r.h5.part").string() +
                               ": /series/step holds 300 and then 200; expected ascending steps";
  EXPECT_EQ(failure_of([&] { out.finish(); }), sentence);
  EXPECT_EQ(failure_of([&] { read_record(file("r.h5.part")); }), sentence);
  EXPECT_EQ(names(), std::vector<std::string>{"r.h5.part"});
}

TEST_F(RecordFile, that_does_not_begin_where_its_run_did_is_not_completed) {
  auto out = writer("r.h5");
  append(out, 1, 4);
  EXPECT_EQ(failure_of([&] { out.finish({}, SumFile::omit, 0); }),
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
  EXPECT_EQ(failure_of([&] { out.append(bad); }),
            file("r.h5.part").string() +
                ": /series/tau holds nan at index 17 of [4][5]; only finite numbers are stored");
}

TEST_F(RecordFile, refuses_samples_of_the_wrong_length_and_too_many_junctions) {
  auto out = writer("r.h5");
  EXPECT_EQ(failure_of([&] { out.append(small_sample(4, 1)); }),
            "a sample has 4 values of pinned; expected Nx = 5");
  Parameters many = small_parameters();
  many.N_s = 65536;
  EXPECT_THROW(RecordWriter(file("q.h5"), many, {}, IfExists::refuse), UsageError);
}

// --- in the making: what a run that goes on, or was killed, has written so far

TEST_F(RecordFile, in_the_making_is_readable_up_to_its_last_flush) {
  auto out = writer("r.h5", 8);
  expect_samples(read_record(file("r.h5.part")), 0);
  append(out, 0, 20);
  const Record record = read_record(file("r.h5.part"));
  expect_samples(record, 16);
  EXPECT_EQ(record.complete, Complete::no);
  EXPECT_EQ(identify(file("r.h5.part")), FileKind::open_record);
  EXPECT_FALSE(fs::exists(file("r.h5")));
  out.flush();
  expect_samples(read_record(file("r.h5.part")), 20);
}

TEST_F(RecordFile, interrupted_stays_behind_as_a_part_that_cannot_be_verified) {
  {
    auto out = writer("r.h5", 8);
    append(out, 0, 20);
  }
  EXPECT_EQ(names(), std::vector<std::string>{"r.h5.part"});
  expect_samples(read_record(file("r.h5.part")), 16);
  expect_contains(failure_of([&] { verify_file(file("r.h5.part")); }),
                  "r.h5.part: an unfinished record cannot be verified");
  EXPECT_EQ(failure_of([&] { read_checkpoint(file("r.h5.part")); }),
            file("r.h5.part").string() + " is an unfinished record; expected a checkpoint");
}

TEST_F(RecordFile, SLOW_in_the_making_ends_with_its_last_whole_piece) {
  auto out = writer("r.h5", 4);
  std::vector<std::size_t> sizes;
  for (int n = 0; n <= 12; n += 4) {
    append(out, n, n + 4);
    sizes.push_back(fs::file_size(file("r.h5.part")));
  }
  const std::string whole = slurp(file("r.h5.part"));
  for (std::size_t size = sizes[0]; size < whole.size(); size += 37) {
    spill(file("cut.part"), whole.substr(0, size));
    const auto pieces = std::upper_bound(sizes.begin(), sizes.end(), size) - sizes.begin();
    expect_samples(read_record(file("cut.part")), static_cast<int>(4 * pieces));
  }
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
      failure_of([&] { read_record(file("damaged.part")); }),
      file("damaged.part").string() + ": the first piece of the unfinished record is damaged");
}

TEST_F(RecordFile, with_pieces_that_do_not_fit_together_is_refused) {
  auto out = writer("r.h5", 4);
  append(out, 0, 4);
  Parameters wider = small_parameters();
  wider.Nx = 6;
  RecordWriter other(file("q.h5"), wider, {}, IfExists::refuse, {}, 4);
  for (int n = 0; n < 4; ++n) other.append(small_sample(6, n));
  spill(file("mixed.part"), slurp(file("r.h5.part")) + slurp(file("q.h5.part")));
  expect_contains(failure_of([&] { read_record(file("mixed.part")); }),
                  "do not continue those of the previous pieces");
}

TEST_F(RecordFile, has_one_writer_at_a_time) {
  auto out = writer("r.h5", 4);
  append(out, 0, 4);
  expect_contains(failure_of([&] { writer("r.h5", 4, IfExists::replace); }),
                  "another run is writing " + file("r.h5.part").string());
  expect_samples(read_record(file("r.h5.part")), 4);
}

}  // namespace
}  // namespace rupture
