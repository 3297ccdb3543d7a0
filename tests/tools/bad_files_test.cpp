// Files that are missing, foreign, damaged or of the wrong kind: one sentence, exit code 1.
#include <hdf5.h>

#include <cstring>
#include <span>

#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/envelope.hpp"
#include "rupture/version.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

constexpr const char* kDamaged =
    "flipped.h5 is damaged: its bytes and the SHA-256 in its header do not agree; copy it again or "
    "write it anew";

/// Of a file that HDF5 can read, and in which only what is beside the content is not as it was.
std::string changed_but_for_its_content(const std::string& file) {
  return file +
         " was changed after rupture sealed it (repacked by another program, an attribute added, "
         "or damaged beside its data), but its content still has the checksum that is stored in "
         "it: rupture seal " +
         file + " -o NEW.h5 makes a sealed file of it";
}

class BadFiles : public ToolTest {
 protected:
  BadFiles() { output_of("load --config small.ini -o good.h5 --until 2e-4 --record record.h5 -q"); }

  /// A checkpoint of a slider that cannot be followed: one block moves at 1e200 m/s.
  void write_wild_checkpoint() const {
    Checkpoint checkpoint = read_checkpoint(path("good.h5"));
    checkpoint.state.v_x(3, 2) = 1e200;
    write_checkpoint(path("wild.h5"), checkpoint, IfExists::refuse);
  }

  /// Every tool that reads a checkpoint must say this of `file`.
  void expect_refused(const std::string& file, const std::string& sentence) const {
    for (const std::string command : {"restart", "modify-phi", "analyze stress", "analyze phi"}) {
      const std::string rest = command == "restart"      ? " -o out.h5 --for 1e-5"
                               : command == "modify-phi" ? " -o out.h5"
                                                         : "";
      expect_refusal(command + " " + file + rest, kFailed, sentence);
    }
  }
  /// The same of every tool that reads any file.
  void expect_refused_as_any_file(const std::string& file, const std::string& sentence) const {
    for (const std::string command : {"checksum", "show", "lineage", "diff good.h5"}) {
      expect_refusal("analyze " + command + " " + file, kFailed, sentence);
    }
    if (!fs::is_directory(path(file))) {  // verify looks into folders
      expect_refusal("analyze verify " + file, kFailed, sentence);
    }
  }
  /// The same of every tool that reads a record.
  void expect_refused_as_record(const std::string& file, const std::string& sentence) const {
    for (const std::string command : {"events", "front", "classify", "slip --x 0", "loading"}) {
      expect_refusal("analyze " + command + " " + file, kFailed, sentence);
    }
  }
  void expect_refused_everywhere(const std::string& file, const std::string& sentence) const {
    expect_refused(file, sentence);
    expect_refused_as_any_file(file, sentence);
    expect_refused_as_record(file, sentence);
  }
};

TEST_F(BadFiles, missing) {
  expect_refused_everywhere("gone.h5",
                            "gone.h5 does not exist; give the path of a checkpoint or record");
  expect_refused_everywhere("good.h5/x.h5",
                            "good.h5/x.h5 does not exist; give the path of a checkpoint or record");
}

TEST_F(BadFiles, folder) {
  fs::create_directory(path("folder.h5"));
  expect_refused_everywhere("folder.h5",
                            "folder.h5 is a folder; give the path of a checkpoint or record");
}

TEST_F(BadFiles, device) {
  expect_refused_everywhere(
      "/dev/null", "/dev/null is not a regular file; give the path of a checkpoint or record");
}

TEST_F(BadFiles, empty) {
  write("empty.h5", "");
  expect_refused_everywhere("empty.h5", "empty.h5 is empty; expected a checkpoint or record");
}

TEST_F(BadFiles, text) {
  expect_refused_everywhere("small.ini",
                            "small.ini is not a rupture file: expected the 512-byte header of a "
                            "checkpoint or record; give a file that one of rupture's tools wrote");
}

TEST_F(BadFiles, hdf5_file_of_another_program) {
  const hid_t file = H5Fcreate(path("foreign.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  ASSERT_GE(H5Fclose(file), 0);
  expect_refused_everywhere(
      "foreign.h5",
      "foreign.h5 is an HDF5 file without rupture's 512-byte header: it was not written by "
      "rupture, or was rewritten by another program; give the original file, or try rupture seal "
      "foreign.h5 -o NEW.h5");
}

TEST_F(BadFiles, truncated) {
  const std::string whole = read("good.h5");
  for (const std::size_t size : {std::size_t{513}, whole.size() / 2, whole.size() - 1}) {
    write("short.h5", whole.substr(0, size));
    expect_refused("short.h5", "short.h5 is truncated: it holds " + std::to_string(size) + " of " +
                                   std::to_string(whole.size()) +
                                   " bytes; copy it again or write it anew");
  }
  for (const std::size_t size : {1U, 100U, 511U}) {
    write("short.h5", whole.substr(0, size));
    expect_refused("short.h5", "short.h5 is truncated: it ends within its 512-byte header, after " +
                                   std::to_string(size) + " bytes; copy it again or write it anew");
  }
}

TEST_F(BadFiles, damaged) {
  const std::string whole = read("good.h5");
  for (const std::size_t at :
       {std::size_t{25}, std::size_t{300}, std::size_t{511}, std::size_t{512}}) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    write("flipped.h5", bytes);
    expect_refused("flipped.h5", kDamaged);
    expect_refused_as_any_file("flipped.h5", kDamaged);
  }
  write("longer.h5", whole + "x");
  expect_refused("longer.h5", changed_but_for_its_content("longer.h5"));
}

/// A sample of the bits and lengths; all of them are in tests/unit/checkpoint/damage_test.cpp.
TEST_F(BadFiles, SLOW_damaged_anywhere) {
  const std::string whole = read("good.h5");
  for (std::size_t bit = 40; bit < 8 * whole.size(); bit += 1 + 8 * whole.size() / 60) {
    std::string bytes = whole;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ static_cast<char>(1U << bit % 8));
    write("flipped.h5", bytes);
    expect_refusal_with("analyze verify flipped.h5", kFailed, "flipped.h5 ");
    expect_refusal_with("restart flipped.h5 -o out.h5 --for 1e-5", kFailed, "flipped.h5 ");
  }
  for (std::size_t size = 1; size < whole.size(); size += 1 + whole.size() / 20) {
    write("short.h5", whole.substr(0, size));
    expect_refusal_with("analyze verify short.h5", kFailed, "short.h5 is truncated: it ");
    expect_refusal_with("restart short.h5 -o out.h5 --for 1e-5", kFailed, "short.h5 is truncated");
  }
}

