#include <fmt/ranges.h>
#include <hdf5.h>

#include <functional>

#include "checkpoint/content/context.hpp"
#include "checkpoint/sealed/hdf5.hpp"

namespace rupture::hdf5 {
namespace {

constexpr int kDeepest = 8;  // levels of groups; stops at links that lead back to their own group
constexpr std::size_t kSmallestObject = 16;   // [bytes] less than the header of any object
constexpr std::size_t kLongestVersion = 100;  // [bytes]
constexpr std::size_t kCompression = 100;     // times that edited datasets may be packed

// "4-byte big-endian float".
std::string found_type(Id type) {
  constexpr std::array kinds = {"integer",  "float",     "time",        "text", "bits", "opaque",
                                "compound", "reference", "enumeration", "list", "array"};
  const H5T_order_t order = H5Tget_order(type);
  const char* is_ordered = order == H5T_ORDER_LE ? "little-endian " : "big-endian ";
  return fmt::format("{}-byte {}{}{}", H5Tget_size(type),
                     order == H5T_ORDER_LE || order == H5T_ORDER_BE ? is_ordered : "",
                     H5Tget_sign(type) == H5T_SGN_NONE ? "unsigned " : "",
                     kinds.at(static_cast<std::size_t>(H5Tget_class(type))));
}

DataType data_type(Id type, const std::string& path) {
  std::vector<std::string_view> numbers;
  for (const DataType candidate : kDataTypes) {
    if (H5Tequal(type, stored_type(candidate, H5Tget_size(type))) > 0) return candidate;
    if (candidate != DataType::text) numbers.push_back(type_name(candidate));
  }
  fail(
      "{} has elements that rupture never writes ({}); it writes texts and little-endian numbers "
      "({})",
      path, found_type(type), fmt::join(numbers, ", "));
}

Shape shape_of(Id space, const std::string& path) {
  if (H5Sget_simple_extent_type(space) == H5S_NULL) {
    fail("{} is empty, without even a shape, which rupture never writes", path);
  }
  const int rank = H5Sget_simple_extent_ndims(space);
  check(rank, fmt::format("read the shape of {}", path));
  std::vector<hsize_t> lengths(static_cast<std::size_t>(rank));
  check(H5Sget_simple_extent_dims(space, lengths.data(), nullptr),
        fmt::format("read the shape of {}", path));
  return {lengths.begin(), lengths.end()};
}

std::size_t byte_count(const Shape& shape, std::size_t element_size, std::size_t room,
                       const std::string& path) {
  if (const auto bytes = bytes_in(shape, element_size, room)) return *bytes;
  fail("{} claims {} elements of {} bytes, more than the file can hold", path,
       shape.empty() ? "[1]" : shape_text(shape), element_size);
}

// Type, shape and memory for the bytes, at most `room`, of a dataset or attribute.
Dataset described(Id type, Id space, std::size_t room, const std::string& path) {
  Dataset data{"", data_type(type, path), shape_of(space, path), {}};
  if (data.type == DataType::text && !data.shape.empty()) {
    fail("{} is an array of texts, which rupture never writes", path);
  }
  data.bytes.resize(byte_count(data.shape, H5Tget_size(type), room, path));
  return data;
}

// Reads a whole dataset or attribute as elements of a type.
using Read = std::function<std::int64_t(Id type, void* elements)>;

std::string text_of_any_length(Id type, const Read& read, const std::string& path) {
  const std::string doing = "read " + path;
  char* text = nullptr;
  check(read(type, &text), doing);
  std::string copy = text == nullptr ? "" : text;
  check(H5free_memory(text), doing);
  return copy;
}

std::string text_of_fixed_length(Id type, const Read& read, std::size_t room,
                                 const std::string& path) {
  const std::size_t length = byte_count({}, H5Tget_size(type), room, path);
  std::string text(length, '\0');
  check(read(type, text.data()), "read " + path);
  text.resize(text.find('\0') == std::string::npos ? length : text.find('\0'));
  if (H5Tget_strpad(type) == H5T_STR_SPACEPAD) text.resize(text.find_last_not_of(' ') + 1);
  return text;
}

// A text in any form that HDF5 knows, as the one in which rupture writes it.
Dataset edited_text(Id type, Id space, const Read& read, std::size_t room,
                    const std::string& path) {
  if (H5Sget_simple_extent_npoints(space) != 1) fail("{} is not one text", path);
  return make_text(H5Tis_variable_str(type) > 0 ? text_of_any_length(type, read, path)
                                                : text_of_fixed_length(type, read, room, path));
}

Dataset read_elements(Id type, Id space, const Read& read, std::size_t room, Accept accept,
                      const std::string& path) {
  if (accept == Accept::edited && H5Tget_class(type) == H5T_STRING) {
    return edited_text(type, space, read, room, path);
  }
  Dataset data = described(type, space, room, path);
  if (!data.bytes.empty()) check(read(type, data.bytes.data()), "read " + path);
  return data;
}

Dataset read_attribute(Id object, const std::string& name, const std::string& where,
                       Accept accept) {
  const std::string full_name = fmt::format("the attribute {} of {}", name, where);
  const std::string doing = "read " + full_name;
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), doing);
  const Handle type(H5Aget_type(attribute), doing);
  const Handle space(H5Aget_space(attribute), doing);
  constexpr std::size_t largest_attribute = 65536;  // HDF5's own limit [bytes]
  const Read read = [&](Id as, void* elements) { return H5Aread(attribute, as, elements); };
  Dataset data = read_elements(type, space, read, largest_attribute, accept, full_name);
  if (accept == Accept::edited && data.shape == Shape{1}) data.shape.clear();  // as netCDF has them
  return data;
}

