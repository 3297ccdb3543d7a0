#include "cli/text.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "rupture/model/error.hpp"

namespace rupture::tools {
std::string text_of_file(const std::string& path, std::string_view what, std::string_view form,
                         std::size_t longest) {
  std::ifstream file(path);
  std::string text(longest + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file.is_open() || file.bad() || std::filesystem::is_directory(path)) {
    const Failure failure("cannot read the {} {}; give the path of a readable {}", what, path,
                          form);
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored)) throw MachineFailure(failure.what());
    throw failure;
  }
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > longest) {
    throw Failure("the {} {} is longer than {} bytes; give the path of a shorter {}", what, path,
                  grouped(static_cast<double>(longest)), form);
  }
  if (text.find('\0') != std::string::npos) {
    throw Failure("the {} {} is UTF-16 or no text at all: save it as plain UTF-8", what, path);
  }
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

std::vector<std::string> split(std::string text, char separator) {
  std::vector<std::string> words;
  std::istringstream stream(std::move(text));
  for (std::string word; std::getline(stream, word, separator);) words.push_back(word);
  return words;
}

std::string grouped(double whole_number) {
  std::string text = fmt::format("{:.0f}", whole_number);
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3) {
    text.insert(static_cast<std::size_t>(at), 1, ',');
  }
  return text;
}

std::string rounded(double value) {
  return fmt::format("{:.{}f}", value, value < 1.0 ? 2 : value < 10.0 ? 1 : 0);
}

std::string time_text(double t) {
  using Unit = std::pair<double, const char*>;
  constexpr std::array<Unit, 6> units = {
      {{86400.0, "days"}, {3600.0, "h"}, {60.0, "min"}, {1.0, "s"}, {1e-3, "ms"}, {1e-6, "us"}}};
  const auto* unit =
      std::find_if(units.begin(), units.end() - 1, [&](const Unit& u) { return t >= u.first; });
  return rounded(t / unit->first) + " " + unit->second;
}

std::string in_one_line(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool in_two = byte == 0xc2 && i + 1 < text.size() && (text[i + 1] & 0xe0) == 0x80;
    if (byte < ' ' || byte == 0x7f || in_two) text.replace(i, in_two ? 2 : 1, "?");
  }
  return text;
}

}  // namespace rupture::tools
