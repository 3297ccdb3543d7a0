// Files that appear complete or not at all, and files that only grow.
#pragma once

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <span>

namespace rupture {

/// While it lives, writing past the file size limit (ulimit -f) fails with EFBIG in this thread
/// instead of killing the process.
class FileSizeSignalBlocked {
 public:
  FileSizeSignalBlocked();
  ~FileSizeSignalBlocked();
  FileSizeSignalBlocked(const FileSizeSignalBlocked&) = delete;
  FileSizeSignalBlocked& operator=(const FileSizeSignalBlocked&) = delete;
  FileSizeSignalBlocked(FileSizeSignalBlocked&&) = delete;
  FileSizeSignalBlocked& operator=(FileSizeSignalBlocked&&) = delete;

 private:
  sigset_t before_{};
};

/// Folder of a path, "." for a bare file name.
std::filesystem::path folder_of(const std::filesystem::path& path);

/// Writes a temporary file in the folder of `path`, brings it to disk and renames it to `path`.
/// Throws Failure with the system's reason; the temporary is then removed and `path` is what it
/// was.
void write_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Adds to the end of an existing file, without bringing it to disk. Throws Failure with the
/// system's reason; the file is then cut back to what it was.
void append_to(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Brings an existing file to disk. Throws Failure.
void sync_file(const std::filesystem::path& path);

}  // namespace rupture
