// --resume: an interrupted run goes on and ends with the bits of the uninterrupted one.
//
// Interruptions are imitated here by deleting the files that the run wrote later; tests/crash
// interrupts real processes.
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/checkpoint/verify.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

constexpr const char* kRun =
    "load --config small.ini -o x.h5 --sum --until 6e-4 --checkpoint-every 1e-4 --record r.h5 "
    "--record-every 3e-5";

class Resume : public ToolTest {
 protected:
  /// Deletes a file and its checksum.
  void forget(const std::string& file) const {
    fs::remove(path(file));
    fs::remove(path(file + ".sum"));
  }
  /// Leaves the checkpoints up to 1e-4 n s.
  void interrupt_after(int n) const {
    forget("x.h5");
    for (int m = n + 1; m <= 6; ++m) forget("x-t0.000" + std::to_string(m) + "00000.h5");
  }
  std::string said(const std::string& command) const { return output_of(command + " --resume"); }
};

TEST_F(Resume, gives_the_bits_of_the_uninterrupted_run) {
  output_of(kRun);
  const Files whole = files();
  for (const int n : {5, 2, 1}) {  // 2: in the middle of the rupture
    interrupt_after(n);
    EXPECT_NE(said(kRun).find("resuming from x-t0.000" + std::to_string(n)), std::string::npos);
    for (const char* sum : {"x.h5.sum", "r.h5.sum", "x-t0.000600000.h5.sum"}) {
      EXPECT_EQ(read(sum), whole.at(sum)) << n;
    }
    EXPECT_FALSE(fs::exists(path("r.h5.part")));
  }
}

TEST_F(Resume, gives_the_crossings_of_the_uninterrupted_run) {
  output_of("prepare --config small.ini --set driving.V=0 --tau-bar 0.6 --sigma-bar 0.2 -o p.h5");
  const std::string run =
      "restart p.h5 -o x.h5 --sum --until 1e-4 --checkpoint-every 2e-5 --record r.h5 "
      "--record-every 3e-5 --crossings 0.2,0.7";
  output_of(run);
  const std::string whole = read("r.h5.sum");
  for (const std::size_t lost : {1U, 2U, 3U}) {  // all but the first amid the rupture
    forget("x.h5");
    const char* const later[] = {"x-t0.000100000.h5", "x-t0.000080000.h5", "x-t0.000060000.h5"};
    for (std::size_t n = 0; n < lost; ++n) forget(later[n]);
    EXPECT_NE(said(run).find("resuming from"), std::string::npos);
    EXPECT_EQ(read("r.h5.sum"), whole) << lost;
  }
}

TEST_F(Resume, gives_the_fields_of_the_uninterrupted_run) {
  const std::string run = std::string(kRun) + " --fields 4.01e-5";  // 200.5 steps
  output_of(run);
  const std::string whole = read("r.h5.sum");
  for (const int n : {5, 2, 1}) {
    interrupt_after(n);
    EXPECT_NE(said(run).find("resuming from"), std::string::npos);
    EXPECT_EQ(read("r.h5.sum"), whole) << n;
  }
  EXPECT_EQ(said(run), "x.h5 is complete\n");
}

TEST_F(Resume, begins_where_there_is_nothing_to_resume) {
  EXPECT_NE(said(kRun).find("nothing to resume"), std::string::npos);
  const std::string resumed = read("x.h5.sum");
  output_of(std::string(kRun) + " --force");
  EXPECT_EQ(read("x.h5.sum"), resumed);
}

TEST_F(Resume, of_a_complete_run_does_nothing) {
  output_of(kRun);
  const Files before = files();
  EXPECT_EQ(said(kRun), "x.h5 is complete\n");
  EXPECT_EQ(said(std::string(kRun) + " --threads 2"), "x.h5 is complete\n");
  EXPECT_TRUE(files() == before);
}

TEST_F(Resume, SLOW_quiet_run_ends_where_the_uninterrupted_one_ends) {
  output_of("load --config small.ini -o begin.h5 --until 1e-4");
  const std::string run =
      "restart begin.h5 -o x.h5 --sum --until-quiet 1e-4 --checkpoint-every 1e-4 --set driving.V=0";
  output_of(run);
  const std::string whole = read("x.h5.sum");
  for (const int n : {3, 2}) {
    interrupt_after(n);
    said(run);
    EXPECT_EQ(read("x.h5.sum"), whole) << n;
  }
  EXPECT_EQ(said(run), "x.h5 is complete\n");
  output_of(run + " --record r.h5 --record-every 3e-5 --force");  // its last sample is at its end
  EXPECT_EQ(said(run + " --record r.h5 --record-every 3e-5"), "x.h5 is complete\n");
  for (const char* other : {" --until-quiet 9e-5", " --until-quiet 1e-4 --arrived-below 0.2"}) {
    const std::string start = run.substr(0, run.find(" --until-quiet"));
    expect_refusal(start + " --set driving.V=0 --resume" + other, kFailed,
                   "x.h5 exists; give --force to replace it");
  }
}

