// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

// Files that appear complete or not at all, and files that only grow.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace rupture {

/// Folder of a path, "." for a bare file name.
std::filesystem::path folder_of(const std::filesystem::path& path);

/// The hidden name under which this process writes a file first.
std::filesystem::path temporary_path(const std::filesystem::path& path);

/// A file that appears complete or not at all: first under its temporary_path(), then, on
/// commit(), under its own. Both throw Failure with the system's reason; without a commit nothing
/// is left of it.
class PendingFile {
 public:
  /// Writes the bytes and brings them to disk.
  PendingFile(std::filesystem::path path, std::span<const std::byte> bytes);
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  PendingFile(PendingFile&&) = delete;
  PendingFile& operator=(PendingFile&&) = delete;
  ~PendingFile();

  /// Renames it to its path, replacing what is there, and brings that to disk.
  void commit();

 private:
  std::filesystem::path path_, temporary_;
};

/// Writes a file so in one go.
void write_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Removes a file, if there is one, and brings that to disk. Throws Failure.
void remove_durably(const std::filesystem::path& path);

/// Whether a WriterLock, of any process, is on the file. False where the file system has no locks.
bool is_locked(const std::filesystem::path& path);

/// Throws Failure if it is.
void refuse_locked(const std::filesystem::path& path);

/// While it lives, no other process, and no other lock of this one, locks the file. Readers are not
/// locked out: HDF5 asks for flock() before it reads, and this is a lock of the other kind, which
/// flock() does not see.
class WriterLock {
 public:
  /// Throws Failure if somebody else has locked the file. Where the file system has no locks,
  /// nothing is locked.
  explicit WriterLock(const std::filesystem::path& path);
  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;
  WriterLock(WriterLock&&) = delete;
  WriterLock& operator=(WriterLock&&) = delete;
  ~WriterLock();

 private:
  int fd_;
};

/// Adds to the end of an existing file, without bringing it to disk. Throws Failure with the
/// system's reason; the file is then cut back to what it was.
void append_to(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Brings an existing file to disk. Throws Failure.
void sync_file(const std::filesystem::path& path);

}  // namespace rupture
