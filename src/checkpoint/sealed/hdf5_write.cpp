#include <hdf5.h>

#include "checkpoint/content/context.hpp"
#include "checkpoint/sealed/hdf5.hpp"

namespace rupture::hdf5 {
namespace {

static_assert(std::is_same_v<Id, hid_t> && std::is_same_v<int, herr_t>);

// Walking up starts at the innermost error; the first line is the reason.
herr_t keep_innermost(unsigned n, const H5E_error2_t* error, void* reason) {
  if (n == 0 && error->desc != nullptr) *static_cast<std::string*>(reason) = error->desc;
  return 0;
}

constexpr std::size_t kCompactLimit = 1024;  // [bytes] smaller datasets live in their header
constexpr const char* kProvenance = "/provenance/";
constexpr std::size_t kLongestLinked = 40;  // [bytes] a link takes that much itself

// Provenance grows for ever, group by group: in the form that needs least room.
Handle group_creation_properties(const std::string& path) {
  Handle properties(H5Pcreate(H5P_GROUP_CREATE), "prepare a group");
  check(H5Pset_obj_track_times(properties, false), "switch off times");
  if (path.starts_with(kProvenance)) {
    check(H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED), "choose a compact group");
  }
  return properties;
}

Handle create_space(const Shape& shape) {
  if (shape.empty()) return {H5Screate(H5S_SCALAR), "create a scalar"};
  const std::vector<hsize_t> lengths(shape.begin(), shape.end());
  return {H5Screate_simple(static_cast<int>(lengths.size()), lengths.data(), nullptr),
          "create an array"};
}

void write_attribute(Id object, const std::string& name, Id type, Id space, const void* value) {
  const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                         fmt::format("create the attribute {}", name));
  check(H5Awrite(attribute, type, value), fmt::format("write {}", name));
}

void write_attribute(Id object, const std::string& name, const Dataset& value) {
  write_attribute(object, name, stored_type(value.type, value.bytes.size()),
                  create_space(value.shape), value.bytes.data());
}

void create_groups(Id file, const std::string& path) {
  for (std::size_t end = path.find('/', 1); end != std::string::npos;
       end = path.find('/', end + 1)) {
    const std::string group = path.substr(0, end);
    const std::string doing = fmt::format("create the group {}", group);
    const auto exists = H5Lexists(file, group.c_str(), H5P_DEFAULT);
    check(exists, doing);
    if (exists > 0) continue;
    const Handle properties = group_creation_properties(group);
    const Handle created(H5Gcreate2(file, group.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT),
                         doing);
  }
}

void write_dataset(Id file, const std::string& path, const Dataset& data) {
  const std::string doing = fmt::format("write {}", path);
  const Handle type = stored_type(data.type, data.bytes.size());
  const Handle space = create_space(data.shape);
  const std::size_t expected = element_count(data.shape) * H5Tget_size(type);
  if (data.bytes.size() != expected) {
    fail("{} has {} bytes, but its shape {} needs {}", path, data.bytes.size(),
         shape_text(data.shape), expected);
  }
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), "prepare a dataset");
  check(H5Pset_obj_track_times(properties, false), "switch off times");
  check(H5Pset_dset_no_attrs_hint(properties, true), "leave no gaps");
  if (data.bytes.size() <= kCompactLimit) check(H5Pset_layout(properties, H5D_COMPACT), doing);
  const Handle dataset(
      H5Dcreate2(file, path.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT), doing);
  write_attribute(dataset, "unit", make_text(data.unit));
  if (!data.bytes.empty()) {
    check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.bytes.data()), doing);
  }
}

void write_content(Id file, const Content& content) {
  std::map<std::vector<std::byte>, std::string> texts;
  std::string group;
  for (const auto& [path, dataset] : content) {
    if (const auto in = path.substr(0, path.rfind('/') + 1); in != group) {
      create_groups(file, group = in);
    }
    const bool may_repeat = path.starts_with(kProvenance) && dataset.bytes.size() <= kLongestLinked;
    const auto first = may_repeat ? texts.try_emplace(dataset.bytes, path).first->second : path;
    if (first == path) {
      write_dataset(file, path, dataset);
    } else {
      check(H5Lcreate_hard(file, first.c_str(), file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT),
            "write " + path);
    }
  }
}

// --- attributes `units` and `long_name` of the CF conventions, and HDF5's dimension scales
//
// H5DSattach_scale of hdf5_hl would leave four bytes of each entry of a REFERENCE_LIST as they
// happen to be in memory. Here equal contents give equal bytes.

constexpr const char* kLabelling = "label a dataset";

// A dataset that goes along a scale, as an entry of that scale's REFERENCE_LIST.
struct [[gnu::packed]] User {
  hobj_ref_t dataset;
  std::int32_t dimension;
};

Handle open(Id file, const std::string& path) {
  return {H5Dopen2(file, path.c_str(), H5P_DEFAULT), kLabelling};
}

hobj_ref_t reference_to(Id file, const std::string& path) {
  hobj_ref_t reference{};
  check(H5Rcreate(&reference, file, path.c_str(), H5R_OBJECT, -1), kLabelling);
  return reference;
}