TEST_F(BadFiles, damaged_record) {
  std::string bytes = read("record.h5");
  bytes[kHeaderSize] = static_cast<char>(bytes[kHeaderSize] ^ 1);
  write("flipped.h5", bytes);
  expect_refused_as_record("flipped.h5", kDamaged);
  expect_refused_as_any_file("flipped.h5", kDamaged);
}

TEST_F(BadFiles, damaged_first_line) {
  std::string bytes = read("good.h5");
  bytes[0] = 'R';
  write("flipped.h5", bytes);
  expect_refused("flipped.h5",
                 "flipped.h5 is not a rupture file: expected the 512-byte header of a checkpoint "
                 "or record; give a file that one of rupture's tools wrote");
}

/// Writes the schema version into the HDF5 part of a file and seals it again.
void set_schema_version(const fs::path& path, std::int64_t version) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t attribute = H5Aopen(file, "schema_version", H5P_DEFAULT);
  ASSERT_GE(H5Awrite(attribute, H5T_NATIVE_INT64, &version), 0);
  H5Aclose(attribute);
  ASSERT_GE(H5Fclose(file), 0);
}

TEST_F(BadFiles, newer_schema) {
  fs::copy_file(path("good.h5"), path("newer.h5"));
  set_schema_version(path("newer.h5"), kSchemaVersion + 1);
  std::string bytes = read("newer.h5");
  const auto body = std::as_bytes(std::span(bytes)).subspan(kHeaderSize);
  bytes.replace(0, kHeaderSize, header_text(FileKind::checkpoint, body));
  write("newer.h5", bytes);
  const std::string program = "rupture " + std::string(rupture::version);
  const std::string sentence = "newer.h5: written by " + program + " (schema " +
                               std::to_string(kSchemaVersion + 1) + "); this is " + program +
                               ", which reads up to schema " + std::to_string(kSchemaVersion) +
                               ": use " + program + " or newer";
  expect_refused("newer.h5", sentence);
  expect_refused_as_any_file("newer.h5", sentence);
}

TEST_F(BadFiles, whose_texts_hold_control_characters_are_refused_in_one_line) {
  Content content = read_content(path("good.h5"));
  content["/parameters/junctions/law"] = make_text("\n\x1b[2J");
  write_content(path("wild.h5"), FileKind::checkpoint, content, IfExists::refuse);
  expect_refused("wild.h5",
                 "wild.h5: junctions.law = '??[2J' is unknown: choose one of reference, "
                 "simplified, decaying, distance");
}

TEST_F(BadFiles, record_where_a_checkpoint_is_expected) {
  expect_refused("record.h5", "record.h5 is a record; expected a checkpoint");
}

TEST_F(BadFiles, checkpoint_where_a_record_is_expected) {
  expect_refused_as_record("good.h5", "good.h5 is a checkpoint; expected a record");
}

TEST_F(BadFiles, numerical_blow_up_stops_the_run) {
  write_wild_checkpoint();
  expect_refusal_with("restart wild.h5 -o out.h5 --for 1e-4", kFailed,
                      "numerical blow-up at t = 0.000200");
  expect_refusal_with("restart wild.h5 -o out.h5 --for 1e-4", kFailed, "in block (");
}

TEST_F(BadFiles, numerical_blow_up_keeps_the_last_checkpoint) {
  write_wild_checkpoint();
  const Outcome outcome =
      run("restart wild.h5 -o out.h5 --for 1e-4 --checkpoint-at 2e-4 --record r.h5");
  EXPECT_EQ(outcome.exit_code, kFailed);
  expect_one_sentence(outcome.err, "restart", "numerical blow-up at t = 0.000200");
  EXPECT_FALSE(fs::exists(path("out.h5")));
  EXPECT_FALSE(fs::exists(path("r.h5")));
  EXPECT_EQ(checksum_of("out-t0.000200000.h5"), checksum_of("wild.h5"));
  expect_refusal("analyze verify r.h5.part", kFailed,
                 "r.h5.part: an unfinished record cannot be verified: its run has not ended");
}

TEST_F(BadFiles, numerical_blow_up_loses_no_sample) {
  write_wild_checkpoint();
  EXPECT_EQ(run("restart wild.h5 -o out.h5 --for 1e-4 --record r.h5").exit_code, kFailed);
  EXPECT_EQ(json_of("analyze loading r.h5.part --json")["time"].size(), 1U);
}

}  // namespace
}  // namespace rupture::testing
