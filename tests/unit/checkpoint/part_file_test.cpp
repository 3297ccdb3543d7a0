// Records in the making: what a run that goes on, or was killed, has written so far.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

#include "record_fixture.hpp"
#include "rupture/checkpoint/file.hpp"

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

TEST_F(RecordFile, of_a_run_killed_at_any_moment_is_readable) {
  for (int trial = 0; trial < 20; ++trial) {
    fs::remove(file("r.h5.part"));
    const pid_t child = fork();
    if (child == 0) {
      auto out = writer("r.h5", 4, IfExists::replace);  // is nearly always within a flush
      for (int n = 0;; ++n) append(out, n, n + 1);
    }
    const auto not_yet_begun = [&] {
      return failure_of([&] { identify(file("r.h5.part")); }) != "(no failure)";
    };
    for (int n = 0; n < 40000 && not_yet_begun(); ++n) usleep(500);
    ASSERT_FALSE(not_yet_begun()) << "the writer has not begun within 20 s";
    usleep(static_cast<useconds_t>(10000 + 700 * trial));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const Record record = read_record(file("r.h5.part"));
    expect_samples(record, static_cast<int>(record.time.size()));
  }
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
                  "do not continue those of the pieces before");
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