TEST_F(Resume, run_until_an_event_spans_ends_where_the_uninterrupted_one_ends) {
  output_of("load --config small.ini -o begin.h5 --until 1e-4");
  const std::string run = "restart begin.h5 -o x.h5 --sum --until-quiet --checkpoint-at 2.4e-4";
  output_of(run);
  const std::string whole = read("x.h5.sum");
  forget("x.h5");
  const std::string text = said(run);  // the last two of the nine blocks are still to rupture
  EXPECT_NE(text.find("resuming from x-t0.000240000.h5"), std::string::npos) << text;
  EXPECT_EQ(read("x.h5.sum"), whole);
}

TEST_F(Resume, for_counts_from_the_beginning_of_the_run) {
  output_of("load --config small.ini -o begin.h5 --until 1e-4");
  const std::string run = "restart begin.h5 -o x.h5 --sum --for 5e-4 --checkpoint-every 1e-4";
  output_of(run);
  const std::string whole = read("x.h5.sum");
  interrupt_after(3);
  said(run);
  EXPECT_EQ(read("x.h5.sum"), whole);
}

TEST_F(Resume, uses_no_checkpoint_of_another_run) {
  output_of(kRun);
  interrupt_after(3);
  const std::string other = "load --config small.ini -o x.h5 --until 6e-4 --seed 7 --resume";
  EXPECT_NE(output_of(other).find("nothing to resume"), std::string::npos);
  output_of("load --config small.ini -o y.h5 --until 6e-4 --seed 7");
  EXPECT_EQ(checksum_of("x.h5"), checksum_of("y.h5"));
}

TEST_F(Resume, uses_no_modified_checkpoint) {
  output_of(kRun);
  interrupt_after(2);
  output_of("modify-phi x-t0.000200000.h5 -o changed.h5 --sigma-bar 0.05");
  forget("x-t0.000200000.h5");
  fs::rename(path("changed.h5"), path("x-t0.000200000.h5"));
  const std::string run = kRun;
  EXPECT_NE(said(run + " --force").find("resuming from x-t0.000100000"), std::string::npos);
}

TEST_F(Resume, passes_over_a_damaged_checkpoint_and_says_so) {
  output_of(kRun);
  const std::string whole = read("x.h5.sum");
  interrupt_after(3);
  write("x-t0.000300000.h5", read("x-t0.000300000.h5").substr(0, 5000));
  const Outcome outcome = run(std::string(kRun) + " --resume");
  EXPECT_EQ(outcome.exit_code, kDone) << outcome.err;
  EXPECT_NE(outcome.err.find("not used to resume: x-t0.000300000.h5 is truncated"),
            std::string::npos);
  EXPECT_EQ(lines_of(outcome.err).size(), 1U) << "each file is read once: " << outcome.err;
  EXPECT_NE(outcome.out.find("resuming from x-t0.000200000.h5"), std::string::npos);
  EXPECT_EQ(read("x.h5.sum"), whole);
}

