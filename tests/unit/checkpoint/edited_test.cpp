// Files that another program changed: what is read of them, and what is sealed of that.
#include "rupture/checkpoint/edited.hpp"

#include <hdf5.h>

#include <array>
#include <functional>

#include "../../../src/checkpoint/hdf5_handle.hpp"
#include "fixtures.hpp"
#include "rupture/checkpoint/checksum.hpp"

namespace rupture {
namespace {

using hdf5::check;
using hdf5::Handle;
using testing::failure_of;
namespace fs = std::filesystem;

const ProvenanceEntry kEntry = {"seal",       "0.3.0", "abc",         "seal e.h5",
                                "gcc 12.2.0", "",      kEditedOutside};

class Edited : public testing::InFolder {
 protected:
  Edited() {
    Checkpoint checkpoint = testing::small_checkpoint();
    checkpoint.run = {.first_step = 1, .last_break = 2, .ruptures = 3};
    checksum_ = write_checkpoint(file("e.h5"), checkpoint, IfExists::refuse);
    hdf5::prepare();
  }

  /// Changes e.h5 through HDF5, as other programs do; its header does not fit any more.
  void edit(const std::function<void(hid_t)>& change) const {
    const Handle opened(H5Fopen(file("e.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, "open");
    change(opened);
  }

  EditedFile read() const { return read_edited(file("e.h5")); }

  void write_record() const {
    RecordWriter writer(file("e.h5"), testing::small_parameters(), {}, IfExists::replace);
    for (int n = 0; n < 3; ++n) writer.append(testing::small_sample(5, n));
    writer.finish();
  }

  std::string checksum_;
};

Handle opened(hid_t file, const char* path) {
  return {H5Dopen2(file, path, H5P_DEFAULT), H5Dclose, "open a dataset"};
}

void set_u_x(hid_t file, double value) {
  const Handle dataset = opened(file, "/state/u_x");
  const std::vector<double> values(20, value);
  check(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
        "write");
}

/// The same numbers in chunks, compressed, without unit.
void repack_u_x(hid_t file) {
  std::array<double, 20> values{};
  {
    const Handle before = opened(file, "/state/u_x");
    check(H5Dread(before, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read");
  }
  check(H5Ldelete(file, "/state/u_x", H5P_DEFAULT), "delete");
  const std::array<hsize_t, 2> shape = {4, 5}, chunk = {2, 2};
  const Handle space(H5Screate_simple(2, shape.data(), nullptr), H5Sclose, "shape");
  const Handle packing(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "prepare");
  check(H5Pset_chunk(packing, 2, chunk.data()), "cut");
  check(H5Pset_deflate(packing, 9), "compress");
  const Handle after(
      H5Dcreate2(file, "/state/u_x", H5T_IEEE_F64LE, space, H5P_DEFAULT, packing, H5P_DEFAULT),
      H5Dclose, "create");
  check(H5Dwrite(after, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "write");
}

TEST_F(Edited, file_that_is_intact_is_as_sealed) {
  const EditedFile file = read();
  EXPECT_EQ(file.name, this->file("e.h5").string());
  EXPECT_EQ(file.kind, FileKind::checkpoint);
  EXPECT_EQ(file.sealed_checksum, checksum_);
  EXPECT_EQ(file.checksum, checksum_);
  EXPECT_TRUE(file.content_is_as_sealed);
  EXPECT_EQ(content_checksum(file.content), checksum_);
}

TEST_F(Edited, file_that_was_repacked_is_as_sealed) {
  edit(repack_u_x);
  const EditedFile file = read();
  EXPECT_TRUE(file.content_is_as_sealed);
  EXPECT_EQ(file.checksum, checksum_);
}

TEST_F(Edited, file_with_other_values_has_both_checksums) {
  edit([](hid_t file) { set_u_x(file, 1e-6); });
  const EditedFile file = read();
  EXPECT_FALSE(file.content_is_as_sealed);
  EXPECT_EQ(file.sealed_checksum, checksum_);
  EXPECT_EQ(file.checksum, content_checksum(file.content));
  EXPECT_NE(file.checksum, checksum_);
  EXPECT_EQ(read_array<double>(file.content, "/state/u_x", {4, 5})[7], 1e-6);
}

TEST_F(Edited, file_without_its_checksum_is_not_as_sealed) {
  edit([](hid_t file) { check(H5Adelete(file, "content_checksum"), "delete"); });
  const EditedFile file = read();
  EXPECT_EQ(file.sealed_checksum, "");
  EXPECT_EQ(file.checksum, checksum_);
  EXPECT_FALSE(file.content_is_as_sealed);
}

TEST_F(Edited, record_is_a_record) {
  write_record();
  EXPECT_EQ(read().kind, FileKind::record);
}

TEST_F(Edited, files_of_others_are_refused_by_name) {
  const std::string name = file("e.h5").string();
  const auto expect_refused = [&](const std::string& sentence) {
    EXPECT_EQ(failure_of([&] { read(); }).find(name + sentence), 0U) << failure_of([&] { read(); });
  };
  testing::spill(file("e.h5"), "no HDF5");
  expect_refused(": could not open the HDF5 part of the file: ");
  testing::spill(file("e.h5"), "");
  expect_refused(" is empty; expected a checkpoint or record");
  fs::remove(file("e.h5"));
  expect_refused(" does not exist; give the path of a checkpoint or record");
  {
    const Handle made(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose,
                      "create");
  }
  expect_refused(": format is missing; expected text");
}

// It makes libhdf5 1.10.8 read beyond its memory; other versions refuse it.
TEST_F(Edited, file_that_crashes_the_library_is_refused) {
  const fs::path kept =
      fs::path(__FILE__).parent_path() / "../../compatibility/schema-3/reference.h5";
  if (!fs::exists(kept)) GTEST_SKIP() << "the sources are elsewhere";
  std::string bytes = testing::slurp(kept);
  bytes[kHeaderSize + 13492] = 2;
  testing::spill(file("e.h5"), bytes);
  const std::string refusal = failure_of([&] { read(); });
  EXPECT_EQ(refusal.find(file("e.h5").string() + ": "), 0U) << refusal;
}

TEST_F(Edited, content_is_sealed_with_the_entry_at_the_end) {
  const EditedFile file = read();
  const Content content = checked_content(file, kEntry);
  const auto chain = read_provenance(content);
  ASSERT_EQ(chain.size(), 3U);
  EXPECT_EQ(chain[1].tool, "restart");
  EXPECT_EQ(chain[2].tool, "seal");
  EXPECT_EQ(chain[2].rebuild, kEditedOutside);
  EXPECT_EQ(content_checksum(content), checksum_);
}

TEST_F(Edited, checkpoint_forgets_its_run) {
  const Content content = checked_content(read(), kEntry);
  for (const auto& [path, dataset] : content) EXPECT_FALSE(path.starts_with("/run/")) << path;
}

TEST_F(Edited, checkpoint_gets_its_units_back) {
  edit(repack_u_x);
  EXPECT_EQ(read().content.at("/state/u_x").unit, "");
  EXPECT_EQ(checked_content(read(), kEntry).at("/state/u_x").unit, "m");
}

TEST_F(Edited, record_without_a_unit_is_refused) {
  write_record();
  EXPECT_EQ(read_provenance(checked_content(read(), kEntry)).size(), 1U);
  edit([](hid_t file) {
    check(H5Adelete_by_name(file, "/series/tau", "unit", H5P_DEFAULT), "delete");
  });
  EXPECT_EQ(failure_of([&] { checked_content(read(), kEntry); }),
            file("e.h5").string() + ": /series/tau has the unit ''; expected 'N'");
}

TEST_F(Edited, content_that_readers_would_refuse_is_not_sealed) {
  edit([](hid_t file) {
    const Handle dataset = opened(file, "/parameters/junctions/mu_s");
    const double below = -1.0;
    check(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, &below), "write");
  });
  const std::string refusal = failure_of([&] { checked_content(read(), kEntry); });
  EXPECT_EQ(refusal.find(file("e.h5").string() + ": junctions.mu_s = -1 is out of range"), 0U)
      << refusal;
}

}  // namespace
}  // namespace rupture
