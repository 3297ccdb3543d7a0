// Names that are empty, values that do not fit the file they are for, files of another kind: one
// sentence, which says what was expected.
#include <hdf5.h>

#include "tool_test.hpp"

namespace rupture::testing {
namespace {

class BadInput : public ToolTest {
 protected:
  BadInput() {
    output_of("load --config small.ini -o a.h5 --until 1e-4 --record r.h5 -q");
    before_ = files();
  }

  void expect_usage(const std::vector<std::string>& words, const std::string& sentence) const {
    const Outcome outcome = run_words(words);
    EXPECT_EQ(outcome.exit_code, kUsage) << words[1];
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, words[0] + ": " + sentence + "\n");
    EXPECT_TRUE(files() == before_);
  }

 private:
  Files before_;
};

TEST_F(BadInput, empty_names) {
  const std::string input = "an input has an empty name; give the path of a file";
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"finish", "", "-o", "b.h5"},
        {"seal", "", "-o", "b.h5"},
        {"restart", "", "-o", "b.h5", "--for", "1e-5"},
        {"analyze", "front", ""},
        {"analyze", "stress", ""},
        {"analyze", "verify", "a.h5", ""},
        {"analyze", "diff", "", "a.h5"}}) {
    expect_usage(words, input);
  }
  expect_usage({"analyze", "lineage", "a.h5", "--commands", "-o", ""},
               "an output has an empty name; give the path of a file");
  expect_usage({"seal", "a.h5", "-o", "b.h5", "--original", ""},
               "--original has an empty name: give the path of a file; see rupture seal --help");
}

TEST_F(BadInput, numbers_that_are_none) {
  for (const std::string value : {"many", "1.5", "1e2", "99999999999999999999"}) {
    expect_refusal("analyze front r.h5 --stencil " + value, kUsage,
                   "--stencil " + value +
                       " is not a whole number of this size; see rupture analyze front --help");
  }
  expect_refusal("analyze front r.h5 --from 1e999", kUsage,
                 "--from 1e999 is too large for a number; see rupture analyze front --help");
}

TEST_F(BadInput, criteria_beyond_the_interface) {
  for (const std::string command : {"events", "front", "classify", "slow-slip"}) {
    const std::string analyze = "analyze " + command + " r.h5 ";
    expect_refusal(analyze + "--stencil 11", kUsage,
                   "--stencil 11 is longer than the interface: give at most its 9 blocks");
    expect_refusal(analyze + "--skip-below-x 0.15", kUsage,
                   "--skip-below-x 0.15 is beyond the interface, which ends at 0.14 m");
    output_of(analyze + "--stencil 9 --skip-below-x 0.14");
  }
  expect_refusal("analyze slow-slip r.h5 --longest 0.4", kUsage,
                 "--longest 0.4 is below --shortest 0.5, which leaves out every block: give a "
                 "larger one");
}

TEST_F(BadInput, files_that_are_no_manifest_or_configuration) {
  fs::create_directory(path("folder"));
  expect_refusal("analyze verify --manifest folder", kFailed,
                 "cannot read the manifest folder; give the path of a readable file");
  write("odd", std::string("a\0b\n", 4));
  expect_refusal("analyze verify --manifest odd", kFailed,
                 "odd is no manifest: 'a?b' is not 'content-sha256 <64 hex digits>  <file>'");
  expect_refusal("load --config a.h5 -o b.h5", kUsage,
                 "a.h5:1: the options configuration file contains an invalid line "
                 "'rupture-checkpoint'; write lines NAME = VALUE and [GROUP]");
}

TEST_F(BadInput, files_that_were_never_sealed) {
  write("e.h5", "");
  expect_refusal("seal e.h5 -o b.h5", kFailed, "e.h5 is empty; expected a checkpoint or record");
  H5Fclose(H5Fcreate(path("e.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  expect_refusal("seal e.h5 -o b.h5", kFailed,
                 "e.h5: format is missing; expected text, as in every file that one of rupture's "
                 "programs wrote");
}

TEST_F(BadInput, original_is_an_input_too) {
  fs::copy_file(path("a.h5"), path("e.h5"));
  const hid_t file = H5Fopen(path("e.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  H5Ldelete(file, "/run", H5P_DEFAULT);
  H5Fclose(file);
  expect_refusal("seal e.h5 -o a.h5 --original a.h5 --force", kUsage,
                 "a.h5 is the input, which is never changed: give another output");
  output_of("seal e.h5 -o b.h5 --original a.h5 -q");
}

}  // namespace
}  // namespace rupture::testing
