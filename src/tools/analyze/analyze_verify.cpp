// analyze checksum, verify: whether files are intact and what they should be.
#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <system_error>

#include "analyze/analyze.hpp"
#include "cli/text.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/checkpoint/verify.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

/// A line "content-sha256 <64 hex digits>  <file name>"; earlier builds wrote it without the first
/// word, and such lines are read for ever.
struct ManifestLine {
  std::string checksum;
  fs::path file;  ///< names in a manifest are relative to its own folder
};

struct Verdict {
  int place;  ///< in the summary
  std::string_view name;
  auto operator<=>(const Verdict&) const = default;
};
constexpr Verdict kIntact = {0, "intact"};      // with the checksum that a manifest lists for it
constexpr Verdict kDiffers = {1, "differs"};    // intact, but with another checksum than that
constexpr Verdict kUnlisted = {2, "unlisted"};  // intact, but the manifest does not list it
constexpr Verdict kChanged = {3, "changed"};    // not as sealed, but readable: edited, or damaged
constexpr Verdict kDamaged = {4, "damaged"};    // or no file of ours
constexpr Verdict kUnfinished = {5, "unfinished"};  // a growing record, which nothing protects
constexpr Verdict kMissing = {6, "missing"};        // no such file
constexpr Verdict kEmpty = {7, "empty"};            // a folder without any *.h5
constexpr Verdict kUnreadable = {8, "unreadable"};  // here and now: a file or folder
constexpr Verdict kSkipped = {9, "skipped"};  // an unfinished record in a folder: not asked for

struct Inspection {
  Verdict verdict;
  std::string text;  ///< "<checksum>  <file>" of an intact file, a sentence otherwise
};

/// Prints findings as they come and counts them.
class Account {
 public:
  void add(const Inspection& finding) {
    say("{}  {}\n", finding.verdict.name, in_one_line(finding.text));
    std::fflush(stdout);
    ++counts_[finding.verdict];
    const bool good = finding.verdict == kIntact || finding.verdict == kSkipped;
    if (!good) bad_.push_back(finding.text);
  }

  /// "3 intact, 1 damaged".
  std::string summary() const {
    std::string text;
    for (const auto& [verdict, count] : counts_) {
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, verdict.name);
    }
    return text;
  }

  /// Throws Failure, with the sentence of the finding if it is the only one, if any was bad.
  void demand_all_good() const {
    if (bad_.empty()) return;
    throw Failure(bad_.size() == 1 ? bad_.front() : "not all files are intact: " + summary());
  }

 private:
  std::map<Verdict, int> counts_;
  std::vector<std::string> bad_;
};

/// Throws Failure if the manifest cannot be read, names no file or is none.
std::vector<ManifestLine> read_manifest(const fs::path& path) {
  std::ifstream file(path);
  if (!file || fs::is_directory(path)) {
    throw Failure("cannot read the manifest {}; give the path of a readable file", path.string());
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
      throw Failure("{} is not a manifest: expected lines '{} <64 hex digits>  <file>' (got '{}')",
                    path.string(), kChecksumLabel, in_one_line(text));
    }
    line.file = path.parent_path() / name;
    lines.push_back(std::move(line));
  }
  if (lines.empty()) throw Failure("the manifest {} lists no files", path.string());
  return lines;
}

/// Verifies a file; an empty `expected` stands for any content checksum.
Inspection inspect_file(const fs::path& file, const std::string& expected = {}) try {
  const std::string checksum = verify_file(file, Opening::in_child_first).checksum;
  if (expected.empty() || checksum == expected) {
    return {kIntact, fmt::format("{}  {}", labelled(checksum), file.string())};
  }
  return {kDiffers, fmt::format("{} is intact but has content checksum {}; the manifest lists {}",
                                file.string(), checksum, expected)};
} catch (const Changed& changed) {
  return {kChanged, changed.what()};
} catch (const Unreadable& failure) {
  return {kUnreadable, failure.what()};
} catch (const MachineFailure& failure) {
  return {kUnreadable, failure.what()};
} catch (const std::bad_alloc&) {
  return {kUnreadable, fmt::format("cannot read {}: not enough memory", file.string())};
} catch (const Failure& failure) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return {kMissing, failure.what()};
  return {file.extension() == ".part" ? kUnfinished : kDamaged, failure.what()};
}

