#include "rupture/checkpoint/provenance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "rupture/model/error.hpp"
#include "rupture/version.hpp"

namespace rupture {
namespace {

struct Member {
  std::string_view name;
  std::string ProvenanceEntry::*value;
};

constexpr std::array<Member, 6> kMembers = {{
    {"tool", &ProvenanceEntry::tool},
    {"version", &ProvenanceEntry::version},
    {"commit", &ProvenanceEntry::commit},
    {"command_line", &ProvenanceEntry::command_line},
    {"compiler", &ProvenanceEntry::compiler},
    {"parent_checksum", &ProvenanceEntry::parent_checksum},
}};

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

std::string entry_path(std::size_t index, std::string_view member) {
  return fmt::format("/provenance/{:04}/{}", index, member);
}

}  // namespace

ProvenanceEntry make_provenance(const std::string& tool, const std::vector<std::string>& arguments,
                                const std::string& parent_checksum) {
  return {tool, version, commit, shell_line(arguments), compiler_name(), parent_checksum};
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
    for (const Member& member : kMembers) {
      content[entry_path(i, member.name)] = make_text(chain[i].*member.value);
    }
  }
  return content;
}

std::vector<ProvenanceEntry> read_provenance(const Content& content) {
  const auto datasets = std::count_if(content.begin(), content.end(), [](const auto& entry) {
    return entry.first.starts_with("/provenance/");
  });
  // Reading that many entries in sequence fails at the first that is incomplete or misplaced.
  std::vector<ProvenanceEntry> chain((static_cast<std::size_t>(datasets) + kMembers.size() - 1) /
                                     kMembers.size());
  for (std::size_t i = 0; i < chain.size(); ++i) {
    for (const Member& member : kMembers) {
      chain[i].*member.value = read_text(content, entry_path(i, member.name));
    }
  }
  return chain;
}

}  // namespace rupture