// With a null at the end: h5netcdf takes texts of length 1 for bytes.
void write_text(Id object, const char* name, const std::string& text) {
  const Handle type(H5Tcopy(H5T_C_S1), kLabelling);
  check(H5Tset_size(type, text.size() + 1), kLabelling);
  write_attribute(object, name, type, create_space({}), text.c_str());
}

// In the dataset: for each dimension a list of the one scale that belongs to it.
void write_dimension_list(Id dataset, std::vector<hobj_ref_t> scales) {
  std::vector<hvl_t> lists;
  for (hobj_ref_t& scale : scales) lists.push_back({1, &scale});
  const Handle type(H5Tvlen_create(H5T_STD_REF_OBJ), kLabelling);
  write_attribute(dataset, "DIMENSION_LIST", type, create_space({lists.size()}), lists.data());
}

// In the scale: who goes along it.
void write_reference_list(Id scale, const std::vector<User>& users) {
  const Handle type(H5Tcreate(H5T_COMPOUND, sizeof(User)), kLabelling);
  check(H5Tinsert(type, "dataset", offsetof(User, dataset), H5T_STD_REF_OBJ), kLabelling);
  check(H5Tinsert(type, "dimension", offsetof(User, dimension), H5T_STD_I32LE), kLabelling);
  write_attribute(scale, "REFERENCE_LIST", type, create_space({users.size()}), users.data());
}

void write_scale(Id file, const std::string& path, const std::vector<User>& users) {
  const Handle scale = open(file, path);
  write_text(scale, "CLASS", "DIMENSION_SCALE");
  write_text(scale, "NAME", path.substr(path.rfind('/') + 1));
  if (!users.empty()) write_reference_list(scale, users);
}

// Of datasets that were written before. Nothing of ours reads them.
void write_labels(Id file, const Content& content, const Labels& labels) {
  std::map<std::string, std::vector<User>> scales;
  for (const auto& [path, label] : labels) {
    const Handle dataset = open(file, path);
    write_text(dataset, "units", content.at(path).unit);
    write_text(dataset, "long_name", label.long_name);
    if (label.axes == std::vector{path}) {
      scales[path];
      continue;
    }
    std::vector<hobj_ref_t> along;
    for (const std::string& axis : label.axes) {
      scales[axis].push_back({reference_to(file, path), static_cast<std::int32_t>(along.size())});
      along.push_back(reference_to(file, axis));
    }
    if (!along.empty()) write_dimension_list(dataset, std::move(along));
  }
  for (const auto& [path, users] : scales) write_scale(file, path, users);
}

// --- the file

// HDF5's oldest format, its default: newer ones have a checksum in their first block, which
// H5Fget_file_image leaves wrong up to HDF5 1.14.5 (HDFGroup/hdf5 pull request 5489).
Handle create_file_in_memory() {
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), "prepare a file");
  check(H5Pset_obj_track_times(creation, false), "switch off times");
  check(H5Pset_userblock(creation, kHeaderSize), "leave room for the header");
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), "prepare a file");
  check(H5Pset_fapl_core(access, kGrowth, false), "create a file in memory");
  return {H5Fcreate(kNoFile, H5F_ACC_TRUNC, creation, access), "create a file in memory"};
}

// HDF5 hands out its part of the file without the user block in front.
std::vector<std::byte> image_of(Id file) {
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), "complete the file in memory");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  check(size, "measure the file in memory");
  std::vector<std::byte> bytes(kHeaderSize + static_cast<std::size_t>(size));
  check(H5Fget_file_image(file, bytes.data() + kHeaderSize, static_cast<std::size_t>(size)),
        "copy the file from memory");
  return bytes;
}

}  // namespace

void check(std::int64_t result, std::string_view doing) {
  if (result >= 0) return;
  std::string reason = "unknown reason";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &reason);
  throw LibraryFailure("cannot {}: {}", doing, reason);
}

Handle::~Handle() {
  if (id_ > kNone) H5Idec_ref(id_);
}

void prepare() {
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Handle stored_type(DataType type, std::size_t text_length) {
  const std::array<Id, 7> types = {H5T_IEEE_F64LE, H5T_IEEE_F32LE, H5T_STD_I64LE, H5T_STD_U32LE,
                                   H5T_STD_U16LE,  H5T_STD_U8LE,   H5T_C_S1};
  Handle copy(H5Tcopy(types.at(static_cast<std::size_t>(type))), "choose a type");
  if (type != DataType::text) return copy;
  check(H5Tset_size(copy, text_length), "set the length of a text");
  check(H5Tset_strpad(copy, H5T_STR_NULLPAD), "set the padding of a text");
  check(H5Tset_cset(copy, H5T_CSET_UTF8), "set the encoding of a text");
  return copy;
}

std::vector<std::byte> make_image(const RootAttributes& attributes, const Content& content,
                                  const Labels& labels) {
  prepare();
  const Handle file = create_file_in_memory();
  write_attribute(file, "format", make_text(attributes.format));
  write_attribute(file, "schema_version", make_scalar(attributes.schema_version, "1"));
  write_attribute(file, "content_checksum", make_text(attributes.content_checksum));
  if (!attributes.note.empty()) write_attribute(file, "note", make_text(attributes.note));
  write_content(file, content);
  write_labels(file, content, labels);
  return image_of(file);
}

}  // namespace rupture::hdf5
