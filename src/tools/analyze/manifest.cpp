#include "analyze/manifest.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "cli/text.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {

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
      throw Failure(fmt::format("{} is no manifest: '{}' is not '{} <64 hex digits>  <file>'",
                                path.string(), in_one_line(text), kChecksumLabel));
    }
    line.file = path.parent_path() / name;
    lines.push_back(std::move(line));
  }
  if (lines.empty()) throw Failure(fmt::format("the manifest {} names no file", path.string()));
  return lines;
}

}  // namespace rupture::tools
