#include "atomic_write.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
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

// Removes the temporary file unless it was renamed.
class Temporary {
 public:
  explicit Temporary(fs::path path) : path_(std::move(path)) {}
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  Temporary(Temporary&&) = delete;
  Temporary& operator=(Temporary&&) = delete;
  ~Temporary() {
    if (!renamed_) ::unlink(path_.c_str());
  }
  const fs::path& path() const { return path_; }
  bool rename_to(const fs::path& target) {
    renamed_ = ::rename(path_.c_str(), target.c_str()) == 0;
    return renamed_;
  }

 private:
  fs::path path_;
  bool renamed_ = false;
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

void write_temporary(const Temporary& temporary, const fs::path& path,
                     std::span<const std::byte> bytes) {
  ::unlink(temporary.path().c_str());  // left by a killed process that had the same number
  Descriptor file(::open(temporary.path().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (file.get() < 0) fail(path);
  if (!write_all(file.get(), bytes)) fail(path);
  if (::fsync(file.get()) != 0 || !file.close()) fail(path);
}

// Makes the rename itself durable. Some file systems cannot, and a folder may forbid reading; then
// the file is in place all the same.
void sync_folder(const fs::path& folder) {
  const Descriptor fd(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (fd.get() >= 0 && ::fsync(fd.get()) != 0 && errno != EINVAL) fail(folder);
}

sigset_t file_size_signal() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGXFSZ);
  return set;
}

}  // namespace

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

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

void write_atomically(const fs::path& path, std::span<const std::byte> bytes) {
  const FileSizeSignalBlocked guard;
  const fs::path folder = folder_of(path);
  Temporary temporary(folder / fmt::format(".{}.tmp.{}", path.filename().string(), ::getpid()));
  write_temporary(temporary, path, bytes);
  if (!temporary.rename_to(path)) fail(path);
  sync_folder(folder);
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
