#include "checkpoint/files/atomic_write.hpp"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>

#include "checkpoint/content/context.hpp"

namespace rupture {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_writing(const fs::path& path) {
  throw MachineFailure("cannot write {}: {}", path.string(), std::strerror(errno));
}

bool write_all(int fd, std::span<const std::byte> bytes) {
  std::signal(SIGXFSZ, SIG_IGN);  // past the file size limit (ulimit -f) is EFBIG, not the end
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
  if (folder.get() < 0 || (::fsync(folder.get()) != 0 && errno != EINVAL)) fail_writing(path);
}

struct flock whole_file_for_writing() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

// False if somebody else has locked the file. Where the file system has no locks, nothing is
// locked.
bool lock(const Descriptor& file) {
  struct flock lock = whole_file_for_writing();
  return ::fcntl(file.get(), F_OFD_SETLK, &lock) == 0 || (errno != EAGAIN && errno != EACCES);
}

// Whether the path, or a link there, is this very file.
bool is_at(const Descriptor& file, const fs::path& path) {
  struct stat ours {
  }, there{};
  return ::fstat(file.get(), &ours) == 0 && ::lstat(path.c_str(), &there) == 0 &&
         ours.st_dev == there.st_dev && ours.st_ino == there.st_ino;
}

// False if there is a file already. Many file systems know no such renaming, some no links either;
// then one looks first, and only a file that appears between the two calls is not seen.
bool rename_to_new(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  if (errno != EEXIST && ::link(from.c_str(), to.c_str()) == 0) {
    ::unlink(from.c_str());
    return true;
  }
  if (errno == EEXIST || is_there(to)) return false;
  if (::rename(from.c_str(), to.c_str()) != 0) fail_writing(to);
  return true;
}

// Removes what killed runs left of a file and its checkpoints: temporary files that no process has
// locked.
void remove_leftovers(const fs::path& path) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder_of(path), ignored)) {
    const fs::path name = entry.path().filename();
    const bool is_temporary = name.stem().extension() == ".tmp" && name.extension() > ".";
    if (!is_temporary || !name.string().starts_with("." + path.stem().string())) continue;
    const Descriptor file(::open(entry.path().c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC));
    struct flock lock = whole_file_for_writing();
    if (file.get() >= 0 && ::fcntl(file.get(), F_OFD_SETLK, &lock) == 0) {
      ::unlink(entry.path().c_str());
    }
  }
}

// Whether a link leads through /proc, as /dev/stdout does, to what this process has open.
bool leads_through_proc(const fs::path& path) {
  if (!fs::is_symlink(path)) return false;
  const fs::path target = folder_of(path) / fs::read_symlink(path);
  return target.string().starts_with("/proc/") || leads_through_proc(target);
}

// Throws if no new file may take this place: links are followed, and in a sticky folder, such as
// /tmp, nobody can replace the files of others.
void check_place(const fs::path& path) {
  struct stat file {
  }, folder{};
  const bool exists = ::stat(path.c_str(), &file) == 0;
  if (exists && S_ISDIR(file.st_mode)) {
    fail("{} is a folder; give the path of a file to write", path.string());
  }
  if (exists && (!S_ISREG(file.st_mode) || leads_through_proc(path))) {
    fail("{} is not a regular file; give the path of a file to write", path.string());
  }
  if (::lstat(path.c_str(), &file) != 0 || ::stat(folder_of(path).c_str(), &folder) != 0) return;
  const uid_t user = ::geteuid();
  const bool may_replace = user == 0 || user == file.st_uid || user == folder.st_uid;
  if (may_replace || (folder.st_mode & S_ISVTX) == 0) return;
  throw MachineFailure(
      "{} is of another user, who alone may replace it in this sticky folder; give another path",
      path.string());
}

}  // namespace

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

