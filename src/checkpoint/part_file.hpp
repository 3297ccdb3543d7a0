// The .part file of a record: small sealed records, the pieces, one after another.
//
// Each flush appends a piece, so that whatever happens to the process or the disk, the pieces
// before stay as they are, and what is not whole behind them is seen by its SHA-256.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

#include "atomic_write.hpp"
#include "rupture/checkpoint/content.hpp"

namespace rupture {

class PartFile {
 public:
  /// Creates the file with its first piece: every dataset of the record. Throws Failure as
  /// GrowingFile does.
  PartFile(const std::filesystem::path& path, const Content& first, IfExists if_exists);

  /// Adds a piece with further rows of some datasets. Throws Failure; the file then ends as it did.
  void append(const Content& rows) const { file_.append(sealed(rows)); }

  /// Brings all pieces to the disk. Throws Failure.
  void sync() const { file_.sync(); }

  /// All pieces put together, wherever the file is by now. Throws Failure.
  Content content() const;

  /// Removes the file, unless it was moved.
  void remove() const { file_.remove(); }

 private:
  std::vector<std::byte> sealed(const Content& piece) const;

  std::filesystem::path path_;
  GrowingFile file_;
};

/// The datasets in the intact pieces at the start of `file`, those that grow put together, and how
/// many bytes are left behind them. Throws Failure if not even the first is intact, or if they do
/// not fit together.
struct Pieces {
  Content content;
  std::uint64_t ignored_bytes = 0;
};
Pieces read_pieces(std::span<const std::byte> file);

}  // namespace rupture
