// analyze checksum, verify: whether files are intact and have the checksums of a list.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
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

enum class Verdict {
  intact,   ///< and with the checksum that a list has for it
  changed,  ///< not as sealed, but seal would seal it; or not what the list has
  damaged,
  not_ours,   ///< no checkpoint or record, or of a schema that this version does not read
  unchecked,  ///< missing, unfinished, or this machine does not let us read it
};
constexpr std::array<std::string_view, 5> kWords = {"intact", "changed", "damaged", "not ours",
                                                    "unchecked"};

std::string_view word_for(Verdict verdict) {
  return kWords.at(static_cast<std::size_t>(verdict));
}

struct Inspection {
  Verdict verdict;
  std::string text;  ///< "<checksum>  <file>" of an intact file, a sentence otherwise
};

/// Prints findings as they come and counts them.
class Account {
 public:
  void add(const Inspection& finding) {
    say("{}  {}\n", word_for(finding.verdict), in_one_line(finding.text));
    std::fflush(stdout);
    ++counts_[finding.verdict];
    if (finding.verdict != Verdict::intact) bad_.push_back(finding.text);
  }

  /// "3 intact, 1 damaged".
  std::string summary() const {
    std::string text;
    for (const auto& [verdict, count] : counts_) {
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, word_for(verdict));
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
/// another line is none, or if the list cannot be read to its end.
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
  if (file.bad()) {
    throw MachineFailure("cannot read {} to its end; copy the list again", path.string());
  }
  return lines;
}

/// Opens a file whose seal is broken all the same, as seal does, and throws Failure as seal would.
Inspection look_behind_seal(const fs::path& file) {
  checked_content(read_edited(file), {});
  return {Verdict::changed,
          fmt::format("{} was changed after rupture sealed it, but can be read: if somebody edited "
                      "or repacked it, rupture seal {} -o NEW.h5 seals it again; otherwise it is "
                      "damaged: copy it again or recreate it",
                      file.string(), file.string())};
}

/// Verifies a file; an empty `expected` stands for any content checksum.
Inspection look_at(const fs::path& file, const std::string& expected) try {
  const std::string checksum = verify_file(file).checksum;
  if (expected.empty() || checksum == expected) {
    return {Verdict::intact, fmt::format("{}  {}", labelled(checksum), file.string())};
  }
  return {Verdict::changed, fmt::format("{} is intact but has content checksum {}; the list has {}",
                                        file.string(), checksum, expected)};
} catch (const BrokenSeal&) {
  return look_behind_seal(file);
}

/// Looks at the file in a copy of this process that prints nothing, writes no core, and is ended
/// after four minutes of processor time. Returns the signal that ended it; 0 if none did.
int signal_of_child(const fs::path& file, const std::string& expected) {
  const pid_t child = ::fork();
  if (child < 0) {
    throw MachineFailure("{}: cannot start a process: {}; try again later", file.string(),
                         std::strerror(errno));
  }
  if (child == 0) {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
    constexpr rlimit none = {0, 0}, four_minutes = {240, 240};
    ::setrlimit(RLIMIT_CORE, &none);
    ::setrlimit(RLIMIT_CPU, &four_minutes);
    // A handler of ours or of a sanitizer would report what is expected here, or continue.
    for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT})
      std::signal(signal, SIG_DFL);
    try {
      look_at(file, expected);
    } catch (const std::exception&) {  // which this process meets in its turn
    }
    ::_exit(0);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw MachineFailure("{}: lost track of a child process", file.string());
  }
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

/// Looks at a file first in a child process: libhdf5 1.10.8 crashes on some that are damaged.
/// Whether it does may depend on where it has its memory, so both do exactly the same.
Inspection inspect_file(const fs::path& file, const std::string& expected = {}) try {
  if (const int signal = signal_of_child(file, expected)) {
    return {Verdict::damaged,
            fmt::format("{}: the HDF5 library crashes when it reads the file ({}), so the file is "
                        "damaged or malicious; copy it again or recreate it",
                        file.string(), ::strsignal(signal))};
  }
  return look_at(file, expected);
} catch (const NotOurs& failure) {
  return {Verdict::not_ours, failure.what()};
} catch (const MachineFailure& failure) {
  return {Verdict::unchecked, failure.what()};
} catch (const std::bad_alloc&) {
  return {Verdict::unchecked, fmt::format("cannot read {}: not enough memory", file.string())};
} catch (const Failure& failure) {
  std::error_code ignored;
  const bool is_whole = fs::exists(file, ignored) && file.extension() != ".part";
  return {is_whole ? Verdict::damaged : Verdict::unchecked, failure.what()};
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
    account.add({Verdict::unchecked, fmt::format("{} cannot be listed: {}; check its permissions",
                                                 folder.string(), error.message())});
  }
  std::sort(entries.begin(), entries.end());
  for (const fs::path& entry : entries) {
    if (fs::symlink_status(entry, error).type() == fs::file_type::directory) {
      found += inspect_folder(entry, account);
    } else if (entry.extension() == ".h5") {
      ++found;
      account.add(inspect_file(entry));
    }
  }
  return found;
}

/// Verifies a file, all in a folder, or all of a list.
void inspect(const std::string& name, Account& account) {
  if (std::error_code ignored; fs::is_directory(name, ignored)) {
    if (inspect_folder(name, account) > 0) return;
    return account.add({Verdict::unchecked, fmt::format("{} contains no *.h5 files", name)});
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
    R"(Checks that files are intact, and says of each that it is

  intact
  changed   after rupture sealed it, but rupture seal can seal it again; of a file in a list, also
            that it has another content checksum than there
  damaged
  not ours  no checkpoint or record, or one that this version does not read

or unchecked, if it is missing, cannot be read on this machine, or is an unfinished record. In a
folder it checks all *.h5 files, also in folders below; it does not follow links to folders. If a
FILE is a list of checksums, as rupture analyze checksum A.h5 B.h5 > LIST writes it, it checks the
files in the list, which must also have these content checksums; names are relative to the
current folder.
All files are checked, even if some are damaged. Exit code 0: all are intact.)",
    {},
    verify};

}  // namespace rupture::tools