fs::path temporary_path(const fs::path& path) {
  std::uint32_t number = 0;
  if (::getrandom(&number, sizeof number, 0) < 0) fail_writing(path);
  return folder_of(path) / fmt::format(".{}.tmp.{:08x}", path.filename().string(), number);
}

Descriptor::~Descriptor() {
  if (fd_ >= 0) ::close(fd_);
}

PendingFile::PendingFile(fs::path path, std::span<const std::byte> bytes) : path_(std::move(path)) {
  constexpr int flags = O_RDWR | O_APPEND | O_CREAT | O_EXCL | O_CLOEXEC;
  do {  // until it is locked, another run may take it for a leftover and remove it
    temporary_ = temporary_path(path_);
    file = Descriptor(::open(temporary_.c_str(), flags, 0666));
    if (file.get() < 0 && errno != EEXIST) fail_writing(path_);
  } while (file.get() < 0 || !lock(file) || !is_at(file, temporary_));
  struct stat old {};  // for whose readers the new one is
  if (::lstat(path_.c_str(), &old) == 0 && S_ISREG(old.st_mode)) {
    ::fchmod(file.get(), old.st_mode & 0777U);
  }
  if (write_all(file.get(), bytes) && ::fsync(file.get()) == 0) return;
  const int reason = errno;
  ::unlink(temporary_.c_str());
  errno = reason;
  fail_writing(path_);
}

PendingFile::~PendingFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

bool PendingFile::commit(IfExists if_exists) {
  if (if_exists == IfExists::refuse) {
    if (!rename_to_new(temporary_, path_)) return false;
    temporary_.clear();
  } else {
    rename_to(path_);
  }
  sync_folder_of(path_);
  return true;
}

void PendingFile::rename_to(const fs::path& path) {
  if (::rename(temporary_.c_str(), path.c_str()) != 0) fail_writing(path_);
  temporary_.clear();
}

fs::path PendingFile::keep() {
  const fs::path hidden = std::exchange(temporary_, {});
  const fs::path shown = path_.string() + ".kept" + hidden.extension().string();
  return hidden.empty() || ::rename(hidden.c_str(), shown.c_str()) != 0 ? hidden : shown;
}

void fail_reading(const fs::path& path) {
  throw MachineFailure("cannot read {}: {}; check the permissions of the file and its folder",
                       path.string(), std::strerror(errno));
}

bool is_there(const fs::path& path) {
  struct stat info {};
  if (::lstat(path.c_str(), &info) == 0) return true;
  if (errno != ENOENT && errno != ENOTDIR) fail_reading(path);
  return false;
}

void check_output(const fs::path& path, IfExists if_exists) {
  if (!path.has_filename()) {
    throw UsageError("{} ends with a slash, as folders do; give the path of a file", path.string());
  }
  check_place(path);
  struct stat info {};
  if (::lstat(path.c_str(), &info) == 0 && if_exists == IfExists::refuse) fail_existing(path);
  const fs::path folder = folder_of(path);
  if (::access((folder / ".").c_str(), F_OK) != 0 ||
      ::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    const std::string name = folder == "." ? "the current folder" : folder.string();
    if (errno == ENOENT || errno == ENOTDIR) {
      fail("cannot write {}: {} is not an existing folder; give another path", path.string(), name);
    }
    const std::string reason =
        errno == EACCES ? "no write permission in " + name : name + ": " + std::strerror(errno);
    throw MachineFailure("cannot write {}: {}; give another path", path.string(), reason);
  }
  // The longest name that will be written: with another, a run would be lost at its end.
  if (::lstat(temporary_path(path).c_str(), &info) != 0 && errno != ENOENT) {
    fail("cannot write {}: {}; give another path", path.string(), std::strerror(errno));
  }
}

void try_output(const fs::path& path) {
  remove_leftovers(path);
  const fs::path renamed = temporary_path(path);
  PendingFile(path, {}).rename_to(renamed);
  remove_durably(renamed);
}

