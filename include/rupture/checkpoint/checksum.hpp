// SHA-256, and the checksum of a content in its canonical form (docs/schema.md).
#pragma once

#include "rupture/checkpoint/content.hpp"

namespace rupture {

/// SHA-256 of `bytes`, 64 lowercase hexadecimal digits.
std::string sha256(std::span<const std::byte> bytes);

/// True for paths that the content checksum covers: /parameters, /state, /series, /ruptures,
/// /crossings and /fields, but not the positions x and z in them, which follow from the parameters.
/// So it is everything but where the file comes from (/provenance) and what its run has seen
/// (/run).
bool is_checksummed(std::string_view path);

/// SHA-256 over the canonical form of counted_parameters() and of the other datasets that
/// is_checksummed() names, 64 lowercase hexadecimal digits. Equal on every machine and for every
/// build if the content is equal.
std::string content_checksum(const Content& content);

/// A content checksum as it is printed: "content-sha256 <64 hex digits>". Not "sha256", because it
/// is not what sha256sum gives for the file.
std::string labelled(const std::string& checksum);

}  // namespace rupture
