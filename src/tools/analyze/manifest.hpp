// Lists of content checksums: manifests and .sum files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rupture::tools {

/// A line "content-sha256 <64 hex digits>  <file name>"; earlier builds wrote it without the first
/// word, and such lines are read for ever.
struct ManifestLine {
  std::string checksum;
  std::filesystem::path file;  ///< names in a manifest are relative to its own folder
};

/// Throws Failure if the manifest cannot be read, names no file or is none.
std::vector<ManifestLine> read_manifest(const std::filesystem::path& path);

}  // namespace rupture::tools