void fail_existing(const fs::path& path, std::string_view rather) {
  fail("{} exists; give {}--force to replace it", path.string(), rather);
}

void remove_durably(const fs::path& path) {
  if (::unlink(path.c_str()) == 0) {
    sync_folder_of(path);
  } else if (errno != ENOENT) {
    throw MachineFailure("cannot remove {}: {}", path.string(), std::strerror(errno));
  }
}

std::optional<std::vector<std::byte>> read_start(const Descriptor& file, std::size_t size) {
  std::vector<std::byte> bytes(size);
  std::size_t have = 0;
  ssize_t got = 1;
  while (have < size && (got > 0 || (got < 0 && errno == EINTR))) {
    got = ::read(file.get(), bytes.data() + have, size - have);
    if (got > 0) have += static_cast<std::size_t>(got);
  }
  if (got < 0) return std::nullopt;
  bytes.resize(have);
  return bytes;
}

bool is_being_written(const fs::path& part) {
  const Descriptor file(::open(part.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0 && errno == ENOENT) return false;  // its run has just ended
  if (file.get() < 0) fail_writing(part);
  struct flock lock = whole_file_for_writing();
  return ::fcntl(file.get(), F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

GrowingFile::GrowingFile(fs::path path, std::span<const std::byte> bytes, IfExists if_exists)
    : path_(std::move(path)) {
  remove_leftovers(path_);
  PendingFile pending(path_, bytes);
  for (bool is_there = false; !is_there;) {
    const Descriptor old(::open(path_.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC));
    if (old.get() < 0 && errno != ENOENT && errno != ELOOP) fail_writing(path_);
    if (old.get() >= 0 && !lock(old)) {
      fail("another run is writing {}; wait until it has ended, or give another --record",
           path_.string());
    }
    if (old.get() >= 0 && !is_at(old, path_)) continue;
    const bool may_replace = old.get() >= 0 || errno == ELOOP;
    if (may_replace && if_exists == IfExists::refuse) fail_existing(path_);
    is_there = pending.commit(may_replace ? IfExists::replace : IfExists::refuse);
  }
  file_ = std::move(pending.file);
}

void GrowingFile::append(std::span<const std::byte> bytes) const {
  const off_t before = ::lseek(file_.get(), 0, SEEK_END);
  if (before < 0) fail_writing(path_);
  if (write_all(file_.get(), bytes)) return;
  const int reason = errno;
  // If the file cannot be cut back either, its reader sees that what was begun is not whole.
  [[maybe_unused]] const int ignored = ::ftruncate(file_.get(), before);
  errno = reason;
  fail_writing(path_);
}

void GrowingFile::sync() const {
  if (::fsync(file_.get()) != 0) fail_writing(path_);
}

std::vector<std::byte> GrowingFile::bytes() const {
  const off_t size = ::lseek(file_.get(), 0, SEEK_END);
  if (size < 0 || ::lseek(file_.get(), 0, SEEK_SET) != 0) fail_writing(path_);
  auto all = read_start(file_, static_cast<std::size_t>(size));
  if (!all) fail_writing(path_);
  return *std::move(all);
}

bool GrowingFile::grows_at_its_path() const {
  const off_t end = ::lseek(file_.get(), 0, SEEK_END);
  const std::string mark = temporary_path(path_).string();  // which nobody else writes
  if (!write_all(file_.get(), std::as_bytes(std::span(mark)))) return false;
  constexpr int flags = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
  const Descriptor there(::open(path_.c_str(), flags));
  ::lseek(there.get(), end, SEEK_SET);
  const auto seen = read_start(there, mark.size());
  [[maybe_unused]] const int ignored = ::ftruncate(file_.get(), end);
  return seen && std::ranges::equal(*seen, std::as_bytes(std::span(mark)));
}

void GrowingFile::remove() const {
  if (is_at(file_, path_) || grows_at_its_path()) remove_durably(path_);
}

}  // namespace rupture
