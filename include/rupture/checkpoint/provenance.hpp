// Where a file comes from: one entry per tool that contributed, oldest first.
#pragma once

#include "rupture/checkpoint/content.hpp"

namespace rupture {

/// `rebuild` of a step that no command takes: another program changed the file.
inline constexpr const char* kEditedOutside = "edited outside";

struct ProvenanceEntry {
  std::string tool;             ///< e.g. "restart"
  std::string version;          ///< of rupture
  std::string commit;           ///< git commit of the sources
  std::string command_line;     ///< quoted so that a shell reads back the same arguments
  std::string compiler;         ///< e.g. "gcc 12.2.0"
  std::string parent_checksum;  ///< content checksum of the checkpoint read; empty if there is none
  /// The command that makes this file's content from its parent alone: quoted as command_line,
  /// without the names of files and without options that change no bit of the content. Empty if
  /// the step was made by rupture 0.1 or by a program that is not ours.
  std::string rebuild = {};

  bool operator==(const ProvenanceEntry&) const = default;
};

/// The entry for this build. `arguments` are argv, program name included; `rebuild` is that of
/// ProvenanceEntry, which only our own tools can give.
ProvenanceEntry make_provenance(const std::string& tool, const std::vector<std::string>& arguments,
                                const std::string& parent_checksum,
                                const std::string& rebuild = {});

/// The arguments as one line that a POSIX shell splits into the same arguments.
std::string shell_line(const std::vector<std::string>& arguments);

/// /provenance/0000/tool and so on.
Content provenance_content(const std::vector<ProvenanceEntry>& chain);

/// The chain in a file's content. Throws Failure if an entry is incomplete or out of sequence, or
/// has members that this build does not know.
std::vector<ProvenanceEntry> read_provenance(const Content& content);

}  // namespace rupture
