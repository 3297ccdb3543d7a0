// seal, and what readers say of files that another program changed. HDF5's C interface does here
// what h5py and MATLAB do through it.
#include <utility>

#include "file_rows.hpp"

namespace rupture::testing {
namespace {

constexpr const char* kDeadly =
    "e.h5: the HDF5 library does not survive reading it (Segmentation fault), so it is damaged or "
    "made to do harm; copy it again or write it anew";

class Seal : public ToolTest {
 protected:
  Seal() { output_of("load --config small.ini -o good.h5 --until 1e-4 --record record.h5 -q"); }

  /// Leaves e.h5: `file` after the change.
  void edit(const std::function<void(hid_t)>& change, const std::string& file = "good.h5") const {
    fs::copy_file(path(file), path("e.h5"), fs::copy_options::overwrite_existing);
    edited(change)(path("e.h5"));
  }
};

/// Moves the last attachment point.
void edit_attachment(hid_t file) {
  set_last("/state/junctions/attachment", 1e-9)(file);
}

TEST_F(Seal, says_what_it_found_as_JSON) {
  edit(edit_attachment);
  const Json json = json_of("seal e.h5 -o new.h5 --original good.h5 --json --quiet");
  EXPECT_EQ(json["content_is_as_sealed"], false);
  EXPECT_EQ(json["sealed_checksum"], checksum_of("good.h5"));
  const Json attachment = {
      {"path", "/state/junctions/attachment"}, {"change", "values"}, {"count", 1}};
  EXPECT_EQ(json["differences"], Json::array({attachment}));
  const Json file = {
      {"path", "new.h5"}, {"holds", "checkpoint"}, {"checksum", checksum_of("new.h5")}};
  EXPECT_EQ(json["files"], Json::array({file}));
}

TEST_F(Seal, takes_a_state_that_was_edited) {
  edit(edit_attachment);
  const std::string said = output_of("seal e.h5 -o new.h5 --original good.h5 --sum");
  EXPECT_EQ(said,
            "the content is not what it was, " + checksum_of("good.h5") +
                "\nedited: /state/junctions/attachment: other values, 1 of 900\nwrote new.h5  "
                "content-sha256 " +
                checksum_of("new.h5") + "\n");
  EXPECT_EQ(read("new.h5.sum"), sum_line("new.h5"));
  const Checkpoint sealed = read_checkpoint(path("new.h5"));
  EXPECT_EQ(sealed.state.junctions.attachment(8, 99), 1e-9);
  EXPECT_FALSE(sealed.run) << "it is no checkpoint of that run any more";
  output_of("restart new.h5 -o after.h5 --for 1e-5 -q");
}

TEST_F(Seal, says_in_the_provenance_that_the_file_was_edited_outside) {
  edit(edit_attachment);
  output_of("seal e.h5 -o new.h5 -q");
  const Json entry = json_of("analyze show new.h5 --json").at("provenance").back();
  EXPECT_EQ(entry.at("tool"), "seal");
  EXPECT_EQ(entry.at("rebuild"), "edited outside");
  EXPECT_EQ(entry.at("parent_checksum"), checksum_of("good.h5"));
  EXPECT_NE(output_of("analyze lineage new.h5").find("(edited outside) "), std::string::npos);
  output_of("restart new.h5 -o after.h5 --for 1e-5 -q");
  expect_refusal("analyze lineage after.h5 --commands", kFailed,
                 "after.h5: step 1 (seal) has no command, because another program edited the file: "
                 "give the file it wrote, with content checksum " +
                     checksum_of("new.h5") + ", as --from FILE");
  EXPECT_NE(output_of("analyze lineage after.h5 --commands --from new.h5").find("restart --until "),
            std::string::npos);
}

TEST_F(Seal, takes_what_was_only_repacked_or_annotated) {
  edit([](hid_t file) {
    replaced(H5T_IEEE_F64LE, {5, 9}, compressed, true)(file);
    comment(file);
  });
  EXPECT_EQ(lines_of(output_of("seal e.h5 -o new.h5"))[0],
            "the content is as it was sealed; only what is beside it was changed");
  EXPECT_EQ(checksum_of("new.h5"), checksum_of("good.h5"));
  EXPECT_EQ(run("analyze diff good.h5 new.h5").exit_code, kDone);
}

TEST_F(Seal, takes_records) {
  edit(comment, "record.h5");
  output_of("seal e.h5 -o new.h5 -q");
  EXPECT_EQ(checksum_of("new.h5"), checksum_of("record.h5"));
  EXPECT_EQ(json_of("analyze show new.h5 --json").at("provenance").back().at("tool"), "seal");
  output_of("analyze events new.h5");
}

TEST_F(Seal, refuses_other_files) {
  edit(edit_attachment);
  expect_refusal("seal e.h5 -o e.h5 -f", kUsage,
                 "e.h5 is the input, which is never changed: give another output");
  output_of("load --config small.ini -o other.h5 -q");
  expect_refusal("seal e.h5 -o new.h5 --original other.h5", kFailed,
                 "other.h5 is not the original of e.h5: its content checksum is " +
                     checksum_of("other.h5") + ", not " + checksum_of("good.h5"));
}

// Each makes libhdf5 1.10.8 read beyond its memory.
TEST_F(Seal, of_a_file_that_crashes_the_library_is_one_sentence) {
  const fs::path kept = fs::path(__FILE__).parent_path() / "../compatibility/schema-3/reference.h5";
  if (!fs::exists(kept)) GTEST_SKIP() << "the sources are elsewhere";
  const std::vector<std::pair<std::size_t, char>> deadly = {
      {13492, 2}, {7143, '\x80'}, {9660, 2}, {18764, 2}};
  for (const auto& [at, value] : deadly) {
    std::string body = slurp(kept).substr(kHeaderSize);
    body[at] = value;
    write("e.h5", header_text(FileKind::checkpoint, bytes_of(body)) + body);
    const Outcome verdict = run("analyze verify e.h5");
    EXPECT_EQ(verdict.exit_code, kFailed) << at;
    EXPECT_EQ(verdict.out.find("damaged  e.h5: "), 0U) << verdict.out;
    EXPECT_EQ(run("seal e.h5 -o new.h5").exit_code, kFailed) << at;
    EXPECT_FALSE(fs::exists(path("new.h5")));
    if (H5_VERS_MINOR == 10 && RUPTURE_SANITIZED == 0) {
      EXPECT_EQ(verdict.err, "analyze: " + std::string(kDeadly) + "\n");
      expect_refusal("seal e.h5 -o new.h5", kFailed, kDeadly);
    }
  }
}

}  // namespace
}  // namespace rupture::testing
