// Whole files in tests.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace rupture::testing {

/// The bytes of a file; none if it cannot be read. Tests read megabytes, unoptimised: not one by
/// one.
inline std::string slurp(const std::filesystem::path& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

}  // namespace rupture::testing
