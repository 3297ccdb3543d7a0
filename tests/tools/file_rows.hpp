// Rows "what was done to a file, and what readers, verify and seal say of it", and their runner.
// HDF5's C interface does here what h5py and MATLAB do through it.
#pragma once

#include <hdf5.h>

#include <array>
#include <cmath>
#include <functional>
#include <span>

#include "tool_test.hpp"
#include "unit/checkpoint/record_fixture.hpp"

namespace rupture::testing {

inline constexpr const char* kSealed = "(writes a file that is intact)";
inline constexpr const char* kSame = "(the same)";
inline constexpr const char* kPath = "/state/u_x";

using Change = std::function<void(const fs::path&)>;

/// "..." in a sentence stands for anything.
struct Row {
  Change change;
  std::string says;          ///< each reader, and verify, behind the name of the file
  std::string seal = kSame;  ///< seal, likewise
};
using Rows = std::vector<Row>;

/// Closes what HDF5 has opened, whatever it is.
class Opened {
 public:
  explicit Opened(hid_t opened) : id_(opened) { EXPECT_GE(id_, 0); }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
  ~Opened() { EXPECT_GE(H5Idec_ref(id_), 0); }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
};

inline Change bytes(const std::function<std::string(std::string)>& change) {
  return [=](const fs::path& file) { spill(file, change(slurp(file))); };
}
inline Change flip(std::size_t at) {
  return bytes([=](std::string whole) {
    whole[at] = static_cast<char>(whole[at] ^ 1);
    return whole;
  });
}
inline Change cut(std::size_t size) {
  return bytes([=](const std::string& whole) { return whole.substr(0, size); });
}

/// Through HDF5, as other programs do; the header does not fit any more.
inline Change edited(const std::function<void(hid_t)>& change) {
  return [=](const fs::path& file) {
    change(Opened(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT)));
  };
}
/// The same with a header that fits, as if rupture had written the file.
inline Change resealed(const std::function<void(hid_t)>& change) {
  return [=](const fs::path& file) {
    const FileKind kind = identify(file);
    edited(change)(file);
    const std::string body = slurp(file).substr(kHeaderSize);
    spill(file, header_text(kind, bytes_of(body)) + body);
  };
}
/// Written by rupture, with a checksum that fits.
inline Change content(const std::function<void(Content&)>& change) {
  return [=](const fs::path& file) {
    Content content = read_content(file);
    change(content);
    write_content(file, identify(file), content, IfExists::replace);
  };
}
inline Change set(const std::string& path, const Dataset& dataset) {
  return content([=](Content& c) { c[path] = dataset; });
}
inline Change without(const char* path) {
  return content([=](Content& c) { EXPECT_EQ(c.erase(path), 1U) << path; });
}
inline Change with_unit(const char* path, const char* unit) {
  return content([=](Content& c) { c.at(path).unit = unit; });
}
inline Change all(const std::vector<Change>& changes) {
  return [=](const fs::path& file) {
    for (const Change& change : changes) change(file);
  };
}

template <class T>
inline Dataset array(const std::vector<T>& values, const char* unit = "1") {
  return make_array(std::span(values), {values.size()}, unit);
}
using Reals = std::vector<double>;
using Integers = std::vector<std::int64_t>;

inline void set_attribute(hid_t object, const char* name, hid_t type, const void* value) {
  const Opened space(H5Screate(H5S_SCALAR));
  if (H5Aexists(object, name) > 0) H5Adelete(object, name);
  const Opened created(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT));
  EXPECT_GE(H5Awrite(created, type, value), 0);
}
inline void set_text(hid_t object, const char* name, const std::string& text) {
  const Opened type(H5Tcopy(H5T_C_S1));
  EXPECT_GE(H5Tset_size(type, text.size()), 0);
  EXPECT_GE(H5Tset_strpad(type, H5T_STR_NULLPAD) + H5Tset_cset(type, H5T_CSET_UTF8), 0);
  set_attribute(object, name, type, text.data());
}
/// As h5py does.
inline void comment(hid_t object) {
  const Opened type(H5Tcopy(H5T_C_S1));
  EXPECT_GE(H5Tset_size(type, H5T_VARIABLE), 0);
  const char* const text = "mine";
  set_attribute(object, "comment", type, &text);
}
inline void set_number(hid_t file, const char* object, const char* name) {
  const std::uint32_t value = 1;
  set_attribute(Opened(H5Oopen(file, object, H5P_DEFAULT)), name, H5T_STD_U32LE, &value);
}
inline void set_schema(hid_t file, std::int64_t version) {
  set_attribute(file, "schema_version", H5T_STD_I64LE, &version);
}

