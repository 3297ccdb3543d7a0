#include "analyze/inspection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <system_error>

#include "cli/text.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/checkpoint/verify.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

Verdict verdict_of_unverified(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return Verdict::missing;
  return file.extension() == ".part" ? Verdict::unfinished : Verdict::damaged;
}

fs::path place(const fs::path& file) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(file), ignored);
}

/// The names in a folder, sorted. Throws std::system_error.
std::vector<fs::path> entries(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder)) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::symlink_status(path, ignored).type() == fs::file_type::directory;
}

bool is_part(const fs::path& path) {
  return path.extension() == ".part" && path.stem().extension() == ".h5";
}

struct Search {
  std::vector<fs::path> files;  ///< *.h5
  std::vector<Inspection> others;
};

void search(const fs::path& folder, Search& found) try {
  for (const fs::path& entry : entries(folder)) {
    if (is_folder(entry)) {
      search(entry, found);
    } else if (entry.extension() == ".h5") {
      found.files.push_back(entry);
    } else if (is_part(entry)) {
      found.others.push_back(
          {Verdict::skipped, fmt::format("{} is an unfinished record", entry.string())});
    }
  }
} catch (const std::system_error& error) {
  found.others.push_back(
      {Verdict::unreadable, fmt::format("{} cannot be listed: {}; check its permissions",
                                        folder.string(), error.code().message())});
}

Inspection unlisted(Inspection finding, const fs::path& file) {
  if (finding.verdict != Verdict::intact) return finding;
  return {Verdict::unlisted,
          fmt::format("{} is intact, but the manifest does not list it", file.string())};
}

}  // namespace

std::vector<ManifestLine> read_manifest(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path)) {
    throw Failure(fmt::format("cannot read the manifest {}; give the path of a readable file",
                              path.string()));
  }
  std::vector<ManifestLine> lines;
  std::string text;
  while (std::getline(file, text)) {
    if (text.ends_with('\r')) text.pop_back();
    std::istringstream words(text);
    ManifestLine line;
    std::string name;
    if (!(words >> line.checksum)) continue;
    if (line.checksum == kChecksumLabel) words >> line.checksum;
    if (line.checksum.size() != 64 || !std::getline(words >> std::ws, name)) {
      throw Failure(fmt::format(
          "{} is not a manifest: expected lines '{} <64 hex digits>  <file>' (got '{}')",
          path.string(), kChecksumLabel, in_one_line(text)));
    }
    line.file = path.parent_path() / name;
    lines.push_back(std::move(line));
  }
  if (lines.empty()) throw Failure(fmt::format("the manifest {} names no files", path.string()));
  return lines;
}

std::string_view verdict_name(Verdict verdict) {
  constexpr std::array<std::string_view, 10> names = {
      "intact",     "differs", "unlisted", "changed",    "damaged",
      "unfinished", "missing", "empty",    "unreadable", "skipped"};
  return names.at(static_cast<std::size_t>(verdict));
}

Inspection inspect_file(const fs::path& file, const std::string& expected) try {
  const ContentFile found = verify_file(file, Opening::in_child_first);
  const std::string& checksum =
      expected == found.stored_checksum ? found.stored_checksum : found.checksum;
  if (expected.empty() || checksum == expected) {
    return {Verdict::intact, fmt::format("{}  {}", labelled(checksum), file.string())};
  }
  return {Verdict::differs,
          fmt::format("{} is intact but has content checksum {}; the manifest lists {}",
                      file.string(), checksum, expected)};
} catch (const Changed& changed) {
  return {Verdict::changed, changed.what()};
} catch (const Failure& failure) {
  return {verdict_of_unverified(file), failure.what()};
}

Places places_of(const std::vector<ManifestLine>& manifest) {
  Places places;
  for (const ManifestLine& line : manifest) places.insert(place(line.file));
  return places;
}

bool contains(const Places& places, const fs::path& file) {
  return places.contains(place(file));
}

std::vector<Inspection> inspect_folder(const fs::path& folder, const Places& listed) {
  Search found;
  search(folder, found);
  std::vector<Inspection> findings;
  for (const fs::path& file : found.files) {
    if (listed.empty()) {
      findings.push_back(inspect_file(file));
    } else if (!contains(listed, file)) {
      findings.push_back(unlisted(inspect_file(file), file));
    }
  }
  if (found.files.empty()) {
    findings.push_back({Verdict::empty, fmt::format("{} contains no *.h5 files", folder.string())});
  }
  findings.insert(findings.end(), found.others.begin(), found.others.end());
  return findings;
}

}  // namespace rupture::tools
