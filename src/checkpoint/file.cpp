#include "rupture/checkpoint/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "atomic_write.hpp"
#include "context.hpp"
#include "seal.hpp"

namespace rupture {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_reading(const fs::path& path) {
  throw MachineFailure("cannot read {}: {}; check the permissions of the file and its folder",
                       path.string(), std::strerror(errno));
}

// Throws unless a regular file is there; returns its size [bytes].
std::size_t readable_size(const fs::path& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) {
    if (errno != ENOENT && errno != ENOTDIR) fail_reading(path);
    const std::string name = path.string(), part = name + ".part";
    std::error_code ignored;
    fail("{} does not exist{}; give the path of a checkpoint or record", name,
         fs::exists(part, ignored) ? fmt::format(" yet, but {} does", part) : "");
  }
  if (S_ISDIR(info.st_mode)) {
    fail("{} is a folder; give the path of a checkpoint or record", path.string());
  }
  if (!S_ISREG(info.st_mode)) {
    throw NotOurs("{} is not a regular file; give the path of a checkpoint or record",
                  path.string());
  }
  return static_cast<std::size_t>(info.st_size);
}

// The first `size` bytes of the file, or fewer if it ends before.
std::vector<std::byte> read_start(const fs::path& path, std::size_t size) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  auto bytes = file.get() < 0 ? std::nullopt : read_start(file, size);
  if (!bytes) fail_reading(path);
  return *std::move(bytes);
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

FileKind identify(const fs::path& path) {
  readable_size(path);
  return header_kind(read_start(path, kHeaderSize), path.string());
}

std::string write_content(const fs::path& path, FileKind kind, const Content& content,
                          IfExists if_exists) {
  const Sealed sealed = naming(path, [&] { return seal(kind, content); });
  PendingFile file(path, sealed.bytes);
  try {
    check_output(path, if_exists);  // others may have written here during a run
    if (!file.commit(if_exists)) fail_existing(path);
  } catch (const Failure& failure) {
    const std::string kept = file.keep();
    if (kept.empty()) throw;
    fail_like(failure, "{}; the result is kept as {}", failure.what(), kept);
  }
  return sealed.checksum;
}

ContentFile read_file(const fs::path& path) {
  identify(path);  // of a file that is not ours the start is enough
  return read_bytes(read_start(path, readable_size(path)), path.string());
}

ContentFile read_bytes(std::span<const std::byte> bytes, const std::string& name) {
  const FileKind kind = header_kind(bytes, name);
  if (kind != FileKind::open_record) check_envelope(bytes, name);
  return naming(name, [&] {
    return kind == FileKind::open_record ? put_together(bytes) : unseal(kind, bytes);
  });
}

EditedFile read_edited(const fs::path& path) {
  const auto bytes = read_start(path, readable_size(path));
  const std::string name = path.string();
  if (bytes.empty()) throw NotOurs("{} is empty; expected a checkpoint or record", name);
  if (intact_piece(bytes) > 0) {
    fail("{} is an unfinished record: rupture finish {} -o NEW.h5 makes a record of it", name,
         name);
  }
  EditedFile file = naming(path, [&] {
    try {
      return open_edited(bytes);
    } catch (const hdf5::LibraryFailure& failure) {
      fail("{}; it is damaged or not an HDF5 file: copy it again or recreate it", failure.what());
    }
  });
  file.name = name;
  file.is_sealed = file.content_is_as_sealed && has_its_header(bytes, file.kind);
  return file;
}

}  // namespace rupture
