// Files that another program may have changed since rupture sealed them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rupture/checkpoint/file.hpp"
#include "rupture/checkpoint/provenance.hpp"

namespace rupture {

/// What such a file holds. How it is stored does not matter: it may be cut into chunks and
/// compressed, its texts may have any form, units may be missing.
struct EditedFile {
  std::string name;  ///< for messages
  FileKind kind = FileKind::checkpoint;
  std::string sealed_checksum;  ///< content checksum that rupture stored; empty if it is gone
  std::string checksum;         ///< that of what it holds now, by the present rule
  bool content_is_as_sealed = false;
  Content content;
};

/// Reads it, first in a child process, which takes the harm if the file makes libhdf5 crash. Throws
/// Failure in one sentence that names the file, also if it holds no checkpoint or record.
EditedFile read_edited(const std::filesystem::path& path);

/// The content to be sealed: checked as read_checkpoint() and read_record() do, with `entry` at the
/// end of its provenance and without the memory of the run. Throws Failure.
Content checked_content(const EditedFile& file, const ProvenanceEntry& entry);

}  // namespace rupture
