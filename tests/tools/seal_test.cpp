// seal, and what readers say of files that another program changed. HDF5's C interface does here
// what h5py and MATLAB do through it.
#include <hdf5.h>

#include <array>
#include <cmath>
#include <functional>
#include <span>

#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/envelope.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

constexpr const char* kOtherContent =
    "e.h5 was changed after rupture sealed it, and its content is not what it was: if somebody "
    "edited it with another program, rupture seal e.h5 -o NEW.h5 checks and seals it; otherwise it "
    "is damaged, copy it again or write it anew";
constexpr const char* kSameContent =
    "e.h5 was changed after rupture sealed it (repacked by another program, an attribute added, or "
    "damaged beside its data), but its content still has the checksum that is stored in it: "
    "rupture seal e.h5 -o NEW.h5 makes a sealed file of it";
constexpr const char* kDeadly =
    "e.h5: the HDF5 library does not survive reading it (Segmentation fault), so it is damaged or "
    "made to do harm; copy it again or write it anew";

using Values = std::vector<double>;

/// Closes what HDF5 has opened, whatever it is.
struct Opened {
  explicit Opened(hid_t opened) : id(opened) { EXPECT_GE(id, 0); }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
  ~Opened() { EXPECT_GE(H5Idec_ref(id), 0); }
  hid_t id;
};

void set_text(hid_t object, const char* name, const char* text) {
  const Opened type(H5Tcopy(H5T_C_S1)), space(H5Screate(H5S_SCALAR));
  EXPECT_GE(H5Tset_size(type.id, H5T_VARIABLE), 0);  // as h5py does
  if (H5Aexists(object, name) > 0) H5Adelete(object, name);
  const Opened created(H5Acreate2(object, name, type.id, space.id, H5P_DEFAULT, H5P_DEFAULT));
  EXPECT_GE(H5Awrite(created.id, type.id, &text), 0);
}

