// The steps that led to a file, and the commands that take them anew.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/report.hpp"
#include "rupture/checkpoint/file.hpp"
#include "rupture/checkpoint/provenance.hpp"

namespace rupture::tools {

/// Where a file comes from.
struct Lineage {
  std::string name;  ///< of the file, for messages
  FileKind kind = FileKind::checkpoint;
  std::string checksum;                ///< of its content; empty for an unfinished record
  std::vector<ProvenanceEntry> chain;  ///< oldest first

  /// Content checksum of the file that step `i` wrote.
  const std::string& checksum_after(std::size_t i) const;
};

/// A file with which the commands begin instead of with nothing.
struct StartFile {
  std::string path;
  std::string checksum;
  std::string stored_checksum;  ///< the same unless the file is of an earlier schema
};

/// One line per step: checksum of the file that it wrote, version, commit, command.
std::string lineage_text(const Lineage& lineage);

/// {"kind", "checksum", "steps"}: docs/schema.md.
Json lineage_json(const Lineage& lineage);

/// A provenance entry with all its members.
Json entry_json(const ProvenanceEntry& entry);

/// A shell script that makes a file of the same content, called `output`, and checks it and every
/// file on the way. Throws Failure, saying which file to start from, if the first steps are not
/// known; or if no step started from `start`, or a step is no command of ours.
std::string rebuild_script(const Lineage& lineage, const std::string& output,
                           const std::optional<StartFile>& start);

}  // namespace rupture::tools
