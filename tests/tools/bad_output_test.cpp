// Outputs that cannot be written: one sentence, exit code 1 or 2, nothing half written.
#include <unistd.h>

#include "tool_test.hpp"

namespace rupture::testing {
namespace {

class BadOutput : public ToolTest {
 protected:
  BadOutput() { output_of("load --config small.ini -o a.h5 -q"); }

  /// Expects `sentence` from each tool that writes, with the output `file`.
  void expect_refused(const std::string& file, ExitCode code, const std::string& sentence) const {
    expect_refusal("load --config small.ini --until 1e-4 -o " + file, code, sentence);
    expect_refusal("restart a.h5 --for 1e-4 -o " + file, code, sentence);
    expect_refusal("modify-phi a.h5 -o " + file, code, sentence);
    expect_refusal("load --config small.ini --until 1e-4 -o b.h5 --record " + file, code, sentence);
  }
};

TEST_F(BadOutput, missing_folder) {
  expect_refused("gone/b.h5", kFailed,
                 "could not write gone/b.h5: its folder gone: No such file or directory; give "
                 "another path");
}

TEST_F(BadOutput, folder_itself) {
  fs::create_directory(path("folder"));
  expect_refused("folder", kFailed, "folder is a folder; give the path of a file to write");
}

TEST_F(BadOutput, below_a_file) {
  expect_refused("small.ini/b.h5", kFailed,
                 "could not write small.ini/b.h5: its folder small.ini: Not a directory; give "
                 "another path");
}

TEST_F(BadOutput, below_proc_refuses_before_the_run) {
  const Outcome outcome = run("load --config small.ini --until 1e-4 -o /proc/b.h5");
  EXPECT_EQ(outcome.exit_code, kFailed);
  expect_one_sentence(outcome.err, "load", "could not write /proc/b.h5");
}

TEST_F(BadOutput, empty_name) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"load", "--config", "small.ini", "-o", ""},
        {"restart", "a.h5", "--for", "1e-5", "-o", ""},
        {"modify-phi", "a.h5", "-o", ""},
        {"load", "--config", "small.ini", "-o", "b.h5", "--record", ""}}) {
    const Files before = files();
    const Outcome outcome = run_words(words);
    EXPECT_EQ(outcome.exit_code, kUsage) << words[0];
    EXPECT_EQ(outcome.out, "") << "found before the run";
    expect_one_sentence(outcome.err, words[0], "");
    EXPECT_TRUE(files() == before);
  }
}

TEST_F(BadOutput, read_only_folder) {
  fs::create_directory(path("locked"));
  fs::permissions(path("locked"), fs::perms(0555));
  RunOptions options;
  if (::geteuid() == 0) options.user = 65534;  // nobody; root may write everywhere
  fs::permissions(path("."), fs::perms(0755));
  if (run("load --version", options).exit_code == kCannotStart) {
    GTEST_SKIP() << "another user cannot run the programs in this folder";
  }
  for (const std::string command :
       {"load --config small.ini --until 1e-4 -o locked/b.h5", "modify-phi a.h5 -o locked/b.h5"}) {
    expect_refusal(command, kFailed,
                   "could not write locked/b.h5: its folder locked: Permission denied; give "
                   "another path",
                   options);
  }
}

TEST_F(BadOutput, unreadable_input) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can run a program as another user";
  fs::permissions(path("."), fs::perms(0755));
  fs::permissions(path("a.h5"), fs::perms(0600));
  const RunOptions nobody = {.user = 65534};
  if (run("load --version", nobody).exit_code == kCannotStart) {
    GTEST_SKIP() << "another user cannot run the programs in this folder";
  }
  expect_refusal("analyze stress a.h5", kFailed,
                 "could not read a.h5: Permission denied; check the permissions of the file and "
                 "its folder",
                 nobody);
}

TEST_F(BadOutput, full_disk) {
  const RunOptions full = {.largest_file = 20000};
  expect_refusal("load --config small.ini --until 1e-4 -o b.h5", kFailed,
                 "could not write b.h5: File too large", full);
  expect_refusal("restart a.h5 --for 1e-4 -o b.h5", kFailed, "could not write b.h5: File too large",
                 full);
  expect_refusal("modify-phi a.h5 -o b.h5", kFailed, "could not write b.h5: File too large", full);
}

TEST_F(BadOutput, full_disk_keeps_the_file_that_was_to_be_replaced) {
  output_of("load --config small.ini -o old.h5 --record old-r.h5 -q");
  const RunOptions full = {.largest_file = 20000};
  expect_refusal("load --config small.ini --until 1e-4 -o old.h5 --force", kFailed,
                 "could not write old.h5: File too large", full);
}

TEST_F(BadOutput, full_disk_while_recording_keeps_the_old_record) {
  output_of("load --config small.ini -o old.h5 --record old-r.h5 -q");
  const Files before = files();
  const Outcome outcome =
      run("load --config small.ini --until 4e-4 -o old.h5 --record old-r.h5 --record-every 2e-7 "
          "--force",
          {.largest_file = 60000});
  EXPECT_EQ(outcome.exit_code, kFailed);
  expect_one_sentence(outcome.err, "load", "old-r.h5");
  for (const auto& [name, bytes] : before) EXPECT_TRUE(files().at(name) == bytes) << name;
}