Values values_of(hid_t dataset) {
  Values values(static_cast<std::size_t>(H5Dget_storage_size(dataset)) / sizeof(double));
  EXPECT_GE(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  return values;
}

void write_values(hid_t dataset, const Values& values) {
  EXPECT_GE(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
}

/// Pulls the first attachment point back by a nanometre.
void edit_attachment(hid_t file) {
  const Opened dataset(H5Dopen2(file, "/state/junctions/attachment", H5P_DEFAULT));
  Values values = values_of(dataset.id);
  values[0] -= 1e-9;
  write_values(dataset.id, values);
}

/// Puts a dataset in place of u_x: of the same numbers, compressed, without unit.
void replace_u_x(hid_t file, hid_t type) {
  Values values;
  hid_t space = -1;
  {
    const Opened before(H5Dopen2(file, "/state/u_x", H5P_DEFAULT));
    values = values_of(before.id);
    space = H5Dget_space(before.id);
  }
  const Opened shape(space), packing(H5Pcreate(H5P_DATASET_CREATE));
  const std::array<hsize_t, 2> chunk = {2, 3};
  EXPECT_GE(H5Pset_chunk(packing.id, 2, chunk.data()), 0);
  EXPECT_GE(H5Pset_deflate(packing.id, 5), 0);
  EXPECT_GE(H5Ldelete(file, "/state/u_x", H5P_DEFAULT), 0);
  const Opened after(
      H5Dcreate2(file, "/state/u_x", type, shape.id, H5P_DEFAULT, packing.id, H5P_DEFAULT));
  write_values(after.id, values);
}

class Seal : public ToolTest {
 protected:
  Seal() { output_of("load --config small.ini -o good.h5 --until 1e-4 --record record.h5 -q"); }

  /// Leaves e.h5: `file` after the change.
  void edit(const std::function<void(hid_t)>& change, const std::string& file = "good.h5") const {
    fs::copy_file(path(file), path("e.h5"), fs::copy_options::overwrite_existing);
    const Opened opened(H5Fopen(path("e.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT));
    change(opened.id);
  }
  void expect_readers_say(const char* sentence) const {
    expect_refusal("restart e.h5 -o out.h5 --for 1e-5", kFailed, sentence);
    expect_refusal("analyze stress e.h5", kFailed, sentence);
    expect_refusal("analyze verify e.h5", kFailed, sentence);
    EXPECT_EQ(run("analyze verify e.h5").out,
              "changed  " + std::string(sentence) + "\n1 changed\n");
  }
};

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
  expect_readers_say(kOtherContent);
  const std::string said = output_of("seal e.h5 -o new.h5 --original good.h5 --sum");
  EXPECT_EQ(said,
            "the content is not what it was, " + checksum_of("good.h5") +
                "\nedited: /state/junctions/attachment: other values, 1 of 900\nwrote new.h5  "
                "content-sha256 " +
                checksum_of("new.h5") + "\n");
  EXPECT_EQ(read("new.h5.sum"), sum_line("new.h5"));
  const Checkpoint good = read_checkpoint(path("good.h5")),
                   sealed = read_checkpoint(path("new.h5"));
  EXPECT_EQ(sealed.state.junctions.attachment(0, 0), good.state.junctions.attachment(0, 0) - 1e-9);
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
    replace_u_x(file, H5T_IEEE_F64LE);
    set_text(file, "comment", "mine");
  });
  expect_readers_say(kSameContent);
  EXPECT_EQ(lines_of(output_of("seal e.h5 -o new.h5"))[0],
            "the content is as it was sealed; only what is beside it was changed");
  EXPECT_EQ(checksum_of("new.h5"), checksum_of("good.h5"));
  EXPECT_EQ(run("analyze diff good.h5 new.h5").exit_code, kDone);
}

TEST_F(Seal, takes_records) {
  edit([](hid_t file) { set_text(file, "comment", "mine"); }, "record.h5");
  expect_refusal("analyze events e.h5", kFailed, kSameContent);
  output_of("seal e.h5 -o new.h5 -q");
  EXPECT_EQ(checksum_of("new.h5"), checksum_of("record.h5"));
  output_of("analyze events new.h5");
  edit(
      [](hid_t file) {
        const Opened time(H5Dopen2(file, "/series/time", H5P_DEFAULT));
        Values values = values_of(time.id);
        values.back() *= 2;
        write_values(time.id, values);
      },
      "record.h5");
  expect_refusal_with("seal e.h5 -o new.h5 -f", kFailed, "e.h5: /series/time holds ");
}

TEST_F(Seal, refuses_what_readers_would_refuse) {
  const auto expect_refused = [&](const std::function<void(hid_t)>& change, const char* sentence) {
    edit(change);
    expect_refusal("seal e.h5 -o new.h5", kFailed, std::string("e.h5: ") + sentence);
  };
  const auto set = [](hid_t file, const char* name, double value) {
    const Opened dataset(H5Dopen2(file, name, H5P_DEFAULT));
    Values values = values_of(dataset.id);
    values[0] = value;
    write_values(dataset.id, values);
  };
  expect_refused(
      [&](hid_t file) { set(file, "/parameters/junctions/mu_s", -1); },
      "junctions.mu_s = -1 is out of range: give a value above 0 and at most 100 (unit 1)");
  expect_refused([&](hid_t file) { set(file, "/state/u_x", std::nan("")); },
                 "/state/u_x holds nan at index 0 of [5][9]; only finite numbers are stored");
  expect_refused(
      [](hid_t file) {
        const Opened dataset(H5Dopen2(file, "/state/u_x", H5P_DEFAULT));
        set_text(dataset.id, "unit", "mm");
      },
      "/state/u_x is in mm; expected m");
  expect_refused([](hid_t file) { replace_u_x(file, H5T_IEEE_F32LE); },
                 "/state/u_x holds float32 of shape [5][9]; expected float64 of shape [5][9]");
  expect_refused([](hid_t file) { H5Ldelete(file, "/state/u_x", H5P_DEFAULT); },
                 "/state/u_x is missing; expected float64 of shape [5][9]");
  expect_refused(
      [](hid_t file) {
        EXPECT_GE(H5Lcreate_hard(file, "/state/u_x", file, "/mine", H5P_DEFAULT, H5P_DEFAULT), 0);
      },
      "/mine is not part of a checkpoint: use a newer rupture, or remove it if another program "
      "added it");
}

TEST_F(Seal, refuses_other_files) {
  const std::string good = read("good.h5");
  expect_refusal("seal good.h5 -o new.h5", kFailed,
                 "good.h5 is sealed and intact: there is nothing to do");
  expect_refusal_with("seal small.ini -o new.h5", kFailed, "it is no HDF5 file, or damaged");
  write("e.h5", good.substr(0, good.size() / 2));
  expect_refusal_with("seal e.h5 -o new.h5", kFailed, "truncated file");
  edit(edit_attachment);
  expect_refusal("seal e.h5 -o e.h5 -f", kUsage,
                 "e.h5 is the input, which is never changed: give another output");
  output_of("load --config small.ini -o other.h5 -q");
  expect_refusal("seal e.h5 -o new.h5 --original other.h5", kFailed,
                 "other.h5 is not the original of e.h5: its content checksum is " +
                     checksum_of("other.h5") + ", not " + checksum_of("good.h5"));
}

/// A file with changed bytes in its HDF5 part behind a seal that fits, as if rupture had written
/// it.
std::string resealed(std::string file, std::size_t at, char value) {
  file[kHeaderSize + at] = value;
  const auto body = std::as_bytes(std::span(file)).subspan(kHeaderSize);
  return header_text(FileKind::checkpoint, body) + file.substr(kHeaderSize);
}

// Each makes libhdf5 1.10.8 read beyond its memory.
TEST_F(Seal, of_a_file_that_crashes_the_library_is_one_sentence) {
  const fs::path kept = fs::path(__FILE__).parent_path() / "../compatibility/schema-3/reference.h5";
  if (!fs::exists(kept)) GTEST_SKIP() << "the sources are elsewhere";
  fs::copy_file(kept, path("kept.h5"));
  const std::vector<std::pair<std::size_t, char>> deadly = {
      {13492, 2}, {7143, '\x80'}, {9660, 2}, {18764, 2}};
  for (const auto& [at, value] : deadly) {
    write("e.h5", resealed(read("kept.h5"), at, value));
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