fs::path place(const fs::path& file) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(file), ignored);
}

/// Verifies all *.h5 in a folder and in those below it, in the order of their names; links to
/// folders are not followed. Where some are `listed` in a manifest these are left out, and all
/// others are unlisted. Returns how many there are, an unreadable folder being one.
int inspect_folder(const fs::path& folder, const std::set<fs::path>& listed, Account& account) {
  std::error_code error;
  std::vector<fs::path> entries;
  for (fs::directory_iterator at(folder, error); at != end(at); at.increment(error)) {
    entries.push_back(at->path());
  }
  int found = 0;
  if (error) {
    ++found;
    account.add({kUnreadable, fmt::format("{} cannot be listed: {}; check its permissions",
                                          folder.string(), error.message())});
  }
  std::sort(entries.begin(), entries.end());
  for (const fs::path& entry : entries) {
    if (fs::symlink_status(entry, error).type() == fs::file_type::directory) {
      found += inspect_folder(entry, listed, account);
    } else if (entry.extension() == ".h5") {
      ++found;
      if (listed.contains(place(entry))) continue;
      Inspection finding = inspect_file(entry);
      if (!listed.empty() && finding.verdict == kIntact) {
        finding = {kUnlisted,
                   fmt::format("{} is intact, but the manifest does not list it", entry.string())};
      }
      account.add(finding);
    } else if (entry.extension() == ".part" && entry.stem().extension() == ".h5") {
      account.add({kSkipped, fmt::format("{} is an unfinished record", entry.string())});
    }
  }
  return found;
}

int verify(const Parsed& parsed) {
  const auto files = files_of(parsed);
  std::vector<ManifestLine> manifest;
  if (parsed.values.count("manifest") > 0) {
    manifest = read_manifest(parsed.values["manifest"].as<std::string>());
  }
  if (files.empty() && manifest.empty()) {
    throw UsageError("nothing to verify: name a checkpoint, record or folder, or give --manifest");
  }
  std::set<fs::path> listed;
  for (const ManifestLine& line : manifest) listed.insert(place(line.file));
  Account account;
  for (const auto& file : files) {
    if (std::error_code ignored; fs::is_directory(file, ignored)) {
      if (inspect_folder(file, listed, account) == 0) {
        account.add({kEmpty, fmt::format("{} contains no *.h5 files", file)});
      }
    } else if (!listed.contains(place(file))) {
      account.add(inspect_file(file));
    }
  }
  for (const auto& line : manifest) account.add(inspect_file(line.file, line.checksum));
  say("{}\n", account.summary());
  account.demand_all_good();
  return kDone;
}

/// Prints nothing if one of several files is not intact.
int print_checksums(const Parsed& parsed) {
  const auto files = files_of(parsed);
  if (files.empty()) throw UsageError("no file was given: name a file");
  std::string text;
  for (const auto& file : files) {
    const std::string name = files.size() > 1 ? "  " + in_one_line(file) : "";
    text += verify_file(file).checksum + name + "\n";
  }
  say("{}", text);
  return kDone;
}

}  // namespace

constinit const Command checksum_command = {
    "analyze checksum FILE...",
    "file",
    "content checksums of files",
    "Verifies the file and prints its content checksum, 64 hex digits. Of several files, each "
    "line\n"
    "has the name, too, as in a manifest for rupture analyze verify.",
    {},
    print_checksums};

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
folder contains no *.h5 files, or one of them is unreadable.)",
    {[](po::options_description& options) {
      options.add_options()("manifest", input_file("manifest"),
                            "file with lines 'content-sha256 <64 hex digits>  <file>', with names "
                            "relative to its own folder; older manifests lack the first word");
    }},
    verify};

}  // namespace rupture::tools
