// The 512-byte header in front of every file (HDF5's user block).
//
// It is readable text: the kind of file, its size, and the SHA-256 of all bytes that follow. It
// lets damage be seen before libhdf5 looks at anything, and has exactly one valid form for a given
// body, so that no bit of the file, its own included, can change unnoticed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "rupture/model/error.hpp"

namespace rupture {

/// `open_record` is a record that is still being written or whose run was interrupted: pieces that
/// follow each other, each with a header of its own.
enum class FileKind { checkpoint, record, open_record };

inline constexpr std::size_t kHeaderSize = 512;  ///< [bytes]

/// "rupture-checkpoint", "rupture-record" or "rupture-record-part": first line of the header and
/// root attribute `format`.
std::string_view format_name(FileKind kind);

/// "a checkpoint", "a record" or "an unfinished record".
std::string_view kind_text(FileKind kind);

/// The header, kHeaderSize bytes, that belongs in front of `body`.
std::string header_text(FileKind kind, std::span<const std::byte> body);

/// The kind that the first line of the header states, without any verification. `file` may hold the
/// whole file or its start. Throws Failure if it is empty, too short or not ours; `name` is the
/// file name for the message.
FileKind header_kind(std::span<const std::byte> file, const std::string& name);

/// The size of the file that its header states [bytes]; 0 if it states none.
std::uint64_t stated_size(std::span<const std::byte> header);

/// Length in bytes, header included, of the intact piece of an open record that `bytes` starts
/// with; 0 if there is none.
std::size_t intact_piece(std::span<const std::byte> bytes);

/// Thrown if what follows the header of a file of ours is not what was sealed.
struct BrokenSeal : Failure {
  using Failure::Failure;
};

/// Verifies header and body of a whole checkpoint or record. Throws Failure if it is empty, not
/// ours or damaged in its header, BrokenSeal if it is truncated or damaged behind that.
FileKind check_envelope(std::span<const std::byte> file, const std::string& name);

}  // namespace rupture
