#include "hdf5_image.hpp"

#include <hdf5.h>
#include <hdf5_hl.h>

#include "rupture/checkpoint/envelope.hpp"

namespace rupture::hdf5 {
namespace {

constexpr std::size_t kGrowth = 1U << 20U;  // [bytes] step in which the image in memory grows

// HDF5's oldest format, its default: newer ones have a checksum in their first block, which
// H5Fget_file_image leaves wrong up to HDF5 1.14.5 (HDFGroup/hdf5 pull request 5489).
Handle create_file_in_memory() {
  const Handle creation = file_creation_properties();
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "prepare a file");
  check(H5Pset_fapl_core(access, kGrowth, false), "create a file in memory");
  return {H5Fcreate("rupture-image", H5F_ACC_TRUNC, creation, access), H5Fclose,
          "create a file in memory"};
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

// HDF5 only reads an image that it neither copies nor releases, but asks for a mutable pointer.
Handle open_in_place(std::span<const std::byte> file) {
  return {H5LTopen_file_image(const_cast<std::byte*>(file.data()), file.size(),
                              H5LT_FILE_IMAGE_DONT_COPY | H5LT_FILE_IMAGE_DONT_RELEASE),
          H5Fclose, "open the HDF5 part of the file"};
}

}  // namespace

std::vector<std::byte> make_image(const RootAttributes& attributes, const Content& content) {
  silence();
  const Handle file = create_file_in_memory();
  write_root_attributes(file, attributes);
  write_content(file, content);
  return image_of(file);
}

ImageReader::ImageReader(std::span<const std::byte> file) : size_(file.size()) {
  silence();
  file_ = open_in_place(file);
}

RootAttributes ImageReader::attributes() const {
  return read_root_attributes(file_);
}

Content ImageReader::content() const {
  return read_datasets(file_, size_);
}

}  // namespace rupture::hdf5
