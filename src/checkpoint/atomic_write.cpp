// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

#include "atomic_write.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>
#include <utility>

#include "rupture/model/error.hpp"

namespace rupture {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path) {
  throw Failure(fmt::format("could not write {}: {}", path.string(), std::strerror(errno)));
}

// An open file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&&) = delete;
  Descriptor& operator=(Descriptor&&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }
  bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

bool write_all(int fd, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

// Makes renames and removals durable. Some file systems cannot, and a folder may forbid reading;
// then they are in place all the same.
void sync_folder_of(const fs::path& path) {
  const Descriptor folder(::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() < 0 && errno == EACCES) return;
  if (folder.get() < 0 || (::fsync(folder.get()) != 0 && errno != EINVAL)) fail(path);
}

[[noreturn]] void fail_locked(const fs::path& path) {
  throw Failure(
      fmt::format("another run is writing {}; wait until it has ended, or give another --record",
                  path.string()));
}

struct flock whole_file_for_writing() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

sigset_t file_size_signal() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGXFSZ);
  return set;
}

// While it lives, writing past the file size limit (ulimit -f) fails with EFBIG in this thread
// instead of killing the process.
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

FileSizeSignalBlocked::FileSizeSignalBlocked() {
  const sigset_t set = file_size_signal();
  pthread_sigmask(SIG_BLOCK, &set, &before_);
}

FileSizeSignalBlocked::~FileSizeSignalBlocked() {
  const sigset_t set = file_size_signal();
  const timespec at_once{};
  while (sigtimedwait(&set, nullptr, &at_once) > 0) {
    // a blocked signal stays pending and would strike below
  }
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

fs::path temporary_path(const fs::path& path) {
  return folder_of(path) / fmt::format(".{}.tmp.{}", path.filename().string(), ::getpid());
}

PendingFile::PendingFile(fs::path path, std::span<const std::byte> bytes)
    : path_(std::move(path)), temporary_(temporary_path(path_)) {
  const FileSizeSignalBlocked guard;
  ::unlink(temporary_.c_str());  // left by a killed process that had the same number
  Descriptor file(::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (file.get() < 0) fail(path_);
  if (write_all(file.get(), bytes) && ::fsync(file.get()) == 0 && file.close()) return;
  const int reason = errno;
  ::unlink(temporary_.c_str());
  errno = reason;
  fail(path_);
}

PendingFile::~PendingFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void PendingFile::commit() {
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail(path_);
  temporary_.clear();
  sync_folder_of(path_);
}

void write_atomically(const fs::path& path, std::span<const std::byte> bytes) {
  PendingFile(path, bytes).commit();
}

void remove_durably(const fs::path& path) {
  if (::unlink(path.c_str()) == 0) {
    sync_folder_of(path);
  } else if (errno != ENOENT) {
    throw Failure(fmt::format("could not remove {}: {}", path.string(), std::strerror(errno)));
  }
}

bool is_locked(const fs::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) fail(path);
  struct flock lock = whole_file_for_writing();
  return ::fcntl(file.get(), F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

void refuse_locked(const fs::path& path) {
  if (is_locked(path)) fail_locked(path);
}

WriterLock::WriterLock(const fs::path& path) : fd_(::open(path.c_str(), O_RDWR | O_CLOEXEC)) {
  if (fd_ < 0) fail(path);
  struct flock lock = whole_file_for_writing();
  if (::fcntl(fd_, F_OFD_SETLK, &lock) == 0 || (errno != EAGAIN && errno != EACCES)) return;
  ::close(fd_);
  fail_locked(path);
}

WriterLock::~WriterLock() {
  ::close(fd_);
}

void append_to(const fs::path& path, std::span<const std::byte> bytes) {
  const FileSizeSignalBlocked guard;
  Descriptor file(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  const off_t before = file.get() < 0 ? -1 : ::lseek(file.get(), 0, SEEK_END);
  if (before < 0) fail(path);
  if (write_all(file.get(), bytes)) {
    if (!file.close()) fail(path);
    return;
  }
  const int reason = errno;
  // If the file cannot be cut back either, its reader sees that what was begun is not whole.
  [[maybe_unused]] const int ignored = ::ftruncate(file.get(), before);
  errno = reason;
  fail(path);
}

void sync_file(const fs::path& path) {
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.get() < 0 || ::fsync(file.get()) != 0) fail(path);
}

}  // namespace rupture
