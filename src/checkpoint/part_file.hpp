// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

// The .part file of a record: small sealed records, the pieces, one after another.
//
// Each flush appends a piece, so that whatever happens to the process or the disk, the pieces
// before stay as they are, and what is not whole behind them is seen by its SHA-256.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "atomic_write.hpp"
#include "rupture/checkpoint/content.hpp"

namespace rupture {

class PartFile {
 public:
  /// Creates the file, replacing one that is there, with its first piece: every dataset of the
  /// record. Throws Failure, also if another process is writing the file.
  PartFile(std::filesystem::path path, const Content& first);

  /// Adds a piece with further rows of some datasets. Throws Failure; the file then ends as it did.
  void append(const Content& rows) const;

  /// Brings all pieces to the disk. Throws Failure.
  void sync() const;

 private:
  std::filesystem::path path_;
  std::optional<WriterLock> lock_;
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
