#include "hdf5_image.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <string>

#include "rupture/checkpoint/envelope.hpp"

namespace rupture::hdf5 {
namespace {

constexpr const char* kNoFile = "/dev/null/rupture-image";  // HDF5 tries to open what it is told
constexpr std::size_t kGrowth = 1U << 20U;  // [bytes] step in which the image in memory grows

// HDF5's oldest format, its default: newer ones have a checksum in their first block, which
// H5Fget_file_image leaves wrong up to HDF5 1.14.5 (HDFGroup/hdf5 pull request 5489).
Handle create_file_in_memory() {
  const Handle creation = file_creation_properties();
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "prepare a file");
  check(H5Pset_fapl_core(access, kGrowth, false), "create a file in memory");
  return {H5Fcreate(kNoFile, H5F_ACC_TRUNC, creation, access), H5Fclose, "create a file in memory"};
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
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "prepare to read");
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): HDF5 has no pointer for reading only
  void* image = const_cast<std::byte*>(file.data());
  H5FD_file_image_callbacks_t callbacks = share(image);
  check(H5Pset_fapl_core(access, kGrowth, false), "read from memory");
  check(H5Pset_file_image_callbacks(access, &callbacks), "read from memory");
  check(H5Pset_file_image(access, image, file.size()), "read from memory");
  // HDF5 takes files in memory for the same if they have the same name.
  const std::string name = fmt::format("{}-{}", kNoFile, fmt::ptr(image));
  return {H5Fopen(name.c_str(), H5F_ACC_RDONLY, access), H5Fclose,
          "open the HDF5 part of the file"};
}

}  // namespace

std::vector<std::byte> make_image(const RootAttributes& attributes, const Content& content,
                                  const Labels& labels) {
  prepare();
  const Handle file = create_file_in_memory();
  write_root_attributes(file, attributes);
  write_content(file, content);
  write_labels(file, content, labels);
  return image_of(file);
}

Reader::Reader(std::span<const std::byte> file, Accept accept)
    : size_(file.size()), accept_(accept) {
  prepare();
  file_ = open_in_place(file);
}

RootAttributes Reader::attributes() const {
  return read_root_attributes(file_, accept_);
}

std::string Reader::writer_version() const {
  return read_writer_version(file_);
}

Content Reader::content() const {
  return read_datasets(file_, size_, accept_);
}

}  // namespace rupture::hdf5
