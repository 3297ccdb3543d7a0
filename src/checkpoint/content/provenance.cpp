#include "rupture/checkpoint/provenance.hpp"

#include <algorithm>
#include <cwchar>
#include <locale>
#include <set>

#include "checkpoint/content/layout.hpp"
#include "rupture/version.hpp"

namespace rupture {
namespace {

constexpr std::array<std::pair<std::string_view, std::string ProvenanceEntry::*>, 7> kMembers = {{
    {"tool", &ProvenanceEntry::tool},
    {"version", &ProvenanceEntry::version},
    {"commit", &ProvenanceEntry::commit},
    {"command_line", &ProvenanceEntry::command_line},
    {"compiler", &ProvenanceEntry::compiler},
    {"parent_checksum", &ProvenanceEntry::parent_checksum},
    {"rebuild", &ProvenanceEntry::rebuild},
}};
constexpr std::string_view kProvenanceGroup = "/provenance/";

std::string compiler_name() {
#if defined(__clang__)
  return fmt::format("clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
  return fmt::format("gcc {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

std::string shell_quoted(const std::string& argument) {
  constexpr std::string_view harmless =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";
  if (!argument.empty() && argument.find_first_not_of(harmless) == std::string::npos) {
    return argument;
  }
  std::string quoted = "'";
  for (const char c : argument) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

// Names of files may be any bytes; in a file, those that are no UTF-8 become U+FFFD.
std::string in_utf8(std::string_view text) {
  using Utf8 = std::codecvt<char32_t, char8_t, std::mbstate_t>;
  const auto& utf8 = std::use_facet<Utf8>(std::locale::classic());
  std::string valid;
  while (!text.empty()) {
    std::mbstate_t start{};
    const auto* from = reinterpret_cast<const char8_t*>(text.data());
    const auto length = static_cast<std::size_t>(utf8.length(start, from, from + text.size(), 1));
    const bool is_surrogate = length == 3 && text[0] == '\xED' && text[1] >= '\xA0';
    valid += length == 0 || is_surrogate ? "\uFFFD" : text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return valid;
}

std::string entry_path(std::size_t index, std::string_view member) {
  return fmt::format("{}{:04}/{}", kProvenanceGroup, index, member);
}

// Number of groups, whatever they are called.
std::size_t count_entries(const Content& content) {
  std::set<std::string> names;
  for (const auto& [path, dataset] : content) {
    if (path.starts_with(kProvenanceGroup))
      names.insert(path.substr(0, path.find('/', kProvenanceGroup.size())));
  }
  return names.size();
}

}  // namespace

ProvenanceEntry make_provenance(const std::string& tool, const std::vector<std::string>& arguments,
                                const std::string& parent_checksum, const std::string& rebuild) {
  const std::string command_line = in_utf8(shell_line(arguments));
  return {tool, version, commit, command_line, compiler_name(), parent_checksum, rebuild};
}

std::string shell_line(const std::vector<std::string>& arguments) {
  std::string line;
  for (const std::string& argument : arguments) {
    if (!line.empty()) line += ' ';
    line += shell_quoted(argument);
  }
  return line;
}

Content provenance_content(const std::vector<ProvenanceEntry>& chain) {
  Content content;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    for (const auto& [name, member] : kMembers) {
      content[entry_path(i, name)] = make_text(chain[i].*member);
    }
  }
  return content;
}

std::vector<ProvenanceEntry> read_provenance(const Content& content) {
  // Reading that many entries in sequence fails at the first that is incomplete or misplaced.
  std::vector<ProvenanceEntry> chain(count_entries(content));
  for (std::size_t i = 0; i < chain.size(); ++i) {
    for (const auto& [name, member] : kMembers) {
      chain[i].*member = read_text(content, entry_path(i, name));
    }
  }
  refuse_others(content, kProvenanceGroup, provenance_content(chain),
                "is not part of a provenance: use a newer rupture");
  return chain;
}

DatasetInfos provenance_datasets() {
  DatasetInfos all;
  for (const auto& [name, member] : kMembers) {
    all.push_back({fmt::format("{}*/{}", kProvenanceGroup, name), "text", "", "1"});
  }
  return all;
}

}  // namespace rupture
