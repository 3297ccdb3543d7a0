// analyze checksum, verify: whether files are intact and what they should be.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <system_error>

#include "analyze/analyze.hpp"
#include "analyze/inputs.hpp"
#include "cli/option_values.hpp"
#include "cli/text.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/checkpoint/verify.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

/// A line "content-sha256 <64 hex digits>  <file name>"; earlier builds wrote it without the first
/// word, and such lines are read for ever.
struct ManifestLine {
  std::string checksum;
  fs::path file;  ///< names in a manifest are relative to its own folder
};

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

struct Inspection {
  Verdict verdict = Verdict::intact;
  std::string text;  ///< "<checksum>  <file>" of an intact file, a sentence otherwise

  /// Whether something that was to be verified is not as it should be.
  bool bad() const { return verdict != Verdict::intact && verdict != Verdict::skipped; }
};

/// Files by their canonical paths.
using Places = std::set<fs::path>;

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

/// Throws Failure if the manifest cannot be read, names no file or is none.
std::vector<ManifestLine> read_manifest(const fs::path& path) {
  std::ifstream file(path);
  if (!file || fs::is_directory(path)) {
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

/// As shown to the user, e.g. "intact".
std::string_view verdict_name(Verdict verdict) {
  constexpr std::array<std::string_view, 10> names = {
      "intact",     "differs", "unlisted", "changed",    "damaged",
      "unfinished", "missing", "empty",    "unreadable", "skipped"};
  return names.at(static_cast<std::size_t>(verdict));
}

/// Verifies a file; an empty `expected` stands for any content checksum. That of a file of an
/// earlier schema may be the one that is stored in it.
Inspection inspect_file(const fs::path& file, const std::string& expected = {}) try {
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

/// Where the files of a manifest are.
Places places_of(const std::vector<ManifestLine>& manifest) {
  Places places;
  for (const ManifestLine& line : manifest) places.insert(place(line.file));
  return places;
}

/// Whether the file, by whatever path, is at one of these places.
bool contains(const Places& places, const fs::path& file) {
  return places.contains(place(file));
}

/// Verifies all *.h5 in a folder and in those below it, sorted by name; links to folders are not
/// followed. Where some are `listed` in a manifest these are left out, and all others are unlisted.
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

/// Prints findings as they come and counts them.
class Account {
 public:
  void add(const Inspection& finding) {
    say("{}  {}\n", verdict_name(finding.verdict), in_one_line(finding.text));
    std::fflush(stdout);
    ++counts_[finding.verdict];
    if (finding.bad()) bad_.push_back(finding.text);
  }
  void add(const std::vector<Inspection>& findings) {
    for (const Inspection& finding : findings) add(finding);
  }

  /// "3 intact, 1 damaged".
  std::string summary() const {
    std::string text;
    for (const auto& [verdict, count] : counts_) {
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, verdict_name(verdict));
    }
    return text;
  }

  /// Throws Failure, with the sentence of the finding if it is the only one, if any was bad.
  void demand_all_good() const {
    if (bad_.size() == 1) throw Failure(bad_.front());
    if (bad_.empty()) return;
    throw Failure("not all files are intact: " + summary());
  }

 private:
  std::map<Verdict, int> counts_;
  std::vector<std::string> bad_;
};

std::vector<ManifestLine> manifest_of(const po::variables_map& values) {
  if (values.count("manifest") == 0) return {};
  return read_manifest(values["manifest"].as<std::string>());
}

int verify(const Parsed& parsed) {
  const auto files = files_of(parsed);
  const auto manifest = manifest_of(parsed.values);
  if (files.empty() && manifest.empty()) {
    throw UsageError("nothing to verify: name a checkpoint, record or folder, or give --manifest");
  }
  const Places listed = places_of(manifest);
  Account account;
  for (const auto& file : files) {
    if (std::error_code ignored; fs::is_directory(file, ignored)) {
      account.add(inspect_folder(file, listed));
    } else if (!contains(listed, file)) {
      account.add(inspect_file(file));
    }
  }
  for (const auto& line : manifest) account.add(inspect_file(line.file, line.checksum));
  say("{}\n", account.summary());
  account.demand_all_good();
  return kDone;
}

}  // namespace

constinit const Command checksum_command = {
    "analyze checksum FILE",
    "file",
    "content checksum of a file",
    "Verifies the file and prints its content checksum, 64 hex digits.",
    {[](po::options_description& options) {
      options.add_options()("as-schema-2",
                            "print the checksum that the same content has in schema 2, to compare "
                            "it with one noted before schema 3");
    }},
    [](const Parsed& parsed) {
      const ContentFile file = verify_file(file_of(parsed));
      const bool as_schema_2 = parsed.values.count("as-schema-2") > 0;
      say("{}\n", as_schema_2 ? content_checksum(file.content, 2) : file.checksum);
      return int{kDone};
    }};

constinit const Command verify_command = {
    "analyze verify FILE|FOLDER...",
    "file",
    "check that files and folders are intact, also against a manifest",
    R"(Checks that files are intact. In a folder it checks all *.h5 files, also in folders below; it
does not follow links to folders, and only names unfinished records (*.h5.part). With a
manifest, files must also have the content checksums listed there, and all *.h5 files in the
given folders must be listed. A .sum file is a manifest; so are the lines printed here for
intact files, without their first word.
All files are checked, even if some are damaged. Exit code 0: all files are intact, 1: a file
is changed, damaged, missing, unfinished, different from the manifest or not listed, or a
folder is unreadable or contains no *.h5 files.)",
    {[](po::options_description& options) {
      options.add_options()("manifest", input_file("manifest"),
                            "file with lines 'content-sha256 <64 hex digits>  <file>', with names "
                            "relative to its own folder; older manifests lack the first word");
    }},
    verify};

}  // namespace rupture::tools