inline Reals values_of(hid_t dataset) {
  Reals values(static_cast<std::size_t>(H5Dget_storage_size(dataset)) / sizeof(double));
  EXPECT_GE(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  return values;
}
inline void write_values(hid_t dataset, const Reals& values) {
  EXPECT_GE(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
}
inline std::function<void(hid_t)> set_last(const char* path, double value) {
  return [=](hid_t file) {
    const Opened dataset(H5Dopen2(file, path, H5P_DEFAULT));
    Reals values = values_of(dataset);
    values.back() = value;
    write_values(dataset, values);
  };
}
inline std::function<void(hid_t)> remove(const char* path) {
  return [=](hid_t file) { EXPECT_GE(H5Ldelete(file, path, H5P_DEFAULT), 0); };
}
inline std::function<void(hid_t)> link(const char* from, const char* to) {
  return [=](hid_t file) {
    EXPECT_GE(H5Lcreate_hard(file, from, file, to, H5P_DEFAULT, H5P_DEFAULT), 0);
  };
}

using Storage = std::function<void(hid_t)>;
inline void chunked(hid_t properties) {
  const std::array<hsize_t, 2> chunk = {2, 5};
  EXPECT_GE(H5Pset_chunk(properties, 2, chunk.data()), 0);
}
inline void compressed(hid_t properties) {
  chunked(properties);
  EXPECT_GE(H5Pset_deflate(properties, 9), 0);
}

/// A dataset without unit in place of u_x, of the same numbers or of none.
inline std::function<void(hid_t)> replaced(hid_t type, const std::vector<hsize_t>& shape = {4, 5},
                                           const Storage& storage = {}, bool filled = false) {
  return [=](hid_t file) {
    const Reals values = values_of(Opened(H5Dopen2(file, kPath, H5P_DEFAULT)));
    remove(kPath)(file);
    const Opened properties(H5Pcreate(H5P_DATASET_CREATE));
    if (storage) storage(properties);
    const Opened space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr));
    const Opened after(H5Dcreate2(file, kPath, type, space, H5P_DEFAULT, properties, H5P_DEFAULT));
    if (filled) write_values(after, values);
  };
}
inline Change stored(const Storage& storage) {
  return resealed(replaced(H5T_IEEE_F64LE, {4, 5}, storage));
}
/// One more dataset.
inline std::function<void(hid_t)> added(const char* name, hid_t type, H5S_class_t space) {
  return [=](hid_t file) {
    const Opened shape(H5Screate(space));
    const Opened made(H5Dcreate2(file, name, type, shape, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  };
}

class AnyFile : public ToolTest {
 protected:
  static constexpr const char* kOfCheckpoint = "analyze stress";
  static constexpr const char* kOfRecord = "analyze loading";

  void write_checkpoint_file(const Checkpoint& checkpoint = small_checkpoint()) const {
    write_checkpoint(path("good.h5"), checkpoint, IfExists::replace);
  }

  /// Five samples, a rupture at the first and one at the last step, a crossing, fields.
  void write_record_file() const {
    RecordWriter out(path("good.h5"), small_parameters(), {}, IfExists::replace, {}, 8,
                     {.crossing_levels = {0.2, 0.5}, .fields = Fields::record});
    for (int n = 0; n < 5; ++n) out.append(small_sample(5, n));
    const std::vector<float> zeros(20);
    for (const int n : {0, 4}) out.append(FieldSample{0.001 * n, 100 * n, zeros, zeros});
    out.append(std::vector<rupture::Rupture>{{0, 0.0, 0}, {300, 0.003, 1, 0.5}, {400, 0.004, 4}});
    out.finish();
  }

  void expect_said(const std::string& command, const std::string& sentence) const {
    const auto before = files();
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.exit_code, kFailed) << command << ": " << outcome.out;
    const std::string tool = command.substr(0, command.find(' '));
    EXPECT_PRED2(matches, outcome.err, tool + ": x.h5" + sentence + "\n");
    EXPECT_TRUE(files() == before) << command;
    if (command != "analyze verify x.h5") return;
    const bool is_changed = sentence.starts_with(" was changed"),
               is_missing = sentence.starts_with(" does not exist");
    const std::string verdict = is_changed ? "changed" : is_missing ? "missing" : "damaged";
    EXPECT_EQ(outcome.out.find(verdict + "  x.h5"), 0U) << outcome.out;
    EXPECT_NE(outcome.out.find("\n1 " + verdict + "\n"), std::string::npos) << outcome.out;
  }

  void expect_sealed() const {
    EXPECT_EQ(run("seal x.h5 -o new.h5").exit_code, kDone);
    output_of("analyze verify new.h5");
    fs::remove(path("new.h5"));
  }

  void expect_rows(const std::vector<std::string>& readers, const Rows& rows) const {
    for (const Row& row : rows) {
      SCOPED_TRACE(row.says);
      fs::remove_all(path("x.h5"));
      fs::copy_file(path("good.h5"), path("x.h5"));
      row.change(path("x.h5"));
      for (const auto& reader : readers) expect_said(reader + " x.h5", row.says);
      if (!fs::is_directory(path("x.h5"))) expect_said("analyze verify x.h5", row.says);
      if (row.seal == kSealed) {
        expect_sealed();
      } else {
        expect_said("seal x.h5 -o new.h5", row.seal == kSame ? row.says : row.seal);
      }
    }
  }
};

}  // namespace rupture::testing
