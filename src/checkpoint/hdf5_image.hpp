// Content to and from a complete HDF5 file in memory; libhdf5 never touches the disk.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hdf5_objects.hpp"

namespace rupture::hdf5 {

/// A whole file: kHeaderSize zero bytes, to be overwritten by the header, then the HDF5 part.
/// Equal arguments give equal bytes.
std::vector<std::byte> make_image(const RootAttributes& attributes, const Content& content,
                                  const Labels& labels = {});

/// A file opened for reading. Throws Failure if libhdf5 cannot open it.
class Reader {
 public:
  /// A verified file in memory, which must outlive the reader.
  explicit Reader(std::span<const std::byte> file, Accept accept = Accept::own);

  RootAttributes attributes() const;
  std::string writer_version() const;
  Content content() const;

 private:
  std::size_t size_;
  Accept accept_;
  Handle file_;
};

}  // namespace rupture::hdf5
