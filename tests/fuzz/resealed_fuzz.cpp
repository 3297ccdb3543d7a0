// Any bytes with a valid header in front, as if rupture itself had sealed them: what our checks
// behind libhdf5 do with a file that libhdf5 can read. libhdf5 1.10.8 itself does not withstand
// this (docs/tests.md), so this target is for replaying its corpus and for runs by hand.
#include <vector>

#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/model/error.hpp"

using namespace rupture;

namespace {

std::vector<std::byte> sealed(std::span<const std::byte> file) {
  const auto body = file.subspan(kHeaderSize);
  const FileKind kind = header_kind(file, "x.h5");
  const std::string header =
      header_text(kind == FileKind::checkpoint ? FileKind::checkpoint : FileKind::record, body);
  const auto start = std::as_bytes(std::span(header));
  std::vector<std::byte> bytes(start.begin(), start.end());
  bytes.insert(bytes.end(), body.begin(), body.end());
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto input = std::as_bytes(std::span(data, size));
  if (size < kHeaderSize) return 0;
  try {
    const ContentFile file = read_bytes(sealed(input), "x.h5");
    if (file.kind == FileKind::checkpoint) {
      checkpoint_from(file.content);
    } else {
      record_from(file);
    }
  } catch (const Failure&) {
  }
  return 0;
}