// Throws MachineFailure if the elements were packed in a way that this libhdf5 does not know.
void check_filters(Id properties, const std::string& path) {
  for (int n = 0; n < H5Pget_nfilters(properties); ++n) {
    std::array<char, 64> name{};
    const auto filter = H5Pget_filter2(properties, static_cast<unsigned>(n), nullptr, nullptr,
                                       nullptr, name.size() - 1, name.data(), nullptr);
    if (filter < 0 || H5Zfilter_avail(filter) > 0) continue;
    throw MachineFailure(
        "{} is packed with the HDF5 filter {} ({}), which this machine lacks: repack the file with "
        "gzip where it was packed",
        path, filter, name.data());
  }
}

// Nothing is ever kept outside the file, nor, by us, chunked or compressed.
void check_storage(Id dataset, const std::string& path, Accept accept) {
  const Handle properties(H5Dget_create_plist(dataset), "read " + path);
  const H5D_layout_t layout = H5Pget_layout(properties);
  const bool in_one_piece = layout == H5D_COMPACT || layout == H5D_CONTIGUOUS;
  const bool in_file = layout != H5D_VIRTUAL && H5Pget_external_count(properties) == 0;
  if (in_file && (in_one_piece || accept == Accept::edited)) {
    return check_filters(properties, path);
  }
  fail("{} is not stored as rupture does, in one piece in this file", path);
}

// Without its unit.
Dataset read_values(Id dataset, const std::string& path, std::size_t room, Accept accept) {
  const std::string doing = fmt::format("read {}", path);
  const Handle type(H5Dget_type(dataset), doing);
  const Handle space(H5Dget_space(dataset), doing);
  const Read read = [&](Id as, void* elements) {
    return H5Dread(dataset, as, H5S_ALL, H5S_ALL, H5P_DEFAULT, elements);
  };
  Dataset data = read_elements(type, space, read, room, accept, path);
  const hsize_t stored = H5Dget_storage_size(dataset);
  if (accept == Accept::own && stored != data.bytes.size()) {  // what is not there reads as zeros
    fail("{} holds {} bytes, but its shape {} needs {}", path, stored, shape_text(data.shape),
         data.bytes.size());
  }
  return data;
}

Dataset read_dataset(Id dataset, const std::string& path, std::size_t room, Accept accept) {
  check_storage(dataset, path, accept);
  Dataset data = read_values(dataset, path, room, accept);
  if (accept == Accept::edited && H5Aexists(dataset, "unit") == 0) return data;
  const std::string unit = fmt::format("the attribute unit of {}", path);
  data.unit = read_text({{unit, read_attribute(dataset, "unit", path, accept)}}, unit);
  return data;
}

// Names of what is in a group. Links that are followed by name could lead out of the file.
std::vector<std::string> names_in(Id group, const std::string& where) {
  struct Links {
    std::vector<std::string> names;
    bool followed_by_name = false;
  } links;
  const auto keep = [](hid_t, const char* name, const H5L_info_t* link, void* found) {
    static_cast<Links*>(found)->names.emplace_back(name);
    static_cast<Links*>(found)->followed_by_name |= link->type != H5L_TYPE_HARD;
    return herr_t{0};
  };
  check(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, keep, &links), "list " + where);
  if (links.followed_by_name) {
    fail("{} holds a symbolic link, which rupture never writes", where);
  }
  return links.names;
}

// Walks through all groups. The sizes that datasets and objects claim must fit into the file
// together: otherwise a few bytes, linked or claimed again and again, could keep it busy for ever.
class Collector {
 public:
  Collector(std::size_t room, Accept accept) : room_(room), accept_(accept) {}

