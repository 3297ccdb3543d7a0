// Between a Content and the bytes of a file that protects itself.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "hdf5.hpp"
#include "rupture/checkpoint/file.hpp"

namespace rupture {

/// Length in bytes, header included, of the intact piece of an open record that `bytes` starts
/// with; 0 if there is none. Each flush of a record appends a piece, a small sealed record, so that
/// whatever happens to the process or the disk, the pieces before stay as they are, and what is not
/// whole behind them is seen by its SHA-256.
std::size_t intact_piece(std::span<const std::byte> bytes);

/// Thrown if what follows the header of a file of ours is not what was sealed.
struct BrokenSeal : Failure {
  using Failure::Failure;
};

/// Verifies header and body of a whole checkpoint or record. Throws Failure if it is empty, not
/// ours or damaged in its header, BrokenSeal if it is truncated or damaged behind that.
FileKind check_envelope(std::span<const std::byte> file, const std::string& name);

/// How a child process ended.
struct ChildEnd {
  int code = 0;    ///< what its work returned, 0 to 255; kThrew if it threw
  int signal = 0;  ///< that ended it; 0 if none did
  static constexpr int kThrew = 255;
};

/// Runs `work` in a copy of this process, which prints nothing, writes no core, and is ended after
/// a minute of processor time. Throws Unreadable if there is none to be had.
ChildEnd in_child_process(const std::function<int()>& work);

/// A whole file: header and HDF5 part.
struct Sealed {
  std::string checksum;  ///< of the content; empty for a piece of an open record
  std::vector<std::byte> bytes;
};

/// Throws Failure if a number is not finite.
Sealed seal(FileKind kind, const Content& content);

/// What a file holds whose header may not fit, or be missing. Throws Failure. What crashes libhdf5
/// crashes this process: see demand_survival().
EditedFile open_edited(std::span<const std::byte> file);

/// Reads all of a file in a child process. Throws Failure if a signal ends that.
void demand_survival(std::span<const std::byte> file, hdf5::Accept accept);

/// The content of a file of this kind whose header was checked. Throws Failure if attributes,
/// content or content checksum are not as they should be.
ContentFile unseal(FileKind kind, std::span<const std::byte> file);

/// The open record in the intact pieces at the start of `file`. Throws Failure if not even the
/// first is intact, or if they do not fit together.
ContentFile put_together(std::span<const std::byte> file);

}  // namespace rupture
