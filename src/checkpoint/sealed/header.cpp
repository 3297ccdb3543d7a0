#include "rupture/checkpoint/header.hpp"

#include <algorithm>
#include <charconv>

#include "checkpoint/content/context.hpp"
#include "rupture/checkpoint/checksum.hpp"

namespace rupture {
namespace {

constexpr std::uint64_t kLargestFile = 1ULL << 62U;  // [bytes]

std::string_view explanation(FileKind kind) {
  if (kind == FileKind::open_record) {
    return "One of the pieces of an unfinished record, which follow each other in this file.\n"
           "An HDF5 file starts at byte 512 of each.\n";
  }
  return "An HDF5 file starts at byte 512; the SHA-256 is that of\n"
         "tail -c +513 FILE | sha256sum\n";
}

std::string sealed_header(FileKind kind, std::uint64_t size, std::string_view body_sha256) {
  std::string header = fmt::format("{}\nbytes {}\nsha256 {}\n{}", format_name(kind), size,
                                   body_sha256, explanation(kind));
  header.resize(kHeaderSize, '\n');
  return header;
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

// The size of the file that its header states [bytes]; 0 if it states none.
std::uint64_t stated_size(std::span<const std::byte> header) {
  const std::string_view digits =
      line_after(as_text(header.first(std::min(header.size(), kHeaderSize))), "\nbytes ");
  std::uint64_t size = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), size);
  return std::min(size, kLargestFile);
}

[[noreturn]] void refuse_foreign(std::string_view start, const std::string& name) {
  if (start.starts_with("\x89HDF\r\n")) {
    throw NotOurs(
        "{} is an HDF5 file without rupture's 512-byte header: it was not written by rupture, or "
        "was rewritten by another program; give the original file, or try rupture seal {} -o "
        "NEW.h5",
        name, name);
  }
  throw NotOurs("{} is not a checkpoint or record of rupture", name);
}

}  // namespace

std::string header_text(FileKind kind, std::span<const std::byte> body) {
  return sealed_header(kind, kHeaderSize + body.size(), sha256(body));
}

FileKind header_kind(std::span<const std::byte> file, const std::string& name) {
  const std::string_view start = as_text(file.first(std::min(file.size(), kHeaderSize)));
  if (start.empty()) {
    throw NotOurs("{} is empty; expected a checkpoint or record", name);
  }
  const auto kind = std::ranges::find_if(kFileKinds, [&](FileKind known) {
    const std::string first_line = fmt::format("{}\n", format_name(known));
    return first_line.starts_with(start.substr(0, first_line.size()));  // a file of any length
  });
  if (kind == kFileKinds.end()) refuse_foreign(start, name);
  if (start.size() < kHeaderSize) {
    fail(
        "{} is truncated: it ends within its 512-byte header, after {} bytes; copy it again or "
        "recreate it",
        name, start.size());
  }
  return *kind;
}

bool has_its_header(std::span<const std::byte> file, FileKind kind) {
  return file.size() >= kHeaderSize &&
         as_text(file.first(kHeaderSize)) == header_text(kind, file.subspan(kHeaderSize));
}

std::size_t intact_piece(std::span<const std::byte> bytes) {
  const std::uint64_t size = stated_size(bytes);
  if (size > bytes.size()) return 0;
  return has_its_header(bytes.first(size), FileKind::open_record) ? size : 0;
}

FileKind check_envelope(std::span<const std::byte> file, const std::string& name) {
  const FileKind kind = header_kind(file, name);
  if (has_its_header(file, kind)) return kind;

  const std::string_view header = as_text(file.first(kHeaderSize));
  const std::uint64_t size = stated_size(file);
  const std::string_view stated = line_after(header, "\nsha256 ");
  const bool header_is_whole = header == sealed_header(kind, size, stated);
  const bool is_cut =
      header_is_whole && file.size() < size && stated != sha256(file.subspan(kHeaderSize));
  throw BrokenSeal(
      "{} is damaged or was changed by another program: {}; if it was changed, rupture seal {} -o "
      "NEW.h5 checks and seals it; otherwise copy it again or recreate it",
      name,
      is_cut ? fmt::format("it has {} of {} bytes", file.size(), size)
             : "its bytes do not match the SHA-256 in its header",
      name);
}

}  // namespace rupture
