// analyze verify: files, folders and manifests.
#include <unistd.h>

#include "rupture/checkpoint/file.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

class Verify : public ToolTest {
 protected:
  Verify() {
    output_of("load --config small.ini -o a.h5 --until 1e-5 --record r.h5 -q");
    output_of("restart a.h5 -o b.h5 --for 1e-5 -q");
  }

  void damage(const std::string& file) const {
    std::string bytes = read(file);
    bytes[kHeaderSize] = static_cast<char>(bytes[kHeaderSize] ^ 1);  // HDF5's first byte
    write(file, bytes);
  }

  std::string intact(const std::string& file) const { return "intact  " + sum_line(file); }

  static std::string damage_sentence(const std::string& file) {
    return file +
           " is damaged: its bytes and the SHA-256 in its header do not agree; copy it again or "
           "write it anew";
  }
};

TEST_F(Verify, names_each_intact_file) {
  EXPECT_EQ(output_of("analyze verify a.h5 r.h5"), intact("a.h5") + intact("r.h5") + "2 intact\n");
  expect_refusal("analyze verify", kUsage,
                 "nothing to verify: name a checkpoint, record or folder, or give --manifest");
}

TEST_F(Verify, reads_manifests_relative_to_their_folder) {
  fs::create_directory(path("lists"));
  write("lists/m.txt", checksum_of("a.h5") + "  ../a.h5\n\n" + checksum_of("r.h5") + "  ../r.h5\n");
  EXPECT_EQ(lines_of(output_of("analyze verify --manifest lists/m.txt")).size(), 3U);
}

// before-supports.h5 was written before there was slider.support; reference.h5 is the same run.
TEST_F(Verify, accepts_files_of_earlier_schemas_by_either_checksum) {
  const fs::path kept = fs::path(__FILE__).parent_path() / "../compatibility/schema-1";
  if (!fs::exists(kept)) GTEST_SKIP() << "the sources are elsewhere";
  for (const char* name : {"before-supports.h5", "reference.h5"}) {
    fs::copy_file(kept / name, path(name));
  }
  const std::string stored = "d3d2cef5e54738ff508af0f3491ca97538c6ba86032b471e2b424958339d6517";
  EXPECT_EQ(checksum_of("before-supports.h5"), checksum_of("reference.h5"));
  EXPECT_EQ(output_of("analyze diff before-supports.h5 reference.h5"), "equal\n");
  EXPECT_EQ(output_of("analyze checksum --as-schema-2 before-supports.h5"), stored + "\n");
  for (const std::string& noted : {stored, checksum_of("reference.h5")}) {
    write("m.txt", noted + "  before-supports.h5\n");
    EXPECT_EQ(output_of("analyze verify --manifest m.txt"),
              "intact  content-sha256 " + noted + "  before-supports.h5\n1 intact\n");
  }
}

TEST_F(Verify, reads_lines_with_and_without_the_word_in_front) {
  write("m.txt", sum_line("a.h5") + checksum_of("r.h5") + "  r.h5\n");
  EXPECT_EQ(output_of("analyze verify --manifest m.txt"),
            intact("a.h5") + intact("r.h5") + "2 intact\n");
  write("m.txt", "content-sha256 a.h5\n");
  expect_refusal("analyze verify --manifest m.txt", kFailed,
                 "m.txt is no manifest: 'content-sha256 a.h5' is not 'content-sha256 <64 hex "
                 "digits>  <file>'");
}

