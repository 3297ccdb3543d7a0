// Manifests (.sum files are some), and the findings of verifying a file or folder.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
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

enum class Verdict {
  intact,      ///< with the checksum of the manifest, if that lists it
  differs,     ///< intact, but with another checksum than that of the manifest
  unlisted,    ///< intact, but the manifest does not list it
  changed,     ///< not as it was sealed, but readable: by another program, or damaged
  damaged,     ///< or no file of ours, or not readable
  unfinished,  ///< a record in the making, which nothing protects
  missing,     ///< no such file
  empty,       ///< a folder without any *.h5
  unreadable,  ///< a folder
  skipped      ///< an unfinished record in a folder: not asked for
};

/// As shown to the user, e.g. "intact".
std::string_view verdict_name(Verdict verdict);

struct Inspection {
  Verdict verdict = Verdict::intact;
  std::string text;  ///< "<checksum>  <file>" of an intact file, a sentence otherwise

  /// Whether something that was to be verified is not as it should be.
  bool bad() const { return verdict != Verdict::intact && verdict != Verdict::skipped; }
};

/// Verifies a file; an empty `expected` stands for any content checksum. That of a file of an
/// earlier schema may be the one that is stored in it.
Inspection inspect_file(const std::filesystem::path& file, const std::string& expected = {});

/// Files by their canonical paths.
using Places = std::set<std::filesystem::path>;

/// Where the files of a manifest are.
Places places_of(const std::vector<ManifestLine>& manifest);

/// Whether the file, by whatever path, is at one of these places.
bool contains(const Places& places, const std::filesystem::path& file);

/// Verifies all *.h5 in a folder and in those below it, sorted by name; links to folders are not
/// followed. Where some are `listed` in a manifest these are left out, and all others are unlisted.
std::vector<Inspection> inspect_folder(const std::filesystem::path& folder, const Places& listed);

}  // namespace rupture::tools
