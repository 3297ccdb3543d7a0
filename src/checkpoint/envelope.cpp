#include "rupture/checkpoint/envelope.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "rupture/checkpoint/checksum.hpp"
#include "rupture/model/error.hpp"

namespace rupture {
namespace {

constexpr std::uint64_t kLargestFile = 1ULL << 62U;  // [bytes]

constexpr std::string_view kOpenLines =
    "open: still being recorded, or interrupted; nothing protects its bytes\n"
    "An HDF5 file starts at byte 512.\n";

std::string padded(std::string text) {
  text.resize(kHeaderSize, '\n');
  return text;
}

std::string open_header() {
  return padded(fmt::format("{}\n{}", format_name(FileKind::open_record), kOpenLines));
}

std::string sealed_header(FileKind kind, std::uint64_t file_size, std::string_view body_sha256) {
  return padded(
      fmt::format("{}\nbytes {}\nsha256 {}\n"
                  "An HDF5 file starts at byte 512; the SHA-256 is that of\n"
                  "tail -c +513 FILE | sha256sum\n",
                  format_name(kind), file_size, body_sha256));
}

std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// The rest of the line in `header` that starts with `key`; empty if there is none.
std::string_view line_after(std::string_view header, std::string_view key) {
  const std::size_t at = header.find(key);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = header.substr(at + key.size());
  return rest.substr(0, rest.find('\n'));
}

// True if `start`, the start of a file of any length, is that of a file of this kind.
bool starts_as(std::string_view start, FileKind kind) {
  const std::string first_line = fmt::format("{}\n", format_name(kind));
  return start.substr(0, first_line.size()) == std::string_view(first_line).substr(0, start.size());
}

[[noreturn]] void refuse_foreign(std::string_view start, const std::string& name) {
  if (start.starts_with("\x89HDF\r\n")) {
    throw Failure(fmt::format(
        "{} is an HDF5 file without rupture's 512-byte header: it was not written by rupture, or "
        "was rewritten by another program; give the original file",
        name));
  }
  throw Failure(fmt::format(
      "{} is not a rupture file: expected the 512-byte header of a checkpoint or record; give a "
      "file that one of rupture's tools wrote",
      name));
}

}  // namespace

std::string_view format_name(FileKind kind) {
  return kind == FileKind::checkpoint ? "rupture-checkpoint" : "rupture-record";
}

std::string_view kind_text(FileKind kind) {
  switch (kind) {
    case FileKind::checkpoint:
      return "a checkpoint";
    case FileKind::record:
      return "a record";
    case FileKind::open_record:
      return "an unfinished record";
  }
  throw Failure("a file is of a kind unknown to this build");
}

std::string header_text(FileKind kind, std::span<const std::byte> body) {
  if (kind == FileKind::open_record) return open_header();
  return sealed_header(kind, kHeaderSize + body.size(), sha256(body));
}

FileKind header_kind(std::span<const std::byte> file, const std::string& name) {
  const std::string_view start = as_text(file.first(std::min(file.size(), kHeaderSize)));
  if (start.empty()) {
    throw Failure(fmt::format("{} is empty; expected a checkpoint or record", name));
  }
  if (!starts_as(start, FileKind::checkpoint) && !starts_as(start, FileKind::record)) {
    refuse_foreign(start, name);
  }
  if (start.size() < kHeaderSize) {
    throw Failure(
        fmt::format("{} is truncated: it ends within its 512-byte header, after {} bytes; copy it "
                    "again or write it anew",
                    name, start.size()));
  }
  if (start == open_header()) return FileKind::open_record;
  return starts_as(start, FileKind::checkpoint) ? FileKind::checkpoint : FileKind::record;
}

std::uint64_t stated_size(std::span<const std::byte> header) {
  const std::string_view digits = line_after(as_text(header), "\nbytes ");
  std::uint64_t size = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), size);
  return std::min(size, kLargestFile);
}

FileKind check_envelope(std::span<const std::byte> file, const std::string& name) {
  const FileKind kind = header_kind(file, name);
  if (kind == FileKind::open_record) return kind;
  const std::string_view header = as_text(file.first(kHeaderSize));
  const std::string body_sha256 = sha256(file.subspan(kHeaderSize));
  if (header == sealed_header(kind, file.size(), body_sha256)) return kind;

  const std::uint64_t size = stated_size(file.first(kHeaderSize));
  if (file.size() < size && line_after(header, "\nsha256 ") != body_sha256) {
    throw Failure(
        fmt::format("{} is truncated: it holds {} of {} bytes; copy it again or write it anew",
                    name, file.size(), size));
  }
  throw Failure(
      fmt::format("{} is damaged: its bytes and the SHA-256 in its header do not agree; copy it "
                  "again or write it anew",
                  name));
}

}  // namespace rupture
