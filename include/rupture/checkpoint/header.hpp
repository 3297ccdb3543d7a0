// The header in front of each file.
#pragma once

#include <cstddef>
#include <span>

#include "rupture/checkpoint/kinds.hpp"

namespace rupture {

/// The header in front of every file [bytes] (HDF5's user block): readable text with the kind of
/// file, its size, and the SHA-256 of all bytes that follow. It lets damage be seen before libhdf5
/// looks at anything, and has exactly one valid form for a given body, so that no bit of the file,
/// its own included, can change unnoticed.
inline constexpr std::size_t kHeaderSize = 512;

/// The header, kHeaderSize bytes, that belongs in front of `body`.
std::string header_text(FileKind kind, std::span<const std::byte> body);

/// The kind that the first line of the header states, without any verification. `file` may hold the
/// whole file or its start. Throws Failure if it is empty, too short or not ours; `name` is the
/// file name for the message.
FileKind header_kind(std::span<const std::byte> file, const std::string& name);

/// Length in bytes, header included, of the intact piece of an open record that `bytes` starts
/// with; 0 if there is none. Each flush of a record appends a piece, a small sealed record, so that
/// whatever happens to the process or the disk, the pieces before stay as they are, and what is not
/// whole behind them is seen by its SHA-256.
std::size_t intact_piece(std::span<const std::byte> bytes);

/// Whether the bytes of a file of this kind, which may be none of ours, are as they were sealed.
bool has_its_header(std::span<const std::byte> file, FileKind kind);

/// Thrown if the bytes of a file of ours are not those that were sealed.
struct BrokenSeal : Failure {
  using Failure::Failure;
};

/// Verifies header and body of a whole checkpoint or record. Throws Failure if it is empty or not
/// ours, BrokenSeal if it is truncated, damaged or changed.
FileKind check_envelope(std::span<const std::byte> file, const std::string& name);

}  // namespace rupture
