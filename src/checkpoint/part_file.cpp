#include "part_file.hpp"

#include <utility>

#include "context.hpp"
#include "rupture/model/error.hpp"
#include "seal.hpp"

namespace rupture {
namespace {

void append_rows(const std::string& path, Dataset& whole, const Dataset& rows) {
  const auto row_shape = [](const Dataset& dataset) {
    return Shape(dataset.shape.begin() + (dataset.shape.empty() ? 0 : 1), dataset.shape.end());
  };
  if (whole.shape.empty() || rows.shape.empty() || whole.type != rows.type ||
      row_shape(whole) != row_shape(rows)) {
    fail("rows of {} do not continue those of the pieces before", path);
  }
  whole.shape[0] += rows.shape[0];
  whole.bytes.insert(whole.bytes.end(), rows.bytes.begin(), rows.bytes.end());
}

void append_piece(Content& whole, const Content& piece) {
  for (const auto& [path, rows] : piece) {
    const auto found = whole.find(path);
    if (found == whole.end()) {
      fail("{} is missing in the first piece of the record", path);
    }
    append_rows(path, found->second, rows);
  }
}

}  // namespace

PartFile::PartFile(const std::filesystem::path& path, const Content& first, IfExists if_exists)
    : path_(path), file_(path, sealed(first), if_exists) {}

std::vector<std::byte> PartFile::sealed(const Content& piece) const {
  return naming(path_, [&] { return seal(FileKind::open_record, piece); }).bytes;
}

Content PartFile::content() const {
  return naming(path_, [&] {
    Pieces pieces = read_pieces(file_.bytes());
    if (pieces.ignored_bytes == 0) return std::move(pieces.content);
    throw Failure("another program has changed the unfinished record, or the disk damaged it");
  });
}

Pieces read_pieces(std::span<const std::byte> file) {
  Content whole;
  bool first = true;
  while (const std::size_t size = intact_piece(file)) {
    Content piece = unseal(FileKind::open_record, file.first(size)).content;
    if (std::exchange(first, false)) {
      whole = std::move(piece);
    } else {
      append_piece(whole, piece);
    }
    file = file.subspan(size);
  }
  if (first) throw Failure("the first piece of the unfinished record is damaged");
  return {std::move(whole), file.size()};
}

}  // namespace rupture
