#include "analyze/lineage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "cli/text.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

constexpr const char* kScriptHead = R"sh(#!/bin/sh
# Makes a file with the content checksum
# {}
# rupture must be in the PATH. Run it in an empty folder.
set -e

check() {{
  if [ "$(rupture analyze checksum "$1")" = "$2" ]; then return; fi
  if [ "$(rupture analyze checksum --as-schema-2 "$1")" = "$2" ]; then return; fi
  echo "$1 has another content checksum than $2: compare the versions of rupture" >&2
  exit 1
}}
)sh";

std::string short_checksum(const std::string& checksum) {
  constexpr std::size_t digits = 12;
  return checksum.empty() ? std::string("(unfinished)") : checksum.substr(0, digits);
}

/// Whether running the text can do no more than run one of rupture's tools: our commands hold
/// names, numbers and words, nothing that a shell would interpret.
bool is_our_command(const std::string& text) {
  constexpr std::array<std::string_view, 4> tools = {"load", "prepare", "restart", "modify-phi"};
  constexpr std::string_view harmless =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_+=.,- ";
  return std::find(tools.begin(), tools.end(), text.substr(0, text.find(' '))) != tools.end() &&
         text.find_first_not_of(harmless) == std::string::npos;
}

std::string build_text(const ProvenanceEntry& entry) {
  return in_one_line(fmt::format("rupture {}, commit {}", entry.version, entry.commit));
}

/// The step that started from this file; the last of them, for the shortest way.
std::size_t step_from(const Lineage& lineage, const StartFile& start) {
  for (std::size_t i = lineage.chain.size(); i-- > 0;) {
    const std::string& parent = lineage.chain[i].parent_checksum;
    if (parent == start.checksum || parent == start.stored_checksum) return i;
  }
  throw Failure(
      fmt::format("none of the steps that led to {} started from {} (content checksum {}); see "
                  "analyze lineage {}",
                  lineage.name, start.path, start.checksum, lineage.name));
}

[[noreturn]] void fail_at_unknown(const Lineage& lineage, std::size_t step) {
  const ProvenanceEntry& entry = lineage.chain[step];
  const std::string text = fmt::format(
      "{}: step {} ({}) has no command, because {}", lineage.name, step, in_one_line(entry.tool),
      entry.rebuild.empty() ? "it was made by a version that wrote schema 1"
                            : "another program edited the file");
  if (step + 1 == lineage.chain.size()) {
    throw Failure(text + "; analyze show prints the command that was typed");
  }
  throw Failure(fmt::format("{}: give the file it wrote, with content checksum {}, as --from FILE",
                            text, lineage.checksum_after(step)));
}

/// Throws unless all steps from `first` on are known.
void check_steps(const Lineage& lineage, std::size_t first) {
  for (std::size_t i = lineage.chain.size(); i-- > first;) {
    const std::string& command = lineage.chain[i].rebuild;
    if (command.empty() || command == kEditedOutside) fail_at_unknown(lineage, i);
    if (is_our_command(command)) continue;
    throw Failure(fmt::format("{}: step {} is not a rupture command and will not be run: {}",
                              lineage.name, i, in_one_line(command)));
  }
}

void check_beginning(const Lineage& lineage) {
  if (lineage.chain.empty()) {
    throw Failure(fmt::format("{} does not contain the steps that led to it", lineage.name));
  }
  const std::string& parent = lineage.chain.front().parent_checksum;
  if (parent.empty()) return;
  throw Failure(
      fmt::format("{}: its first step started from another file: give that file, with content "
                  "checksum {}, as --from FILE",
                  lineage.name, parent));
}

}  // namespace

const std::string& Lineage::checksum_after(std::size_t i) const {
  return i + 1 < chain.size() ? chain[i + 1].parent_checksum : checksum;
}

std::string lineage_text(const Lineage& lineage) {
  std::string text;
  for (std::size_t i = 0; i < lineage.chain.size(); ++i) {
    const ProvenanceEntry& entry = lineage.chain[i];
    const std::string command = entry.rebuild.empty() ? "(as typed) " + entry.command_line
                                : entry.rebuild == kEditedOutside
                                    ? "(edited outside) " + entry.command_line
                                    : entry.rebuild;
    text +=
        fmt::format("{} {}  {}: {}\n", i, in_one_line(short_checksum(lineage.checksum_after(i))),
                    build_text(entry), in_one_line(command));
  }
  return text;
}

Json entry_json(const ProvenanceEntry& entry) {
  return {{"tool", entry.tool},         {"version", entry.version},
          {"commit", entry.commit},     {"command_line", entry.command_line},
          {"compiler", entry.compiler}, {"parent_checksum", entry.parent_checksum},
          {"rebuild", entry.rebuild}};
}

Json lineage_json(const Lineage& lineage) {
  Json steps = Json::array();
  for (std::size_t i = 0; i < lineage.chain.size(); ++i) {
    steps.push_back(entry_json(lineage.chain[i]));
    steps.back()["checksum"] = lineage.checksum_after(i);
  }
  return {{"kind", kind_name(lineage.kind)}, {"checksum", lineage.checksum}, {"steps", steps}};
}

std::string rebuild_script(const Lineage& lineage, const std::string& output,
                           const std::optional<StartFile>& start) {
  if (lineage.kind == FileKind::open_record) {
    throw Failure(
        fmt::format("{} is an unfinished record: complete it with rupture finish", lineage.name));
  }
  const std::size_t first = start ? step_from(lineage, *start) : 0;
  check_steps(lineage, first);
  if (!start) check_beginning(lineage);

  std::string script = fmt::format(kScriptHead, lineage.checksum);
  std::string input = start ? start->path : "";
  if (start) script += fmt::format("\ncheck {}\n", shell_line({input, start->checksum}));
  for (std::size_t i = first; i < lineage.chain.size(); ++i) {
    const ProvenanceEntry& entry = lineage.chain[i];
    const bool last = i + 1 == lineage.chain.size();
    const std::string checkpoint = fmt::format("step-{:04}.h5", i);
    std::vector<std::string> files = {"-o", last ? output : checkpoint};
    if (last && lineage.kind == FileKind::record) files = {"-o", checkpoint, "--record", output};
    if (!input.empty()) files.insert(files.begin(), input);
    input = files.back();
    script += fmt::format("\n# {}, {}: {}\n", build_text(entry), in_one_line(entry.compiler),
                          in_one_line(entry.command_line));
    script += fmt::format("rupture {} {}\n", entry.rebuild, shell_line(files));
    script +=
        fmt::format("check {}\n", shell_line({input, in_one_line(lineage.checksum_after(i))}));
  }
  return script;
}

}  // namespace rupture::tools
