// Shared by the tests of the tools: a fresh folder, a small slider, the tools themselves.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rupture::testing {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct RunOptions {
  fs::path folder = {};                                 ///< working folder
  std::map<std::string, std::string> environment = {};  ///< added to that of the test
  std::string standard_output = {};                ///< file that takes it; empty: it is captured
  std::optional<std::uint64_t> largest_file = {};  ///< [bytes], as on a full disk
  std::optional<std::uint64_t> memory = {};        ///< address space [bytes]
  std::optional<std::uint32_t> user = {};          ///< run as this user; only root can
};

struct Outcome {
  int exit_code = 0;  ///< minus the signal's number if one ended the program
  std::string out, err;
  std::uint64_t peak_memory = 0;  ///< [bytes]; at least that of the test's own process
};

inline constexpr int kCannotStart = 127;  ///< exit code if the program could not be executed

/// Runs `arguments[0]`, a file, with the other arguments, none of which a shell sees. It may use
/// two minutes of processor time.
Outcome run_program(const std::vector<std::string>& arguments, const RunOptions& options);

enum ExitCode : int { kDone = 0, kFailed = 1, kUsage = 2 };

/// All files below a folder with their bytes; folders and links end in "/" and "@".
using Files = std::map<std::string, std::string>;

/// Each test runs in a folder of its own, which starts with small.ini: a slider of 9 x 5 blocks
/// that is driven so fast that a rupture crosses it from t = 0.15 ms to 0.25 ms.
class ToolTest : public ::testing::Test {
 protected:
  ToolTest();
  ~ToolTest() override;

  /// Runs "tool argument argument ..." in the folder; words are separated by single spaces.
  Outcome run(std::string_view command, RunOptions options = {}) const;

  /// The same where an argument contains spaces or is empty.
  Outcome run_words(std::vector<std::string> words, RunOptions options = {}) const;

  /// Runs a command that must succeed without complaint; returns its standard output.
  std::string output_of(std::string_view command) const;

  /// The JSON object that a command prints.
  Json json_of(std::string_view command) const;

  /// The content checksum of a file.
  std::string checksum_of(const std::string& file) const;

  /// The same of a file whose name can be any.
  std::string checksum_in(const std::string& file) const {
    return run_words({"analyze", "checksum", file}).out;
  }

  /// The line of a .sum file or manifest for a file.
  std::string sum_line(const std::string& file) const {
    return "content-sha256 " + checksum_of(file) + "  " + file + "\n";
  }

  /// Demands that a command ends with this code and says exactly "<tool>: <sentence>", and that
  /// all files are as before.
  void expect_refusal(std::string_view command, ExitCode code, std::string_view sentence,
                      RunOptions options = {}) const;

  /// The same for a sentence of which only a part is given.
  void expect_refusal_with(std::string_view command, ExitCode code, std::string_view part,
                           RunOptions options = {}) const;

  /// Runs a script as a user would, in an empty folder, with the programs in the PATH.
  Outcome run_script(const std::string& script) const;

  /// What analyze lineage FILE --commands prints.
  std::string script_for(const std::string& file, const std::vector<std::string>& more = {}) const;

  /// Demands that these commands make the content of `file` from nothing.
  void expect_rebuilt(const std::string& file) const;

  Files files() const;
  fs::path path(const std::string& file) const { return folder_ / file; }
  std::string read(const std::string& file) const;
  void write(const std::string& file, std::string_view bytes) const;

 private:
  fs::path folder_;
};

/// Names of the files that came, went or changed.
std::string names_of_changed(const Files& before, const Files& after);

/// Demands that a tool said one line, "<tool>: ...", on standard error, with `part` in it.
void expect_one_sentence(const std::string& err, const std::string& tool, std::string_view part);

/// Whether the text is the pattern, in which "..." stands for any text within a line.
bool matches(std::string_view text, std::string_view pattern);

/// Lines of a text, without their ends.
std::vector<std::string> lines_of(const std::string& text);

/// Cells of CSV: one vector per line.
std::vector<std::vector<std::string>> csv_of(const std::string& text);

}  // namespace rupture::testing
