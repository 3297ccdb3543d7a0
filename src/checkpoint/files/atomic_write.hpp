// Files that appear complete or not at all, and files that only grow.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "rupture/checkpoint/output.hpp"

namespace rupture {

/// Folder of a path, "." for a bare file name.
std::filesystem::path folder_of(const std::filesystem::path& path);

/// Throws MachineFailure with the system's reason.
[[noreturn]] void fail_reading(const std::filesystem::path& path);

/// A hidden name under which a file is written first: another one each time.
std::filesystem::path temporary_path(const std::filesystem::path& path);

/// An open file descriptor; a negative one is none.
class Descriptor {
 public:
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~Descriptor();
  int get() const { return fd_; }

 private:
  int fd_;
};

/// The next `size` bytes of the file, or fewer if it ends before. No value, with errno set, if it
/// cannot be read.
std::optional<std::vector<std::byte>> read_start(const Descriptor& file, std::size_t size);

/// A file that appears complete or not at all: first under its temporary_path(), then, on
/// commit(), under its own, with the mode of the file that it replaces. All throw Failure with the
/// system's reason; without commit() or keep() nothing is left of it.
class PendingFile {
 public:
  /// Writes the bytes and brings them to disk.
  PendingFile(std::filesystem::path path, std::span<const std::byte> bytes);
  PendingFile& operator=(PendingFile&&) = delete;
  ~PendingFile();

  /// Renames it to its path and brings that to disk. With IfExists::refuse it is false, and nothing
  /// has happened, if there is a file.
  bool commit(IfExists if_exists);
  /// Leaves it under another name than its own, if possible one that is not hidden; the name is
  /// empty if it has got its own.
  std::filesystem::path keep();
  /// Gives it this name instead of its own, and replaces what is there.
  void rename_to(const std::filesystem::path& path);

  Descriptor file;  ///< for reading and appending

 private:
  std::filesystem::path path_, temporary_;
};

/// Removes a file, if there is one, and brings that to disk. Throws Failure.
void remove_durably(const std::filesystem::path& path);

/// A file that grows, and that no other process writes, nor another object of this one: it is
/// locked before it gets its name, and one that it replaces is locked meanwhile. Readers are not
/// locked out: HDF5 asks for flock() before it reads, and this is a lock of the other kind, which
/// flock() does not see. Where the file system has no locks, nothing is locked.
class GrowingFile {
 public:
  /// Begins with `bytes`. Throws Failure with the system's reason, and if somebody else is writing
  /// the file or it may not be replaced.
  GrowingFile(std::filesystem::path path, std::span<const std::byte> bytes, IfExists if_exists);

  /// Adds to its end, without bringing it to disk. Throws Failure; the file then is as it was.
  void append(std::span<const std::byte> bytes) const;
  /// Brings it to disk. Throws Failure.
  void sync() const;
  /// All of it, wherever it is by now. Throws Failure.
  std::vector<std::byte> bytes() const;
  /// Removes it, unless it was moved.
  void remove() const;

 private:
  /// Whether what is added to it shows at its path. Some file systems (rclone) give a file another
  /// inode number when it is renamed, so that the number does not tell.
  bool grows_at_its_path() const;

  std::filesystem::path path_;
  Descriptor file_;
};

}  // namespace rupture