TEST_F(Verify, sums_are_nothing_that_sha256sum_could_take_for_its_own) {
  output_of("load --config small.ini -o c.h5 --sum -q");
  const Outcome outcome = run_words({"/usr/bin/env", "LC_ALL=C", "sha256sum", "-c", "c.h5.sum"});
  EXPECT_NE(outcome.err.find("no properly formatted"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

TEST_F(Verify, reads_sums_of_files_with_spaces_in_their_names) {
  run_words({"load", "--config", "small.ini", "-o", "with space.h5", "--sum"});
  const Outcome outcome = run_words({"analyze", "verify", "--manifest", "with space.h5.sum"});
  EXPECT_EQ(outcome.exit_code, kDone);
  EXPECT_EQ(outcome.err, "");
}

TEST_F(Verify, sees_other_content_than_the_manifest_says) {
  write("m.txt", checksum_of("a.h5") + "  b.h5\n");
  expect_refusal("analyze verify --manifest m.txt", kFailed,
                 "b.h5 is intact but has content checksum " + checksum_of("b.h5") + ", not " +
                     checksum_of("a.h5") + " as the manifest says");
  write("m.txt", checksum_of("a.h5") + "  gone.h5\n");
  expect_refusal("analyze verify --manifest m.txt", kFailed,
                 "gone.h5 does not exist; give the path of a checkpoint or record");
  write("m.txt", "a.h5\n");
  expect_refusal("analyze verify --manifest m.txt", kFailed,
                 "m.txt is no manifest: 'a.h5' is not 'content-sha256 <64 hex digits>  <file>'");
  expect_refusal("analyze verify --manifest gone.txt", kFailed,
                 "cannot read the manifest gone.txt; give the path of a readable file");
}

TEST_F(Verify, refuses_an_empty_manifest) {
  write("m.txt", "");
  expect_refusal_with("analyze verify --manifest m.txt", kFailed, "m.txt");
}

TEST_F(Verify, looks_at_every_file_whatever_is_wrong_with_others) {
  damage("a.h5");
  const Outcome outcome = run("analyze verify a.h5 gone.h5 b.h5");
  EXPECT_EQ(outcome.exit_code, kFailed);
  EXPECT_EQ(outcome.out,
            "damaged  " + damage_sentence("a.h5") +
                "\nmissing  gone.h5 does not exist; give the path of a checkpoint or record\n" +
                intact("b.h5") + "1 intact, 1 damaged, 1 missing\n");
  EXPECT_EQ(outcome.err, "analyze: not all is well: 1 intact, 1 damaged, 1 missing\n");
}

TEST_F(Verify, looks_at_all_of_a_manifest) {
  damage("a.h5");
  write("m.txt", checksum_of("r.h5") + "  a.h5\n" + checksum_of("r.h5") + "  b.h5\n" +
                     checksum_of("r.h5") + "  r.h5\n");
  const Outcome outcome = run("analyze verify --manifest m.txt");
  EXPECT_EQ(outcome.exit_code, kFailed);
  EXPECT_NE(outcome.out.find("1 intact, 1 differs, 1 damaged\n"), std::string::npos) << outcome.out;
}

TEST_F(Verify, looks_into_folders_in_order) {
  fs::create_directories(path("f/m/empty"));
  for (const char* name : {"f/z.h5", "f/m/y.h5", "f/a.h5"}) {
    fs::copy_file(path("a.h5"), path(name));
  }
  write("f/notes.txt", "");
  write("f/a.h5.sum", "");
  EXPECT_EQ(output_of("analyze verify f"),
            intact("f/a.h5") + intact("f/m/y.h5") + intact("f/z.h5") + "3 intact\n");
  EXPECT_EQ(output_of("analyze verify b.h5 f/m/"),
            intact("b.h5") + intact("f/m/y.h5") + "2 intact\n");
  damage("f/m/y.h5");
  expect_refusal("analyze verify f", kFailed, damage_sentence("f/m/y.h5"));
}

TEST_F(Verify, follows_links_to_files_but_not_to_folders) {
  fs::create_directory(path("f"));
  fs::create_symlink(path("f"), path("f/loop"));
  fs::create_symlink(path("a.h5"), path("f/a.h5"));
  EXPECT_EQ(output_of("analyze verify f"), intact("f/a.h5") + "1 intact\n");
  fs::create_symlink(path("gone.h5"), path("f/b.h5"));
  expect_refusal("analyze verify f", kFailed,
                 "f/b.h5 does not exist; give the path of a checkpoint or record");
  fs::remove(path("f/b.h5"));
  fs::create_symlink("b.h5", path("f/b.h5"));
  expect_one_sentence(run("analyze verify f").err, "analyze",
                      "could not read f/b.h5: Too many levels of symbolic links");
}

TEST_F(Verify, names_unfinished_records_in_a_folder) {
  fs::create_directory(path("f"));
  write("f/r.h5.part", "");
  write("f/film.part", "");
  expect_refusal("analyze verify f", kFailed, "f holds no file *.h5");
  fs::copy_file(path("a.h5"), path("f/a.h5"));
  EXPECT_EQ(output_of("analyze verify f"), intact("f/a.h5") +
                                               "skipped  f/r.h5.part is an unfinished record\n"
                                               "1 intact, 1 skipped\n");
}

TEST_F(Verify, forges_no_line_of_a_name) {
  fs::rename(path("a.h5"), path("x.h5\nintact  \x1b[2J\xc2\x9b.h5"));
  EXPECT_EQ(lines_of(output_of("analyze verify .")).size(), 4U);
  EXPECT_NE(output_of("analyze verify .").find("  ./x.h5?intact  ?[2J?.h5\n"), std::string::npos);
}

TEST_F(Verify, refuses_an_empty_folder) {
  fs::create_directory(path("f"));
  expect_refusal("analyze verify f", kFailed, "f holds no file *.h5");
  expect_refusal("analyze verify a.h5 f", kFailed, "f holds no file *.h5");
}

TEST_F(Verify, names_folders_that_it_cannot_list) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can run a program as another user";
  fs::create_directories(path("f/locked"));
  fs::copy_file(path("a.h5"), path("f/a.h5"));
  fs::permissions(path("f/locked"), fs::perms(0700));
  fs::permissions(path("."), fs::perms(0755));
  const RunOptions nobody = {.user = 65534};
  if (run("load --version", nobody).exit_code == kCannotStart) {
    GTEST_SKIP() << "another user cannot run the programs in this folder";
  }
  expect_refusal("analyze verify f", kFailed,
                 "f/locked cannot be listed: Permission denied; check its permissions", nobody);
  EXPECT_NE(run("analyze verify f", nobody).out.find("1 intact, 1 unreadable\n"),
            std::string::npos);
}

TEST_F(Verify, says_which_files_of_a_folder_the_manifest_does_not_list) {
  fs::create_directory(path("f"));
  for (const char* name : {"a.h5", "b.h5"}) fs::copy_file(path(name), path("f") / name);
  write("m.txt", checksum_of("a.h5") + "  f/a.h5\n" + checksum_of("b.h5") + "  f/../f/b.h5\n");
  EXPECT_EQ(output_of("analyze verify f --manifest m.txt"),
            "intact  content-sha256 " + checksum_of("a.h5") + "  f/a.h5\nintact  content-sha256 " +
                checksum_of("b.h5") + "  f/../f/b.h5\n2 intact\n");
  fs::copy_file(path("r.h5"), path("f/r.h5"));
  expect_refusal("analyze verify f --manifest m.txt", kFailed,
                 "f/r.h5 is intact, but the manifest does not list it");
  damage("f/r.h5");
  expect_refusal("analyze verify f --manifest m.txt", kFailed, damage_sentence("f/r.h5"));
}

TEST_F(Verify, prints_what_a_manifest_needs) {
  std::string lines;
  for (const auto& line : lines_of(output_of("analyze verify ."))) {
    if (line.starts_with("intact  ")) lines += line.substr(8) + "\n";
  }
  write("m.txt", lines);
  EXPECT_EQ(lines_of(output_of("analyze verify . --manifest m.txt")).back(), "3 intact");
}

}  // namespace
}  // namespace rupture::testing
