#include "rupture/checkpoint/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>

#include "atomic_write.hpp"
#include "context.hpp"
#include "rupture/checkpoint/checksum.hpp"
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

std::string sum_line(const std::string& checksum, const fs::path& path) {
  return fmt::format("{}  {}\n", labelled(checksum), path.filename().string());
}

// The line of a .sum; nothing if anything but a short file has this name. No link is followed.
std::string line_in(const fs::path& sum) {
  struct stat info {};
  if (::lstat(sum.c_str(), &info) != 0 || !S_ISREG(info.st_mode) || info.st_size > 512) return "";
  std::ifstream file(sum, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Whether it is that of a .sum of the file, of any version.
bool is_sum_line(const std::string& line, const fs::path& path) {
  const std::string label = labelled("");
  const std::size_t start = line.starts_with(label) ? label.size() : 0;  // not in old versions
  constexpr std::size_t digits = 64;
  return line.size() > start + digits &&
         line.substr(start + digits) == sum_line("", path).substr(label.size());
}

// Gives a file its name and replaces its .sum, or removes the latter. Both are on the disk before
// anything is replaced, and no .sum is there while it would be that of the other file. Of what is
// no .sum, nothing is removed; it is replaced only if a .sum is wanted and the file may be, too.
void publish(PendingFile& file, const fs::path& path, const std::string& line, IfExists if_exists,
             SumFile wanted) {
  const fs::path sum = sum_path(path);
  const bool is_other = is_there(sum);  // if not, one that appears now is of another run
  const std::string there = line_in(sum);
  const bool is_current = there == line;  // workflow rules go by its modification time
  const bool is_wanted = wanted == SumFile::write;
  const bool may_replace =
      !is_other || is_sum_line(there, path) || (is_wanted && if_exists == IfExists::replace);
  std::optional<PendingFile> new_sum;
  if (!is_current && may_replace) {
    if (is_wanted) new_sum.emplace(sum, std::as_bytes(std::span(line)));
    if (is_other) remove_durably(sum);
  }
  if (!file.commit(if_exists)) fail_existing(path);
  if (new_sum) new_sum->commit(IfExists::replace);
  if (is_wanted && !is_current && !new_sum) fail_existing(sum);
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
  const fs::path sum = sum_path(path);
  check_place(sum);
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
  if (::lstat(temporary_path(sum).c_str(), &info) != 0 && errno != ENOENT) {
    fail("cannot write {}: {}; give another path", path.string(), std::strerror(errno));
  }
}

FileKind identify(const fs::path& path) {
  readable_size(path);
  return header_kind(read_start(path, kHeaderSize), path.string());
}

std::string write_content(const fs::path& path, FileKind kind, const Content& content,
                          IfExists if_exists, SumFile sum) {
  const Sealed sealed = naming(path, [&] { return seal(kind, content); });
  PendingFile file(path, sealed.bytes);
  try {
    check_output(path, if_exists);  // others may have written here during a run
    publish(file, path, sum_line(sealed.checksum, path), if_exists, sum);
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

fs::path sum_path(const fs::path& path) {
  return path.string() + ".sum";
}

bool may_replace_sum(const fs::path& path) {
  const fs::path sum = sum_path(path);
  return !is_there(sum) || is_sum_line(line_in(sum), path);
}

void restore_sum(const fs::path& path, IfExists if_exists) {
  const fs::path sum = sum_path(path);
  const std::string line = sum_line(read_file(path).checksum, path);
  if (line_in(sum) == line) return;
  if (may_replace_sum(path)) if_exists = IfExists::replace;
  if (!PendingFile(sum, std::as_bytes(std::span(line))).commit(if_exists)) fail_existing(sum);
}

}  // namespace rupture