TEST_F(Resume, replaces_no_checkpoint_on_the_way_that_is_none_of_the_run) {
  output_of(kRun);
  interrupt_after(3);
  write("x-t0.000500000.h5", "precious");
  const Outcome outcome = run(std::string(kRun) + " --resume");
  EXPECT_EQ(outcome.exit_code, kFailed);
  EXPECT_NE(outcome.err.find("x-t0.000500000.h5 exists; give --force"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(read("x-t0.000500000.h5"), "precious");
}

TEST_F(Resume, goes_back_to_where_the_record_reaches) {
  output_of(kRun);
  const std::string whole = read("r.h5.sum");
  interrupt_after(4);
  const std::string shorter =
      "load --config small.ini -o y.h5 --until 2.5e-4 --record r.h5 --record-every 3e-5 --force "
      "--sum";
  output_of(shorter);
  const Outcome outcome = run(std::string(kRun) + " --resume");
  EXPECT_EQ(outcome.exit_code, kDone) << outcome.err;
  EXPECT_NE(outcome.out.find("resuming from x-t0.000200000"), std::string::npos);
  EXPECT_NE(outcome.err.find("x-t0.000400000.h5, which the record does not reach"),
            std::string::npos);
  EXPECT_EQ(read("r.h5.sum"), whole);
}

TEST_F(Resume, refuses_the_record_of_another_interval_run_end_or_choice) {
  const std::string sentence =
      " is not what the run to be resumed has recorded, but the record of another run, interval, "
      "end or choice of --crossings or --fields; move it away, give another --record, or --force "
      "to "
      "replace it";
  output_of(kRun);
  interrupt_after(3);
  const std::string load = "load --config small.ini -o x.h5 --resume --record r.h5 ";
  expect_refusal(load + "--until 6e-4 --record-every 4e-5", kFailed, "r.h5" + sentence);
  expect_refusal(load + "--until 3e-4 --record-every 3e-5", kFailed, "r.h5" + sentence);
  expect_refusal(load + "--until 6e-4 --record-every 3e-5 --crossings 0.5", kFailed,
                 "r.h5" + sentence);
  expect_refusal(load + "--until 6e-4 --record-every 3e-5 --fields 1e-4", kFailed,
                 "r.h5" + sentence);
  const std::string other = load + "--until 6e-4 --record-every 3e-5 --seed 7";
  expect_refusal(other, kFailed, "r.h5" + sentence);
  EXPECT_EQ(run(other + " --force").exit_code, kDone);
}

TEST_F(Resume, refuses_a_record_with_fields_of_another_interval) {
  output_of(std::string(kRun) + " --fields 4e-5");
  interrupt_after(3);
  for (const char* other : {"", " --fields 5e-5"}) {
    expect_refusal_with(std::string(kRun) + other + " --resume", kFailed,
                        "choice of --crossings or --fields");
  }
}

TEST_F(Resume, never_replaces_what_is_no_record) {
  write("notes.txt", "precious");
  expect_refusal_with("load --config small.ini -o x.h5 --resume --record notes.txt", kFailed,
                      "notes.txt is not a rupture file");
}

TEST_F(Resume, goes_not_beyond_the_end_that_is_asked_for) {
  output_of("load --config small.ini -o short.h5 --until 2.5e-4");
  const std::string all = "load --config small.ini -o x.h5 --checkpoint-every 1e-4 --until ";
  output_of(all + "6e-4");
  expect_refusal(all + "2.5e-4 --resume", kFailed, "x.h5 exists; give --force to replace it");
  forget("x.h5");
  EXPECT_NE(said(all + "2.5e-4").find("resuming from x-t0.000200000.h5"), std::string::npos);
  EXPECT_EQ(checksum_of("x.h5"), checksum_of("short.h5"));
}

TEST_F(Resume, SLOW_uses_no_checkpoint_behind_the_end_of_a_quiet_run) {
  output_of("load --config small.ini -o begin.h5 --until 1e-4");
  const std::string run =
      "restart begin.h5 -o x.h5 --sum --checkpoint-every 1e-4 --set driving.V=0";
  output_of(run + " --until-quiet 1e-4 --force");
  const std::string whole = read("x.h5.sum");
  output_of(run + " --until 8e-4 --force");
  expect_refusal(run + " --until-quiet 1e-4 --resume", kFailed,
                 "x.h5 exists; give --force to replace it");
  forget("x.h5");
  said(run + " --until-quiet 1e-4");
  EXPECT_EQ(read("x.h5.sum"), whole);
}

TEST_F(Resume, uses_no_checkpoint_that_follows_a_modified_one) {
  output_of("load --config small.ini -o begin.h5");
  output_of("modify-phi begin.h5 -o changed.h5 --shape bell");
  output_of("restart changed.h5 -o x.h5 --until 6e-4 --checkpoint-at 3e-4");
  const std::string load = "load --config small.ini -o x.h5 --until 6e-4 --resume";
  expect_refusal(load, kFailed, "x.h5 exists; give --force to replace it");
  forget("x.h5");
  EXPECT_NE(output_of(load).find("nothing to resume"), std::string::npos);
}

TEST_F(Resume, finds_checkpoints_of_an_output_without_extension) {
  const std::string load = "load --config small.ini -o x --until 6e-4 --checkpoint-at 3e-4";
  output_of(load);
  forget("x");
  EXPECT_NE(said(load).find("resuming from x-t0.000300000"), std::string::npos);
}

TEST_F(Resume, writes_the_sums_that_are_missing_where_they_are_asked_for) {
  const std::string without =
      "load --config small.ini -o x.h5 --until 3e-4 --checkpoint-every 1e-4 --record r.h5";
  output_of(without);
  const auto missing = [&] {
    std::vector<std::string> names;
    for (const auto& [name, bytes] : files()) {
      if (name.ends_with(".h5") && !fs::exists(path(name + ".sum"))) names.push_back(name);
    }
    return names;
  };
  EXPECT_EQ(said(without), "x.h5 is complete\n");
  EXPECT_EQ(missing().size(), 5U);
  EXPECT_EQ(said(without + " --sum"), "x.h5 is complete\n");
  EXPECT_TRUE(missing().empty());
  for (const char* file : {"x.h5", "x-t0.000300000.h5"}) forget(file);
  for (const char* n : {"1", "2"}) fs::remove(path("x-t0.000" + std::string(n) + "00000.h5.sum"));
  said(without + " --sum");
  EXPECT_TRUE(missing().empty());
  EXPECT_EQ(read("x.h5.sum"), sum_line("x.h5"));
}

/// Names in which a search for words of commands would find some.
class ResumeNamed : public Resume, public ::testing::WithParamInterface<const char*> {
 protected:
  Outcome run_quietly(std::vector<std::string> more) const {
    std::vector<std::string> words = {
        "restart", "begin.h5",    "--until-quiet",      "1e-4", "--for", "1e-3",
        "--set",   "driving.V=0", "--checkpoint-every", "1e-4"};
    words.insert(words.end(), {"-o", name(), "--record", GetParam() + std::string("-r.h5")});
    words.insert(words.end(), more.begin(), more.end());
    return run_words(words);
  }
  static std::string name() { return GetParam() + std::string(".h5"); }
};

TEST_P(ResumeNamed, run_is_complete_and_goes_on) {
  output_of("load --config small.ini -o begin.h5 --until 1e-4");
  EXPECT_EQ(run_quietly({}).exit_code, kDone);
  const std::string whole = run_words({"analyze", "checksum", name()}).out;
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--resume"}, {"--resume", "--sum", "--force", "-q"}}) {
    const Outcome again = run_quietly(more);
    EXPECT_EQ(again.err, "");
    EXPECT_EQ(again.out, more.size() == 1 ? name() + " is complete\n" : "");
  }
  fs::remove(path(name()));
  const Outcome resumed = run_quietly({"--resume"});
  EXPECT_TRUE(resumed.out.starts_with("resuming from ")) << resumed.out << resumed.err;
  EXPECT_EQ(run_words({"analyze", "checksum", name()}).out, whole);
  EXPECT_EQ(run_quietly({"--resume"}).out, name() + " is complete\n") << "a resumed run is, too";
}

INSTANTIATE_TEST_SUITE_P(Awkwardly, ResumeNamed,
                         ::testing::Values("x --resume", "x -- y", "restart --until 1", "it's"),
                         [](const auto& test) {
                           return std::string("name") + std::to_string(test.index);
                         });

TEST_F(Resume, knows_its_checkpoints_by_their_id) {
  output_of(kRun);
  interrupt_after(3);
  Checkpoint foreign = read_checkpoint(path("x-t0.000300000.h5"));
  EXPECT_EQ(foreign.run->id.size(), 64U);
  EXPECT_EQ(foreign.run->id, read_checkpoint(path("x-t0.000100000.h5")).run->id);
  foreign.run->id = std::string(64, '0');
  write_checkpoint(path("x-t0.000300000.h5"), foreign, IfExists::replace);
  EXPECT_NE(said(std::string(kRun) + " --force").find("resuming from x-t0.000200000"),
            std::string::npos);
}

TEST_F(Resume, knows_its_record_by_the_id_of_the_run_and_the_intervals) {
  output_of(std::string(kRun) + " --fields 1e-4");
  const std::string id = read_checkpoint(path("x.h5")).run->id;
  EXPECT_EQ(read_record(path("r.h5")).run, (RecordedRun{id, 3e-5, 1e-4}));
  EditedFile edited;
  edited.kind = FileKind::record;
  edited.content = read_content(path("r.h5"));
  EXPECT_FALSE(checked_content(edited, {}).contains("/run/id")) << "it is not the run's any more";
}

TEST_F(Resume, of_a_command_whose_configuration_has_another_end_is_not_complete) {
  const std::string slider = read("small.ini");
  write("run.ini", "until = 2e-4\n" + slider);
  output_of("load --config run.ini -o x.h5");
  write("run.ini", "until = 3e-4\n" + slider);
  expect_refusal("load --config run.ini -o x.h5 --resume", kFailed,
                 "x.h5 exists; give --force to replace it");
}

}  // namespace
}  // namespace rupture::testing
