#include "rupture/checkpoint/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "checkpoint/content/context.hpp"
#include "checkpoint/files/atomic_write.hpp"
#include "checkpoint/sealed/seal.hpp"

namespace rupture {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

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

ContentFile read_file(const fs::path& path, std::optional<FileKind> wanted) {
  const FileKind kind = identify(path);  // of a file that is not ours the start is enough
  const auto is_checkpoint = [](FileKind one) { return one == FileKind::checkpoint; };
  if (wanted && is_checkpoint(kind) != is_checkpoint(*wanted)) {
    fail("{} is {}; expected {}", path.string(), kind_text(kind), kind_text(*wanted));
  }
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