TEST_F(BadOutput, full_disk_while_recording_leaves_a_readable_part) {
  const Outcome outcome =
      run("load --config small.ini --until 4e-4 -o b.h5 --record r.h5 --record-every 2e-7",
          {.largest_file = 250000});
  EXPECT_EQ(outcome.exit_code, kFailed);
  expect_one_sentence(outcome.err, "load", "r.h5");
  EXPECT_FALSE(fs::exists(path("r.h5")));
  EXPECT_FALSE(fs::exists(path("b.h5")));
  const Outcome loading = run("analyze loading r.h5.part --json");
  EXPECT_EQ(loading.exit_code, kDone) << loading.err;
}

TEST_F(BadOutput, full_standard_output) {
  const RunOptions full = {.standard_output = "/dev/full"};
  constexpr const char* sentence = "cannot write to standard output";
  for (const std::string command :
       {"analyze stress a.h5", "analyze stress a.h5 --json", "analyze stress a.h5 --csv",
        "analyze phi a.h5", "analyze checksum a.h5", "analyze verify a.h5", "analyze show a.h5",
        "analyze diff a.h5 a.h5"}) {
    expect_refusal(command, kFailed, sentence, full);
  }
}

TEST_F(BadOutput, full_standard_output_for_help_and_version) {
  const RunOptions full = {.standard_output = "/dev/full"};
  for (const std::string command :
       {"load --help", "load --version", "analyze --help", "analyze stress --help"}) {
    expect_refusal(command, kFailed, "cannot write to standard output", full);
  }
}

TEST_F(BadOutput, full_standard_output_loses_no_file) {
  const Outcome outcome =
      run("load --config small.ini -o b.h5 --until 1e-4", {.standard_output = "/dev/full"});
  EXPECT_EQ(outcome.exit_code, kFailed);
  expect_one_sentence(outcome.err, "load", "cannot write to standard output");
  EXPECT_DOUBLE_EQ(json_of("analyze stress b.h5 --json")["time"], 1e-4);
}

TEST_F(BadOutput, two_outputs_of_the_same_name) {
  const std::string load = "load --config small.ini --until 1e-4 -o b.h5";
  for (const std::string force : {"", " --force"}) {
    expect_refusal_with(load + " --record b.h5" + force, kUsage, "b.h5");
    expect_refusal_with(load + " --record ./b.h5" + force, kUsage, "b.h5");
    expect_refusal_with(load + " --checkpoint-at 1e-4 --record b-t0.000100000.h5" + force, kUsage,
                        "b-t0.000100000.h5");
  }
}

TEST_F(BadOutput, record_under_the_name_of_a_sum) {
  expect_refusal_with("load --config small.ini --until 1e-4 -o b.h5 --record b.h5.sum", kUsage,
                      "b.h5.sum");
}

TEST_F(BadOutput, input_is_never_overwritten_by_the_record) {
  expect_refusal_with("restart a.h5 --for 1e-4 -o b.h5 --record a.h5 --force", kUsage, "a.h5");
}

TEST_F(BadOutput, input_is_never_overwritten_nor_removed_as_a_sum) {
  fs::copy_file(path("a.h5"), path("b.h5.sum"));
  for (const std::string sum : {"", " --sum"}) {
    expect_refusal("restart b.h5.sum --for 1e-5 -o b.h5" + sum, kUsage,
                   "b.h5.sum is the input, which is never changed: give another output");
  }
}

TEST_F(BadOutput, one_file_by_two_names_is_found_through_links_and_folders) {
  fs::create_symlink(".", path("here"));
  fs::create_symlink("a.h5", path("link.h5"));
  for (const std::string own : {"here/a.h5", "link.h5", "here/./a.h5"}) {
    expect_refusal("restart a.h5 --for 1e-5 --force -o " + own, kUsage,
                   own + " is the input, which is never changed: give another output");
  }
  expect_refusal("restart a.h5 --for 1e-5 -o b.h5 --record here/b.h5", kUsage,
                 "two outputs would have the name here/b.h5: give different names");
}

TEST_F(BadOutput, name_that_is_too_long) {
  for (const std::size_t length : {250U, 253U, 300U}) {
    const std::string name(length, 'x');
    expect_refusal("restart a.h5 --for 1e-5 -o " + name, kFailed,
                   "could not write " + name + ": File name too long; give another path");
  }
}

TEST_F(BadOutput, dangling_link_is_replaced_or_refused_but_never_followed) {
  fs::create_symlink("elsewhere.h5", path("link.h5"));
  expect_refusal("load --config small.ini -o link.h5", kFailed,
                 "link.h5 exists; give --force to replace it");
  output_of("load --config small.ini -o link.h5 --force");
  EXPECT_FALSE(fs::exists(path("elsewhere.h5")));
  EXPECT_EQ(checksum_of("link.h5"), checksum_of("a.h5"));
}

TEST_F(BadOutput, sum_that_is_a_folder) {
  fs::create_directory(path("b.h5.sum"));
  expect_refusal_with("load --config small.ini -o b.h5 --until 1e-4", kFailed, "b.h5.sum");
}

}  // namespace
}  // namespace rupture::testing
