// analyze checksum, verify: whether files are intact and have the checksums of a list.
#include <algorithm>
#include <fstream>
#include <optional>
#include <system_error>

#include "analyze/analyze.hpp"
#include "cli/text.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/checkpoint/verify.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

/// A line "<64 hex digits>  <name>" of a list, as sha256sum writes it, or as versions before 0.6
/// did, with the word content-sha256 in front.
struct ListedFile {
  std::string checksum;
  std::string name;
};

struct Verdict {
  int place;  ///< in the summary
  std::string_view name;
  auto operator<=>(const Verdict&) const = default;
};
constexpr Verdict kIntact = {0, "intact"};    // with the checksum that a list has for it
constexpr Verdict kDiffers = {1, "differs"};  // intact, but with another checksum than that
constexpr Verdict kChanged = {3, "changed"};  // not as sealed, but readable: edited, or damaged
constexpr Verdict kDamaged = {4, "damaged"};  // or no file of ours
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

std::optional<ListedFile> listed_in(std::string_view line) {
  const std::string label = labelled("");
  if (line.starts_with(label)) line.remove_prefix(label.size());
  constexpr std::size_t digits = 64;
  const bool is_of_list = line.size() > digits + 2 && line.substr(digits, 2) == "  " &&
                          line.substr(0, digits).find_first_not_of("0123456789abcdef") == line.npos;
  if (!is_of_list) return std::nullopt;
  return ListedFile{std::string(line.substr(0, digits)), std::string(line.substr(digits + 2))};
}

/// The lines of a list of checksums; none if the file does not begin with one. Throws Failure if
/// another line is none.
std::vector<ListedFile> read_list(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return {};
  std::ifstream file(path);
  std::string text(100, '\0');
  file.read(text.data(), 100);  // what is no list may have a very long line
  if (!listed_in(text)) return {};
  file.clear();
  file.seekg(0);
  std::vector<ListedFile> lines;
  while (std::getline(file, text)) {
    if (text.ends_with('\r')) text.pop_back();
    if (text.empty()) continue;
    auto line = listed_in(text);
    if (!line) {
      throw Failure(
          "{} is not a list of checksums: expected lines '<64 hex digits>  <file>' (got '{}')",
          path.string(), in_one_line(text));
    }
    lines.push_back(*std::move(line));
  }
  return lines;
}

/// Verifies a file; an empty `expected` stands for any content checksum.
Inspection inspect_file(const fs::path& file, const std::string& expected = {}) try {
  const std::string checksum = verify_file(file, Opening::in_child_first).checksum;
  if (expected.empty() || checksum == expected) {
    return {kIntact, fmt::format("{}  {}", labelled(checksum), file.string())};
  }
  return {kDiffers, fmt::format("{} is intact but has content checksum {}; the list has {}",
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

/// Verifies all *.h5 in a folder and in those below it, in the order of their names; links to
/// folders are not followed. Returns how many there are, an unreadable folder being one.
int inspect_folder(const fs::path& folder, Account& account) {
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
      found += inspect_folder(entry, account);
    } else if (entry.extension() == ".h5") {
      ++found;
      account.add(inspect_file(entry));
    } else if (entry.extension() == ".part" && entry.stem().extension() == ".h5") {
      account.add({kSkipped, fmt::format("{} is an unfinished record", entry.string())});
    }
  }
  return found;
}

/// Verifies a file, all in a folder, or all of a list.
void inspect(const std::string& name, Account& account) {
  if (std::error_code ignored; fs::is_directory(name, ignored)) {
    if (inspect_folder(name, account) > 0) return;
    return account.add({kEmpty, fmt::format("{} contains no *.h5 files", name)});
  }
  const auto listed = read_list(name);
  if (listed.empty()) account.add(inspect_file(name));
  for (const ListedFile& line : listed) account.add(inspect_file(line.name, line.checksum));
}

int verify(const Parsed& parsed) {
  const auto names = files_of(parsed);
  if (names.empty()) {
    throw UsageError("nothing to verify: name a checkpoint, record, folder or list of checksums");
  }
  Account account;
  for (const auto& name : names) inspect(name, account);
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
    "Verifies the file and prints its content checksum, 64 hex digits. Of several files, each\n"
    "line has the name, too, as in the lists that rupture analyze verify reads.",
    {},
    print_checksums};

constinit const Command verify_command = {
    "analyze verify FILE|FOLDER...",
    "file",
    "check that files and folders are intact, also against a list",
    R"(Checks that files are intact. In a folder it checks all *.h5 files, also in folders below; it
does not follow links to folders, and only names unfinished records (*.h5.part). If a FILE
is a list of checksums, as rupture analyze checksum A.h5 B.h5 > LIST writes it, it checks the
files in the list, which must also have these content checksums; names are relative to the
current folder.
All files are checked, even if some are damaged. Exit code 0: all files are intact, 1: a file
is changed, damaged, missing, unfinished or different from the list, or a folder contains no
*.h5 files, or one of them is unreadable.)",
    {},
    verify};

}  // namespace rupture::tools
