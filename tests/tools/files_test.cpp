// Files that are missing, foreign, damaged or changed by other programs: what all programs say.
#include "file_rows.hpp"
#include "rupture/version.hpp"

namespace rupture::testing {
namespace {

using Commands = std::vector<std::string>;
const Commands kReadersOfCheckpoints = {"restart --for 1e-5 -o out.h5", "modify-phi -o out.h5",
                                        "analyze stress", "analyze phi"};
const Commands kReadersOfRecords = {"analyze events", "analyze front", "analyze classify",
                                    "analyze slip --x 0", "analyze loading"};
const Commands kReadersOfBoth = {"analyze checksum", "analyze show", "analyze lineage",
                                 "analyze diff good.h5"};

Commands operator+(Commands a, const Commands& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

constexpr const char* kDamaged =
    " is damaged: its bytes and the SHA-256 in its header do not agree; copy it again or write it "
    "anew";
constexpr const char* kNotOurs =
    " is not a rupture file: expected the 512-byte header of a checkpoint or record; give a file "
    "that one of rupture's tools wrote";
constexpr const char* kNoHeader =
    " is an HDF5 file without rupture's 512-byte header: it was not written by rupture, or was "
    "rewritten by another program; give the original file, or try rupture seal x.h5 -o NEW.h5";
constexpr const char* kOtherContent =
    " was changed after rupture sealed it, and its content is not what it was: if somebody edited "
    "it with another program, rupture seal x.h5 -o NEW.h5 checks and seals it; otherwise it is "
    "damaged, copy it again or write it anew";
constexpr const char* kSameContent =
    " was changed after rupture sealed it (repacked by another program, an attribute added, or "
    "damaged beside its data), but its content still has the checksum that is stored in it: "
    "rupture seal x.h5 -o NEW.h5 makes a sealed file of it";
constexpr const char* kNoHdf5 =
    ": could not open the HDF5 part of the file: ...; it is no HDF5 file, or damaged: copy it "
    "again or write it anew";
constexpr const char* kShort =
    ": could not open the HDF5 part of the file: truncated file...; it is no HDF5 file, or "
    "damaged: copy it again or write it anew";
constexpr const char* kNoFormat =
    ": format is missing; expected text, as in every file that one of rupture's programs wrote";

std::string truncated(std::size_t size, std::size_t whole) {
  return " is truncated: it holds " + std::to_string(size) + " of " + std::to_string(whole) +
         " bytes; copy it again or write it anew";
}
std::string within_header(std::size_t size) {
  return " is truncated: it ends within its 512-byte header, after " + std::to_string(size) +
         " bytes; copy it again or write it anew";
}

TEST_F(AnyFile, that_is_missing_or_foreign_is_refused_by_every_program) {
  write_checkpoint_file();
  const auto replace = [](const std::function<void(const fs::path&)>& make) -> Change {
    return [=](const fs::path& file) {
      fs::remove(file);
      make(file);
    };
  };
  expect_rows(
      kReadersOfBoth + kReadersOfCheckpoints + kReadersOfRecords,
      {{replace([](const auto&) {}), " does not exist; give the path of a checkpoint or record"},
       {replace([](const auto& file) { fs::create_directory(file); }),
        " is a folder; give the path of a checkpoint or record"},
       {replace([](const auto& file) { fs::create_symlink("/dev/null", file); }),
        " is not a regular file; give the path of a checkpoint or record"},
       {cut(0), " is empty; expected a checkpoint or record"},
       {bytes([](const auto&) { return "PNG or whatever"; }), kNotOurs, kNoHdf5},
       {bytes([](const auto&) { return std::string(2000, 'x'); }), kNotOurs, kNoHdf5},
       {flip(0), kNotOurs, kSealed},
       {bytes([](const auto& file) { return file.substr(kHeaderSize); }), kNoHeader, kSealed},
       {replace([](const fs::path& file) {
          Opened(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
        }),
        kNoHeader, kNoFormat},
       {cut(1), within_header(1), kNoHdf5},
       {cut(511), within_header(511), kNoHdf5}});
}

TEST_F(AnyFile, that_is_damaged_is_refused_by_every_program) {
  write_checkpoint_file();
  const std::size_t whole = fs::file_size(path("good.h5")), half = whole / 2;
  expect_rows(
      kReadersOfBoth + kReadersOfCheckpoints,
      {{cut(513), truncated(513, whole), kNoHdf5},
       {cut(half), truncated(half, whole), kShort},
       {cut(whole - 1), truncated(whole - 1, whole), kShort},
       {flip(25), kDamaged, kSealed},  // the size in the header
       {flip(300), kDamaged, kSealed},
       {flip(511), kDamaged, kSealed},
       {flip(kHeaderSize), kDamaged, kNoHdf5},
       {bytes([](const std::string& file) { return file + '\0'; }), kSameContent, kSealed}});
}

TEST_F(AnyFile, of_a_newer_build_is_refused_by_every_program) {
  write_checkpoint_file();
  const std::string newer = " (schema " + std::to_string(kSchemaVersion + 1) +
                            "); this is rupture " + std::string(version) +
                            ", which reads up to schema " + std::to_string(kSchemaVersion);
  const auto of_newer = [](hid_t file) { set_schema(file, kSchemaVersion + 1); };
  const Change unreadable = resealed(set_last(kPath, std::nan("")));  // which nobody reads
  expect_rows(
      kReadersOfBoth + kReadersOfCheckpoints,
      {{all({unreadable, resealed(remove("/provenance")), resealed(of_newer)}),
        ": written by a newer rupture" + newer + ": use a newer rupture"},
       {all({set("/provenance/0001/version", make_text("0.9.0")), unreadable, resealed(of_newer)}),
        ": written by rupture 0.9.0" + newer + ": use rupture 0.9.0 or newer"},
       // Its checksum is that of the newer build, in which the parameter does not count.
       {resealed(link("/parameters/junctions/mu_s", "/parameters/junctions/new")),
        ": /parameters/junctions/new is no parameter of this build: use a newer rupture"}});
}

TEST_F(AnyFile, of_the_other_kind_is_refused) {
  write_checkpoint_file();
  fs::copy_file(path("good.h5"), path("x.h5"));
  for (const auto& reader : kReadersOfRecords) {
    expect_said(reader + " x.h5", " is a checkpoint; expected a record");
  }
  expect_said("seal x.h5 -o new.h5", " is sealed and intact: there is nothing to do");
  write_record_file();
  fs::copy_file(path("good.h5"), path("x.h5"), fs::copy_options::overwrite_existing);
  for (const auto& reader : kReadersOfCheckpoints) {
    expect_said(reader + " x.h5", " is a record; expected a checkpoint");
  }
  expect_said("seal x.h5 -o new.h5", " is sealed and intact: there is nothing to do");
  expect_refusal("analyze stress x.h5/y.h5", kFailed,
                 "x.h5/y.h5 does not exist; give the path of a checkpoint or record");
}

TEST_F(AnyFile, that_another_program_changed_is_refused_until_it_is_sealed) {
  write_checkpoint_file();
  expect_rows(
      {kOfCheckpoint},
      {{edited(comment), kSameContent, kSealed},
       {edited(replaced(H5T_IEEE_F64LE, {4, 5}, compressed, true)), kSameContent, kSealed},
       {edited(
            [](hid_t file) { set_text(Opened(H5Dopen2(file, kPath, H5P_DEFAULT)), "unit", "mm"); }),
        kSameContent, ": /state/u_x is in mm; expected m"},
       {edited(link(kPath, "/mine")), kSameContent,
        ": /mine is not part of a checkpoint: use a newer rupture, or remove it if another program "
        "added it"},
       {edited([](hid_t file) { H5Adelete(file, "content_checksum"); }), kOtherContent, kSealed},
       {edited(set_last(kPath, 1e-6)), kOtherContent, kSealed},
       {edited(set_last(kPath, std::nan(""))), kOtherContent,
        ": /state/u_x holds nan at index 19 of [4][5]; only finite numbers are stored"},
       {edited(set_last("/parameters/junctions/mu_s", -1)), kOtherContent,
        ": junctions.mu_s = -1 is out of range: give a value above 0 and at most 100 (unit 1)"},
       {edited(replaced(H5T_IEEE_F32LE, {4, 5}, compressed, true)), kOtherContent,
        ": /state/u_x holds float32 of shape [4][5]; expected float64 of shape [4][5]"},
       {edited(remove(kPath)), kOtherContent,
        ": /state/u_x is missing; expected float64 of shape [4][5]"}});
  write_record_file();
  expect_rows(
      {kOfRecord},
      {{flip(kHeaderSize), kDamaged, kNoHdf5},
       {edited(comment), kSameContent, kSealed},
       {edited(set_last("/series/time", 1)), kOtherContent,
        ": /series/time holds 1 at step 400; by the parameters it is 0.004 there"},
       {edited([](hid_t file) { H5Adelete_by_name(file, "/series/tau", "unit", H5P_DEFAULT); }),
        kSameContent, ": /series/tau has the unit ''; expected 'N'"}});
}

// Seven groups, each of which holds the next one a hundred times: 10^14 ways to the last.
void add_many_ways(hid_t file) {
  for (int depth = 0; depth < 7; ++depth) {
    const std::string name = "/g" + std::to_string(depth), below = "/g" + std::to_string(depth - 1);
    const Opened group(H5Gcreate2(file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    for (int n = 0; depth > 0 && n < 100; ++n) {
      link(below.c_str(), (name + "/" + std::to_string(n)).c_str())(file);
    }
  }
}

// What libhdf5 reads well, but rupture never writes, before much memory is taken.
TEST_F(AnyFile, whose_HDF5_part_another_program_made_is_refused_behind_a_header_that_fits) {
  write_checkpoint_file();
  const hsize_t large = hsize_t{1} << 58U, factor = hsize_t{1} << 29U, two = 2;
  const Opened long_text(H5Tcopy(H5T_C_S1)), of_any_length(H5Tcopy(H5T_C_S1)),
      compound(H5Tcreate(H5T_COMPOUND, 8)), words(H5Tenum_create(H5T_STD_I64LE)),
      opaque(H5Tcreate(H5T_OPAQUE, 8)), list(H5Tvlen_create(H5T_IEEE_F64LE)),
      pair(H5Tarray_create2(H5T_IEEE_F64LE, 1, &two));
  const std::int64_t zero = 0;
  EXPECT_GE(H5Tset_size(long_text, std::size_t{1} << 31U), 0);
  EXPECT_GE(H5Tset_strpad(long_text, H5T_STR_NULLPAD) + H5Tset_cset(long_text, H5T_CSET_UTF8), 0);
  EXPECT_GE(H5Tset_size(of_any_length, H5T_VARIABLE), 0);
  EXPECT_GE(H5Tinsert(compound, "member", 0, H5T_IEEE_F64LE), 0);
  EXPECT_GE(H5Tenum_insert(words, "zero", &zero), 0);
  Rows rows = {
      {resealed(replaced(H5T_IEEE_F64LE, {large})),
       ": /state/u_x claims [288230376151711744] elements of 8 bytes, more than the file can hold"},
      {resealed(replaced(H5T_IEEE_F64LE, {factor, factor})),
       ": /state/u_x claims [536870912][536870912] elements of 8 bytes, more than the file can "
       "hold"},
      {resealed(added("/long", long_text, H5S_SCALAR)),
       ": /long claims [1] elements of 2147483648 bytes, more than the file can hold"},
      {resealed(replaced(H5T_IEEE_F64LE, {4, 5, 1})),
       ": /state/u_x holds 0 bytes, but its shape [4][5][1] needs 160",
       ": /state/u_x holds float64 of shape [4][5][1]; expected float64 of shape [4][5]"},
      {stored({}), ": /state/u_x holds 0 bytes, but its shape [4][5] needs 160", kSealed},
      {resealed(added("/none", H5T_IEEE_F64LE, H5S_NULL)),
       ": /none is empty, without even a shape, which rupture never writes"},
      {resealed([](hid_t file) {
         H5Lcreate_soft("/state/u_x", file, "/state/link", H5P_DEFAULT, H5P_DEFAULT);
       }),
       ": /state/ holds a symbolic link, which rupture never writes"},
      {resealed([](hid_t file) {
         H5Lcreate_external("/etc/passwd", "/", file, "link", H5P_DEFAULT, H5P_DEFAULT);
       }),
       ": / holds a symbolic link, which rupture never writes"},
      {resealed(link("/state", "/state/again")), ": ...again/ is too deep a group"},
      {resealed(link("/", "/state/again")), ": ... is too deep a group"},
      {resealed(add_many_ways), ": ... and what comes before it need more than the file holds"},
      {resealed([](hid_t file) {
         const Opened type(H5Tcopy(H5T_IEEE_F64LE));
         H5Tcommit2(file, "/type", type, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
       }),
       ": /type is neither a group nor a dataset"},
      {resealed([](hid_t file) { set_number(file, kPath, "unit"); }),
       ": the attribute unit of /state/u_x holds one uint32; expected text"},
      {resealed([](hid_t file) { set_number(file, "/", "format"); }),
       ": format holds one uint32; expected text"},
      {resealed([](hid_t file) { set_number(file, "/", "schema_version"); }),
       ": schema_version holds one uint32; expected one int64"},
      {resealed([](hid_t file) { H5Adelete(file, "format"); }), kNoFormat},
      {resealed([](hid_t file) { set_text(file, "format", "rupture-record"); }),
       ": its header says rupture-checkpoint, but its attributes say rupture-record, schema "
       "version 3; write it anew",
       ": /state/drive/origin_position is not part of a record: use a newer rupture, or remove it "
       "if another program added it"},
      {resealed([](hid_t file) { set_text(file, "content_checksum", std::string(64, '0')); }),
       ": its content has the checksum ..., but 000...", kSealed},
      {resealed(remove(kPath)), ": its content has the checksum ..., but ...",
       ": /state/u_x is missing; expected float64 of shape [4][5]"},
      {resealed([](hid_t file) { H5Adelete_by_name(file, kPath, "unit", H5P_DEFAULT); }),
       ": could not read the attribute unit of /state/u_x: ...", kSealed},
      {resealed(set_last(kPath, std::nan(""))), ": /state/u_x holds nan at index 19 of [4][5]..."},
      {resealed(set_last(kPath, HUGE_VAL)), ": /state/u_x holds inf at index 19 of [4][5]..."},
      {resealed(set_last(kPath, -HUGE_VAL)), ": /state/u_x holds -inf at index 19 of [4][5]..."}};
  const std::string type =
                        ": /state/u_x has an element type that rupture never writes; it writes "
                        "texts and little-endian float64, int64, uint32, uint16 and uint8",
                    storage =
                        ": /state/u_x is not stored as rupture does, in one piece in this file";
  for (const hid_t other :
       {H5T_IEEE_F32BE, H5T_IEEE_F64BE, H5T_STD_I32LE, H5T_STD_U64LE, H5T_STD_I64BE,
        H5T_STD_REF_OBJ, H5T_STD_REF_DSETREG, H5T_STD_B64LE, hid_t{compound}, hid_t{words},
        hid_t{opaque}, hid_t{list}, hid_t{pair}}) {
    rows.push_back({resealed(replaced(other)), type});
  }
  rows.push_back({resealed(replaced(of_any_length)), type, ": /state/u_x is not one text"});
  rows.push_back({stored(chunked), storage, kSealed});
  rows.push_back({stored(compressed), storage, kSealed});
  rows.push_back({stored([](hid_t p) { H5Pset_external(p, "/dev/zero", 0, 160); }), storage});
  rows.push_back({stored([](hid_t p) {
                    const std::array<hsize_t, 2> lengths = {4, 5};
                    const Opened space(H5Screate_simple(2, lengths.data(), nullptr));
                    H5Pset_virtual(p, space, "other.h5", "/x", space);
                  }),
                  storage});
  expect_rows({kOfCheckpoint}, rows);
}

}  // namespace
}  // namespace rupture::testing