  void collect(Id group, const std::string& prefix, int depth) {
    const std::string where = prefix + "/";
    if (depth > kDeepest) fail("{} is a group that is nested too deeply", where);
    for (const std::string& name : names_in(group, where)) add(group, name, where + name, depth);
  }

  Content content;

 private:
  void add(Id group, const std::string& name, const std::string& path, int depth) {
    const Handle object(H5Oopen(group, name.c_str(), H5P_DEFAULT), "open " + path);
    take(kSmallestObject, path);
    const H5I_type_t type = H5Iget_type(object);
    if (type == H5I_GROUP) {
      collect(object, path, depth + 1);
    } else if (type == H5I_DATASET) {
      Dataset dataset = read_dataset(object, path, room_, accept_);
      take(dataset.bytes.size(), path);
      content.emplace(path, std::move(dataset));
    } else {
      fail("{} is neither a group nor a dataset", path);
    }
  }

  void take(std::size_t bytes, const std::string& path) {
    if (bytes > room_) {
      fail("{} and the datasets before it need more bytes than the file has", path);
    }
    room_ -= bytes;
  }

  std::size_t room_;  // bytes that nothing has claimed yet
  Accept accept_;
};

// HDF5 asks these for memory to copy the image into: once for the properties, once for the file.
// As it only reads, `image`, which is our own memory, serves for all of them.
H5FD_file_image_callbacks_t share(void* image) {
  H5FD_file_image_callbacks_t callbacks{};
  callbacks.image_malloc = [](std::size_t, H5FD_file_image_op_t, void* shared) { return shared; };
  callbacks.image_memcpy = [](void* target, const void*, std::size_t, H5FD_file_image_op_t, void*) {
    return target;
  };
  callbacks.image_realloc = [](void*, std::size_t, H5FD_file_image_op_t, void*) -> void* {
    return nullptr;  // would make the image larger
  };
  callbacks.image_free = [](void*, H5FD_file_image_op_t, void*) { return herr_t{0}; };
  callbacks.udata_copy = [](void* shared) { return shared; };
  callbacks.udata_free = [](void*) { return herr_t{0}; };
  callbacks.udata = image;
  return callbacks;
}

Handle open_in_place(std::span<const std::byte> file) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), "prepare to read");
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): HDF5 has no pointer for reading only
  void* image = const_cast<std::byte*>(file.data());
  H5FD_file_image_callbacks_t callbacks = share(image);
  check(H5Pset_fapl_core(access, kGrowth, false), "read from memory");
  check(H5Pset_file_image_callbacks(access, &callbacks), "read from memory");
  check(H5Pset_file_image(access, image, file.size()), "read from memory");
  // HDF5 takes files in memory for the same if they have the same name.
  const std::string name = fmt::format("{}-{}", kNoFile, fmt::ptr(image));
  return {H5Fopen(name.c_str(), H5F_ACC_RDONLY, access), "open the HDF5 part of the file"};
}

}  // namespace

Reader::Reader(std::span<const std::byte> file, Accept accept)
    : size_(file.size()), accept_(accept) {
  prepare();
  file_ = open_in_place(file);
}

RootAttributes Reader::attributes() const {
  Content attributes;
  for (const char* name : {"format", "schema_version", "content_checksum"}) {
    const auto exists = H5Aexists(file_, name);
    check(exists, "read the root attributes");
    if (exists > 0) attributes.emplace(name, read_attribute(file_, name, "/", accept_));
  }
  if (!attributes.contains("format")) {
    throw Failure(
        "format is missing; expected text, as in every file that one of rupture's programs wrote");
  }
  RootAttributes root{read_text(attributes, "format"),
                      read_scalar<std::int64_t>(attributes, "schema_version"), "", ""};
  if (attributes.contains("content_checksum")) {
    root.content_checksum = read_text(attributes, "content_checksum");
  }
  return root;
}

std::string Reader::writer_version() const {
  const std::string chain = "/provenance";
  const Handle group(H5Gopen2(file_, chain.c_str(), H5P_DEFAULT), "open " + chain);
  const std::vector<std::string> entries = names_in(group, chain);
  if (entries.empty()) throw Failure("there is no provenance");
  const std::string path = fmt::format("{}/{}/version", chain, entries.back());
  const Handle version(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), "open " + path);
  return read_text({{path, read_dataset(version, path, kLongestVersion, Accept::own)}}, path);
}

Content Reader::content() const {
  Collector collector(accept_ == Accept::own ? size_ : kCompression * size_, accept_);
  collector.collect(file_, "", 0);
  return collector.content;
}

}  // namespace rupture::hdf5
