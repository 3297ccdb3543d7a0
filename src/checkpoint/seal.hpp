// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

// Between a Content and the bytes of a file that protects itself.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "rupture/checkpoint/file.hpp"

namespace rupture {

/// A whole file: header and HDF5 part.
struct Sealed {
  std::string checksum;  ///< of the content; empty for a piece of an open record
  std::vector<std::byte> bytes;
};

/// Throws Failure if a number is not finite.
Sealed seal(FileKind kind, const Content& content);

/// The content of a file of this kind whose header was checked. Throws Failure if attributes,
/// content or content checksum are not as they should be.
ContentFile unseal(FileKind kind, std::span<const std::byte> file);

}  // namespace rupture
