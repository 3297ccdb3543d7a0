// Runs a program of the project as a user would, and keeps what it said.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rupture::testing {

struct RunOptions {
  std::filesystem::path folder = {};                    ///< working folder
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

}  // namespace rupture::testing
