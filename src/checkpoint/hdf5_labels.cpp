// Attributes `units` and `long_name` of the CF conventions, and HDF5's dimension scales.
//
// H5DSattach_scale of hdf5_hl would leave four bytes of each entry of a REFERENCE_LIST as they
// happen to be in memory. Here equal contents give equal bytes.
#include <hdf5.h>

#include <cstring>
#include <map>
#include <vector>

#include "hdf5.hpp"

namespace rupture::hdf5 {
namespace {

constexpr const char* kDoing = "label a dataset";

// A dataset that goes along a scale, as an entry of that scale's REFERENCE_LIST.
struct User {
  hobj_ref_t dataset;
  std::int32_t dimension;
};
constexpr std::size_t kUserSize = sizeof(hobj_ref_t) + sizeof(std::int32_t);  // without padding

Handle open(Id file, const std::string& path) {
  return {H5Dopen2(file, path.c_str(), H5P_DEFAULT), kDoing};
}

hobj_ref_t reference_to(Id file, const std::string& path) {
  hobj_ref_t reference{};
  check(H5Rcreate(&reference, file, path.c_str(), H5R_OBJECT, -1), kDoing);
  return reference;
}

void write_attribute(Id object, const char* name, Id type, Id space, const void* value) {
  const Handle attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), kDoing);
  check(H5Awrite(attribute, type, value), kDoing);
}

// With a null at the end: h5netcdf takes texts of length 1 for bytes.
void write_text(Id object, const char* name, const std::string& text) {
  const Handle type(H5Tcopy(H5T_C_S1), kDoing);
  check(H5Tset_size(type, text.size() + 1), kDoing);
  const Handle space(H5Screate(H5S_SCALAR), kDoing);
  write_attribute(object, name, type, space, text.c_str());
}

Handle create_list(std::size_t length) {
  const hsize_t size = length;
  return {H5Screate_simple(1, &size, nullptr), kDoing};
}

// In the dataset: for each dimension a list of the one scale that belongs to it.
void write_dimension_list(Id dataset, std::vector<hobj_ref_t> scales) {
  std::vector<hvl_t> lists;
  for (hobj_ref_t& scale : scales) lists.push_back({1, &scale});
  const Handle type(H5Tvlen_create(H5T_STD_REF_OBJ), kDoing);
  write_attribute(dataset, "DIMENSION_LIST", type, create_list(lists.size()), lists.data());
}

// In the scale: who goes along it.
void write_reference_list(Id scale, const std::vector<User>& users) {
  const Handle type(H5Tcreate(H5T_COMPOUND, kUserSize), kDoing);
  check(H5Tinsert(type, "dataset", 0, H5T_STD_REF_OBJ), kDoing);
  check(H5Tinsert(type, "dimension", sizeof(hobj_ref_t), H5T_STD_I32LE), kDoing);
  std::vector<std::byte> bytes(users.size() * kUserSize);
  for (std::size_t i = 0; i < users.size(); ++i) {
    std::memcpy(&bytes[i * kUserSize], &users[i].dataset, sizeof(hobj_ref_t));
    std::memcpy(&bytes[i * kUserSize + sizeof(hobj_ref_t)], &users[i].dimension,
                sizeof(std::int32_t));
  }
  write_attribute(scale, "REFERENCE_LIST", type, create_list(users.size()), bytes.data());
}

void write_scale(Id file, const std::string& path, const std::vector<User>& users) {
  const Handle scale = open(file, path);
  write_text(scale, "CLASS", "DIMENSION_SCALE");
  write_text(scale, "NAME", path.substr(path.rfind('/') + 1));
  if (!users.empty()) write_reference_list(scale, users);
}

}  // namespace

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

}  // namespace rupture::hdf5
