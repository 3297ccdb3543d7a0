#include "rupture/checkpoint/record.hpp"

#include <limits>
#include <tuple>

#include "record_fixture.hpp"
#include "rupture/checkpoint/checksum.hpp"

namespace rupture {
namespace {

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
  content["/series/x"] =
      make_array(std::span<const double>(std::array{0.0, 0.1, 0.2, 0.3, 0.4}), {5}, "m");
  write_content(file("q.h5"), FileKind::record, content, IfExists::replace);
  expect_contains(failure_of([&] { read_record(file("q.h5")); }),
                  "/series/x holds its value in a form that rupture never writes");
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

TEST_F(RecordFile, that_begins_with_the_rows_of_another_continues_it) {
  auto whole = writer("whole.h5", 8);
  append(whole, 0, 20);
  const std::string checksum = whole.finish();
  for (const int kept : {0, 1, 8, 13}) {
    const Content rows = rows_until(read_content(file("whole.h5")), 100 * kept - 1);
    auto out = RecordWriter(file("r.h5"), small_parameters(), {}, IfExists::replace, rows, 8);
    expect_samples(read_record(file("r.h5.part")), kept);
    append(out, kept, 20);
    EXPECT_EQ(out.finish(), checksum) << kept;
  }
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

TEST_F(RecordFile, and_checkpoint_are_not_mistaken_for_each_other) {
  auto out = writer("r.h5");
  append(out, 0, 3);
  EXPECT_EQ(failure_of([&] { read_checkpoint(file("r.h5.part")); }),
            file("r.h5.part").string() + " is an unfinished record; expected a checkpoint");
  out.finish();
  write_checkpoint(file("x.h5"), testing::small_checkpoint(), IfExists::refuse);
  EXPECT_EQ(failure_of([&] { read_checkpoint(file("r.h5")); }),
            file("r.h5").string() + " is a record; expected a checkpoint");
  EXPECT_EQ(failure_of([&] { read_record(file("x.h5")); }),
            file("x.h5").string() + " is a checkpoint; expected a record");
}

TEST_F(RecordFile, with_impossible_datasets_is_refused) {
  auto out = writer("r.h5");
  append(out, 0, 5);
  out.finish();
  const auto refusal_after = [&](const auto& change) {
    Content content = read_content(file("r.h5"));
    change(content);
    write_content(file("q.h5"), FileKind::record, content, IfExists::replace);
    return failure_of([&] { read_record(file("q.h5")); });
  };
  expect_contains(refusal_after([](Content& c) { c.erase("/series/p"); }),
                  "q.h5: /series/p is missing; expected float64 of shape [5][5]");
  expect_contains(refusal_after([](Content& c) { c["/series/q"] = make_text(""); }),
                  "/series/q is not part of a record: use a newer rupture");
}

// Five samples with small_parameters(), a rupture at the first and one at the last step.
TEST_F(RecordFile, that_contradicts_itself_is_refused) {
  RecordWriter out(file("r.h5"), small_parameters(), {}, IfExists::refuse, {}, 8,
                   {.crossing_levels = {0.2, 0.5}});
  append(out, 0, 5);
  out.append(std::vector<Rupture>{{300, 0.003, 1, 0.5}});
  out.finish();
  const auto refusal_with = [&](const char* path, const Dataset& other) {
    Content content = read_content(file("r.h5"));
    content.at(path) = other;
    write_content(file("q.h5"), FileKind::record, content, IfExists::replace);
    return failure_of([&] { read_record(file("q.h5")); });
  };
  const auto array = [](auto values, const char* unit = "1") {
    return make_array(std::span<const typename decltype(values)::value_type>(values),
                      {values.size()}, unit);
  };
  using Reals = std::vector<double>;
  using Integers = std::vector<std::int64_t>;
  using Counts = std::vector<std::uint16_t>;
  const auto counts = [](std::uint16_t all, std::uint16_t at_last) {
    Counts pinned(25, all);
    pinned[23] = at_last;
    return make_array(std::span<const std::uint16_t>(pinned), {5, 5}, "1");
  };
  const std::vector<std::tuple<const char*, Dataset, const char*>> cases = {
      {"/series/time", array(Reals{0, 1, 2, 3, 4}, "ms"), "has the unit 'ms'; expected 's'"},
      {"/series/time", array(Reals{0, 0.001, 0.002, 0.003, 0.00401}, "s"),
       "/series/time holds 0.00401 at step 400; by the parameters it is 0.004 there"},
      {"/series/x_drive", array(Reals{0, 1e-6, 2e-6, 0, 4e-6}, "m"), "x_drive holds 0 at step 300"},
      {"/series/pinned", counts(3, 4), "/series/pinned holds 4; expected 3 at most"},
      {"/series/pinned", counts(2, 1),
       "/crossings/ lacks block 3, whose pinned fraction falls below 0.5 by step 400"},
      {"/series/pinned", counts(1, 0), "/ruptures/ lacks block 3, whose pinned"},
      {"/ruptures/block", array(Integers{0, 5}),
       "holds 5 at index 1; expected a block from 0 to 4"},
      {"/ruptures/step", array(Integers{400, 0}), "/ruptures/step holds 0 after 400, for block 4"},
      {"/ruptures/step", array(Integers{-1, 400}), "/ruptures/step holds -1 after 0, for block 0"},
      {"/ruptures/time", array(Reals{0, 0.003}, "s"), "/ruptures/time holds 0.003 at step 400"},
      {"/crossings/levels", array(Reals{0.5, 0.5}), "/crossings/levels holds 0.5, 0.5; expected"},
      {"/crossings/levels", array(Reals{0.3, 0.5}), "/crossings/levels holds 0.3, 0.5; expected"},
      {"/crossings/levels", array(Reals{0.5, 1.5}), "/crossings/levels holds 0.5, 1.5; expected"},
      {"/crossings/pinned_below", array(Reals{0.4}), "/crossings/pinned_below holds 0.4; expected"},
  };
  for (const auto& [path, other, sentence] : cases) {
    expect_contains(refusal_with(path, other), sentence);
  }
}

}  // namespace
}  // namespace rupture
