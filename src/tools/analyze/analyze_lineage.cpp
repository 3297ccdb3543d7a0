// analyze lineage: the steps that led to a file, and a script that takes them anew.
#include <algorithm>

#include "analyze/analyze.hpp"
#include "run/output.hpp"
#include "run/rebuild.hpp"
#include "rupture/checkpoint/verify.hpp"

namespace rupture::tools {
namespace {

constexpr const char* kScriptHead = R"sh(#!/bin/sh
# Makes a file with the content checksum
# {}
# rupture must be in the PATH. Run it in an empty folder.
set -e

check() {{
  if [ "$(rupture analyze checksum "$1")" = "$2" ]; then return; fi
  echo "$1 has another content checksum than $2: compare the versions of rupture" >&2
  exit 1
}}
)sh";

struct Lineage {
  std::string name;  ///< of the file, for messages
  FileKind kind = FileKind::checkpoint;
  std::string checksum;                ///< of its content; empty for an unfinished record
  std::vector<ProvenanceEntry> chain;  ///< oldest first

  /// Content checksum of the file that step `i` wrote.
  const std::string& checksum_after(std::size_t i) const {
    return i + 1 < chain.size() ? chain[i + 1].parent_checksum : checksum;
  }
};

/// A file with which the commands begin instead of with nothing.
struct StartFile {
  std::string path;
  std::string checksum;
};

constexpr std::array kMakers = {&load_command, &restart_command, &prepare_command,
                                &modify_phi_command};

/// Whether the text is a command as the programs write it, so that running it does no more than
/// make a file of the name that the script gives it.
bool is_our_command(const std::string& text) {
  const auto command = read_rebuild(text);
  if (!command) return false;
  const auto maker = std::ranges::find(kMakers, command->tool, &Command::name);
  if (maker == kMakers.end()) return false;
  po::options_description known;
  for (const AddOptions add : (*maker)->own) {
    if (add != nullptr) add(known);
  }
  return std::ranges::all_of(command->options, [&](const RebuildCommand::Option& option) {
    const bool is_assignment = option.value.find('=') != std::string::npos;
    if (option.name == "set") {
      return is_assignment && (*maker)->uses_parameters == UsesParameters::yes;
    }
    const auto* const declared = known.find_nothrow(option.name, false);
    return declared != nullptr && is_in_rebuild(*declared) && !is_assignment &&
           option.value.empty() == (declared->semantic()->max_tokens() == 0);
  });
}

std::string build_text(const ProvenanceEntry& entry) {
  return in_one_line(fmt::format("rupture {}, commit {}", entry.version, entry.commit));
}

/// The step that started from this file; the last of them, for the shortest way.
std::size_t step_from(const Lineage& lineage, const StartFile& start) {
  for (std::size_t i = lineage.chain.size(); i-- > 0;) {
    if (lineage.chain[i].parent_checksum == start.checksum) return i;
  }
  throw Failure(
      "none of the steps that led to {} started from {} (content checksum {}); see rupture analyze "
      "lineage {}",
      lineage.name, start.path, start.checksum, lineage.name);
}

[[noreturn]] void fail_at_unknown(const Lineage& lineage, std::size_t step) {
  const ProvenanceEntry& entry = lineage.chain[step];
  const std::string text = fmt::format(
      "{}: step {} ({}) has no command, because {}", lineage.name, step, in_one_line(entry.tool),
      entry.rebuild.empty() ? "rupture 0.1 did not store it" : "another program edited the file");
  if (step + 1 == lineage.chain.size()) {
    throw Failure("{}; rupture analyze show {} prints the command that was typed", text,
                  lineage.name);
  }
  throw Failure("{}: give the file it wrote, with content checksum {}, as --from FILE", text,
                lineage.checksum_after(step));
}

/// Throws unless all steps from `first` on are known.
void check_steps(const Lineage& lineage, std::size_t first) {
  for (std::size_t i = lineage.chain.size(); i-- > first;) {
    const std::string& command = lineage.chain[i].rebuild;
    if (command.empty() || command == kEditedOutside) fail_at_unknown(lineage, i);
    if (is_our_command(command)) continue;
    throw Failure("{}: step {} is not a command that rupture writes and will not be run: {}",
                  lineage.name, i, in_one_line(command));
  }
}

void check_beginning(const Lineage& lineage) {
  if (lineage.chain.empty()) {
    throw Failure("{} does not contain the steps that led to it", lineage.name);
  }
  const std::string& parent = lineage.chain.front().parent_checksum;
  if (parent.empty()) return;
  throw Failure(
      "{}: its first step started from another file: give that file, with content "
      "checksum {}, as --from FILE",
      lineage.name, parent);
}

/// One line per step: checksum of the file that it wrote, version, commit, command.
std::string lineage_text(const Lineage& lineage) {
  std::string text;
  for (std::size_t i = 0; i < lineage.chain.size(); ++i) {
    const ProvenanceEntry& entry = lineage.chain[i];
    const std::string command = entry.rebuild.empty() ? "(as typed) " + entry.command_line
                                : entry.rebuild == kEditedOutside
                                    ? "(edited outside) " + entry.command_line
                                    : entry.rebuild;
    const std::string checksum = in_one_line(lineage.checksum_after(i).substr(0, 12));
    text += fmt::format("{} {}  {}: {}\n", i, checksum.empty() ? "(unfinished)" : checksum,
                        build_text(entry), in_one_line(command));
  }
  return text;
}

/// A shell script that makes a file of the same content, called `output`, and checks it and every
/// file on the way. Throws Failure, saying which file to start from, if the first steps are not
/// known; or if no step started from `start`, or a step is not a command of ours.
std::string rebuild_script(const Lineage& lineage, const std::string& output,
                           const std::optional<StartFile>& start) {
  if (lineage.kind == FileKind::open_record) {
    throw Failure("{} is an unfinished record: complete it with rupture finish", lineage.name);
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

}  // namespace

constinit const Command lineage_command = {
    "analyze lineage FILE",
    "file",
    "the steps that led to a file, also as a script",
    "Prints the steps that led to FILE, one line each: the content checksum of the file that was\n"
    "written, the build, and the command that makes it from the file before. With --commands,\n"
    "prints a script of these commands, which also checks each file that it makes.",
    {[](po::options_description& options) {
      auto add = options.add_options();
      add("commands", "print a shell script that makes a file with the same content");
      add("output,o", text("FILE")->default_value("rebuilt.h5"),
          "name of the file that the script makes");
      add("from", input_file("checkpoint or record"), "start the script from this ancestor");
    }},
    [](const Parsed& parsed) {
      const po::variables_map& values = parsed.values;
      const bool commands = values.count("commands") > 0;
      if (!commands && (values.count("from") > 0 || !values["output"].defaulted())) {
        throw UsageError("--from and --output need --commands: add it");
      }
      const auto path = single_input(parsed.values, "file", "a file");
      const ContentFile file = read_file(path);
      const Lineage lineage = {path, file.kind, file.checksum, read_provenance(file.content)};
      if (commands) {
        const auto output = file_to_write(values, "output");
        std::optional<StartFile> start;
        if (values.count("from") > 0) {
          const auto from = values["from"].as<std::string>();
          start = {from, verify_file(from).checksum};
        }
        say("{}", rebuild_script(lineage, output.string(), start));
      } else {
        say("{}{}", lineage_text(lineage), alarm_text(file.content));
      }
      return int{kDone};
    }};

}  // namespace rupture::tools
