// Between a Content and the bytes of a file that protects itself.
#pragma once

#include "checkpoint/sealed/hdf5.hpp"

namespace rupture {

/// A whole file: header and HDF5 part.
struct Sealed {
  std::string checksum;  ///< of the content; empty for a piece of an open record
  std::vector<std::byte> bytes;
};

/// Throws Failure if a number is not finite.
Sealed seal(FileKind kind, const Content& content);

/// What a file holds whose header may not fit, or be missing. Throws Failure.
EditedFile open_edited(std::span<const std::byte> file);

/// The content of a file of this kind whose header was checked. Throws Failure if attributes,
/// content or content checksum are not as they should be.
ContentFile unseal(FileKind kind, std::span<const std::byte> file);

/// The open record in the intact pieces at the start of `file`. Throws Failure if not even the
/// first is intact, or if they do not fit together.
ContentFile put_together(std::span<const std::byte> file);

}  // namespace rupture
