#include "rupture/checkpoint/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

#include "atomic_write.hpp"
#include "context.hpp"
#include "hdf5_image.hpp"
#include "part_file.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/model/error.hpp"
#include "rupture/version.hpp"
#include "seal.hpp"

namespace rupture {
namespace {

namespace fs = std::filesystem;

constexpr const char* kUnknown = "a newer rupture";  // that wrote a file

[[noreturn]] void fail_reading(const fs::path& path) {
  throw Failure(
      fmt::format("could not read {}: {}; check the permissions of the file and its folder",
                  path.string(), std::strerror(errno)));
}

// Throws unless a regular file is there; returns its size [bytes].
std::size_t readable_size(const fs::path& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) {
    if (errno != ENOENT && errno != ENOTDIR) fail_reading(path);
    throw Failure(
        fmt::format("{} does not exist; give the path of a checkpoint or record", path.string()));
  }
  if (S_ISDIR(info.st_mode)) {
    throw Failure(
        fmt::format("{} is a folder; give the path of a checkpoint or record", path.string()));
  }
  if (!S_ISREG(info.st_mode)) {
    throw Failure(fmt::format("{} is not a regular file; give the path of a checkpoint or record",
                              path.string()));
  }
  return static_cast<std::size_t>(info.st_size);
}

// The first `size` bytes of the file, or fewer if it ends before.
std::vector<std::byte> read_start(const fs::path& path, std::size_t size) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) fail_reading(path);
  std::vector<std::byte> bytes(size);
  std::size_t have = 0;
  ssize_t got = 1;
  while (have < size && (got > 0 || (got < 0 && errno == EINTR))) {
    got = ::read(fd, bytes.data() + have, size - have);
    if (got > 0) have += static_cast<std::size_t>(got);
  }
  const int reason = got < 0 ? errno : 0;
  ::close(fd);
  errno = reason;
  if (got < 0) fail_reading(path);
  bytes.resize(have);
  return bytes;
}

[[noreturn]] void refuse_newer(std::int64_t schema_version, const std::string& writer) {
  throw Failure(fmt::format(
      "written by {} (schema {}); this is rupture {}, which reads up to schema {}: use {}", writer,
      schema_version, version, kSchemaVersion, writer + (writer == kUnknown ? "" : " or newer")));
}

// "rupture 0.9.0", of a file of a newer schema.
std::string writer_of(const hdf5::Reader& reader) {
  try {
    return "rupture " + reader.writer_version();
  } catch (const Failure&) {
    return kUnknown;
  }
}

void check_attributes(const hdf5::RootAttributes& attributes, FileKind kind) {
  if (attributes.schema_version < 1 || attributes.format != format_name(kind)) {
    throw Failure(
        fmt::format("its header says {}, but its attributes say {}, schema version {}; "
                    "write it anew",
                    format_name(kind), attributes.format, attributes.schema_version));
  }
}

void check_content(const Content& content, const std::string& stored) {
  check_finite(content);
  const std::string computed = content_checksum(content);
  if (stored != computed) {
    throw Failure(
        fmt::format("its content has the checksum {}, but {} is stored in it; write it "
                    "anew",
                    computed, stored));
  }
}

std::string sum_line(const std::string& checksum, const fs::path& path) {
  return fmt::format("{}  {}\n", checksum, path.filename().string());
}

void write_sum(const fs::path& path, const std::string& checksum) {
  const fs::path sum = path.string() + ".sum";
  const std::string line = sum_line(checksum, path);
  std::ifstream file(sum, std::ios::binary);
  const std::string present{std::istreambuf_iterator<char>(file), {}};
  if (present == line) return;  // workflow rules go by its modification time
  write_atomically(sum, std::as_bytes(std::span(line)));
}

}  // namespace

void check_output(const fs::path& path, IfExists if_exists) {
  if (!path.has_filename())
    throw UsageError("an output has an empty name; give the path of a file");
  struct stat info {};
  const bool exists = ::lstat(path.c_str(), &info) == 0;
  if (exists && S_ISDIR(info.st_mode)) {
    throw Failure(fmt::format("{} is a folder; give the path of a file to write", path.string()));
  }
  if (exists && if_exists == IfExists::refuse) {
    throw Failure(fmt::format("{} exists; give --force to replace it", path.string()));
  }
  if (exists && !S_ISREG(info.st_mode) && !S_ISLNK(info.st_mode)) {
    throw Failure(fmt::format("{} is not a regular file; give another path", path.string()));
  }
  const std::string sum = path.string() + ".sum";
  if (::lstat(sum.c_str(), &info) == 0 && S_ISDIR(info.st_mode)) {
    throw Failure(fmt::format("{} is a folder where the checksum of {} belongs; give another path",
                              sum, path.string()));
  }
  const fs::path folder = folder_of(path);
  if (::access((folder / ".").c_str(), F_OK) != 0 ||
      ::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    throw Failure(fmt::format("could not write {}: its folder {}: {}; give another path",
                              path.string(), folder.string(), std::strerror(errno)));
  }
}

FileKind identify(const fs::path& path) {
  readable_size(path);
  return header_kind(read_start(path, kHeaderSize), path.string());
}

Sealed seal(FileKind kind, const Content& content) {
  check_finite(content);
  const std::string checksum = content_checksum(content);
  std::vector<std::byte> bytes =
      hdf5::make_image({std::string(format_name(kind)), kSchemaVersion, checksum}, content);
  const std::string header = header_text(kind, std::span(bytes).subspan(kHeaderSize));
  std::memcpy(bytes.data(), header.data(), header.size());
  return {checksum, std::move(bytes)};
}

ContentFile unseal(FileKind kind, std::span<const std::byte> file) {
  const hdf5::Reader reader(file);
  const hdf5::RootAttributes attributes = reader.attributes();
  if (attributes.schema_version > kSchemaVersion) {
    refuse_newer(attributes.schema_version, writer_of(reader));
  }
  check_attributes(attributes, kind);
  ContentFile read = {kind, attributes.content_checksum, reader.content()};
  check_content(read.content, read.checksum);
  return read;
}

std::string write_content(const fs::path& path, FileKind kind, const Content& content,
                          IfExists if_exists) {
  check_output(path, if_exists);
  const Sealed sealed = naming(path, [&] { return seal(kind, content); });
  write_atomically(path, sealed.bytes);
  write_sum(path, sealed.checksum);
  return sealed.checksum;
}

ContentFile read_file(const fs::path& path) {
  if (identify(path) == FileKind::open_record) {
    return read_bytes(read_start(path, readable_size(path)), path.string());
  }
  // One byte more than there should be is enough to notice that there is too much.
  const std::uint64_t stated = stated_size(read_start(path, kHeaderSize));
  return read_bytes(read_start(path, std::min(readable_size(path), stated + 1)), path.string());
}

ContentFile read_bytes(std::span<const std::byte> bytes, const std::string& name) {
  if (header_kind(bytes, name) == FileKind::open_record) {
    return {FileKind::open_record, "", naming(name, [&] { return read_pieces(bytes); })};
  }
  const FileKind kind = check_envelope(bytes, name);
  return naming(name, [&] { return unseal(kind, bytes); });
}

Content read_content(const fs::path& path) {
  return read_file(path).content;
}

}  // namespace rupture
