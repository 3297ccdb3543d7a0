#include <fmt/format.h>
#include <hdf5.h>

#include <array>

#include "hdf5_objects.hpp"
#include "rupture/model/error.hpp"

namespace rupture::hdf5 {
namespace {

constexpr int kDeepest = 8;  // levels of groups; stops at links that lead back to their own group

DataType data_type(Id type, const std::string& path) {
  if (H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0) return DataType::text;
  constexpr std::array numbers = {DataType::float64, DataType::int64, DataType::uint32,
                                  DataType::uint16, DataType::uint8};
  for (const DataType candidate : numbers) {
    if (H5Tequal(type, stored_type(candidate, 0)) > 0) return candidate;
  }
  throw Failure(fmt::format("{} has an element type that rupture never writes", path));
}

Shape shape_of(Id space, const std::string& path) {
  const int rank = H5Sget_simple_extent_ndims(space);
  check(rank, fmt::format("read the shape of {}", path));
  std::vector<hsize_t> lengths(static_cast<std::size_t>(rank));
  check(H5Sget_simple_extent_dims(space, lengths.data(), nullptr),
        fmt::format("read the shape of {}", path));
  return {lengths.begin(), lengths.end()};
}

// Bytes of an array, without the overflow that a nonsensical shape could cause.
std::size_t byte_count(const Shape& shape, std::size_t element_size, std::size_t size_limit,
                       const std::string& path) {
  std::size_t bytes = element_size;
  for (const std::uint64_t length : shape) {
    if (length != 0 && bytes > size_limit / length) {
      throw Failure(fmt::format("{} claims the shape {}, more than the file can hold", path,
                                shape_text(shape)));
    }
    bytes *= length;
  }
  return bytes;
}

// Type, shape and room for the bytes of a dataset or attribute.
Dataset described(Id type, Id space, std::size_t size_limit, const std::string& path) {
  Dataset data{"", data_type(type, path), shape_of(space, path), {}};
  if (data.type == DataType::text && !data.shape.empty()) {
    throw Failure(fmt::format("{} is an array of texts, which rupture never writes", path));
  }
  data.bytes.resize(byte_count(data.shape, H5Tget_size(type), size_limit, path));
  return data;
}

Dataset read_attribute(Id object, const std::string& name, const std::string& where) {
  const std::string full_name = fmt::format("the attribute {} of {}", name, where);
  const std::string doing = "read " + full_name;
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, doing);
  const Handle type(H5Aget_type(attribute), H5Tclose, doing);
  const Handle space(H5Aget_space(attribute), H5Sclose, doing);
  constexpr std::size_t largest_attribute = 65536;  // HDF5's own limit [bytes]
  Dataset data = described(type, space, largest_attribute, full_name);
  check(H5Aread(attribute, type, data.bytes.data()), doing);
  return data;
}

Dataset read_dataset(Id dataset, const std::string& path, std::size_t size_limit) {
  const std::string doing = fmt::format("read {}", path);
  const Handle type(H5Dget_type(dataset), H5Tclose, doing);
  const Handle space(H5Dget_space(dataset), H5Sclose, doing);
  Dataset data = described(type, space, size_limit, path);
  data.unit = read_text({{"unit", read_attribute(dataset, "unit", path)}}, "unit");
  if (!data.bytes.empty()) {
    check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.bytes.data()), doing);
  }
  return data;
}

std::string link_name(Id group, hsize_t index, const std::string& doing) {
  const auto get = [&](char* buffer, std::size_t size) {
    const ssize_t length = H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, index, buffer,
                                              size, H5P_DEFAULT);
    check(length, doing);
    return static_cast<std::size_t>(length);
  };
  std::string name(get(nullptr, 0), '\0');
  get(name.data(), name.size() + 1);
  return name;
}

void collect(Id group, const std::string& prefix, int depth, std::size_t size_limit,
             Content& content) {
  const std::string doing = fmt::format("list {}/", prefix);
  if (depth > kDeepest) throw Failure(fmt::format("could not {}: groups too deep", doing));
  H5G_info_t info{};
  check(H5Gget_info(group, &info), doing);
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const std::string name = link_name(group, i, doing);
    const std::string path = fmt::format("{}/{}", prefix, name);
    const Handle object(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose, "open " + path);
    switch (H5Iget_type(object)) {
      case H5I_GROUP:
        collect(object, path, depth + 1, size_limit, content);
        break;
      case H5I_DATASET:
        content.emplace(path, read_dataset(object, path, size_limit));
        break;
      default:
        throw Failure(fmt::format("{} is neither a group nor a dataset", path));
    }
  }
}

}  // namespace

RootAttributes read_root_attributes(Id file) {
  Content attributes;
  for (const char* name : {"format", "schema_version", "content_checksum"}) {
    const auto exists = H5Aexists(file, name);
    check(exists, "read the root attributes");
    if (exists > 0) attributes.emplace(name, read_attribute(file, name, "/"));
  }
  RootAttributes root{read_text(attributes, "format"),
                      read_scalar<std::int64_t>(attributes, "schema_version"), ""};
  if (attributes.contains("content_checksum")) {
    root.content_checksum = read_text(attributes, "content_checksum");
  }
  return root;
}

Content read_datasets(Id file, std::size_t size_limit) {
  Content content;
  collect(file, "", 0, size_limit, content);
  return content;
}

}  // namespace rupture::hdf5
