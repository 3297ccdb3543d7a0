// analyze: measure, compare and check what the other tools wrote.
#include "analyze/analyze.hpp"

#include "cli/report.hpp"
#include "run/output.hpp"
#include "rupture/model/user_text.hpp"

namespace rupture::tools {
namespace {

constexpr std::string_view kSynopsis = "analyze COMMAND [FILE...] [options]";
constexpr std::string_view kPurpose =
    "Measures, compares and checks checkpoints and records; never changes them.";

/// All commands, in the order of the help.
constexpr std::array kCommands = {&events_command,   &front_command,        &classify_command,
                                  &slip_command,     &slow_slip_command,    &loading_command,
                                  &stress_command,   &phi_command,          &strength_command,
                                  &estimate_command, &steady_state_command, &quantities_command,
                                  &checksum_command, &verify_command,       &diff_command,
                                  &show_command,     &lineage_command};

/// Its name without "analyze".
std::string_view word_for(const Command& command) {
  return command.name().substr(command.name().find(' ') + 1);
}

std::string help() {
  std::string text = fmt::format(
      "Usage: rupture {}\n\n{}\n\nCommands (rupture help analyze COMMAND describes one):\n",
      kSynopsis, kPurpose);
  for (const Command* command : kCommands) {
    text += fmt::format("  {:<12} {}\n", word_for(*command), command->summary);
  }
  return text;
}

/// The text of its --describe.
std::string description_of(const Command& command) try {
  parse(command, 2, std::array{"analyze", "--describe"}.data());
  throw std::logic_error(fmt::format("{} does not describe itself", command.name()));
} catch (const HelpRequested& said) {
  return said.text;
}

std::string describe() {
  Json json = {{"name", "analyze"},
               {"synopsis", kSynopsis},
               {"purpose", kPurpose},
               {"commands", Json::array()}};
  for (const Command* command : kCommands) {
    json["commands"].push_back(Json::parse(description_of(*command)));
  }
  return json_text(json) + "\n";
}

std::vector<std::string_view> names_of_commands() {
  std::vector<std::string_view> names;
  for (const Command* command : kCommands) names.push_back(word_for(*command));
  return names;
}

const Command& find(std::string_view name) {
  for (const Command* command : kCommands) {
    if (word_for(*command) == name) return *command;
  }
  throw UsageError(unknown_text("command", name, names_of_commands(), "rupture analyze --help"));
}

int run(int argc, char** argv) {
  const std::string_view first = argc > 1 ? argv[1] : "";
  if (first.empty()) {
    throw UsageError("no command was given: choose one of {} (rupture help analyze describes them)",
                     fmt::join(names_of_commands(), ", "));
  }
  if (first == "--help" || first == "-h") throw HelpRequested{help()};
  if (first == "--describe") throw HelpRequested{describe()};
  if (first == "--version") throw HelpRequested{version_text("analyze")};
  const Command& command = find(first);
  return command.run(parse(command, argc - 1, argv + 1));
}

// --- analyze quantities: what the commands and the other programs report

constexpr std::array kWriters = {&load_command,       &restart_command, &prepare_command,
                                 &modify_phi_command, &finish_command,  &seal_command};

/// The end of the name of a quantity with such a value.
struct Suffix {
  std::string operator()(const auto&) const { return ""; }
  template <class T>
  std::string operator()(const std::vector<T>&) const {
    return ".*";
  }
  std::string operator()(const Counts&) const { return ".*.*"; }
  std::string operator()(const List&) const { return ".*"; }
};

/// Adds name (keys joined by dots, * for an index), unit and meaning of all that JSON has of the
/// rows.
void add_named(const std::string& prefix, const Quantities& rows, Json& all) {
  for (const Quantity& row : rows) {
    if (row.key.empty()) continue;
    const std::string name = prefix + "." + row.key + std::visit(Suffix{}, row.value);
    if (const auto* const group = std::get_if<Group>(&row.value)) {
      add_named(name, group->rows, all);
    } else if (const auto* const list = std::get_if<List>(&row.value)) {
      add_named(name, list->kind, all);
    } else {
      all.push_back({{"name", name}, {"unit", row.unit}, {"help", row.help}});
    }
  }
}

Json quantities_of(std::span<const Command* const> commands) {
  Json all = Json::array();
  for (const Command* command : commands) {
    if (command->quantities == nullptr) continue;
    add_named(std::string(word_for(*command)), command->quantities(), all);
  }
  return all;
}

void print_lines(const Json& quantities) {
  for (const Json& quantity : quantities) {
    const std::string name = quantity["name"], unit = quantity["unit"], help = quantity["help"];
    say("  {:<58} {:<6} {}\n", name, unit.empty() ? "" : "[" + unit + "]", help);
  }
}

}  // namespace

constinit const Command quantities_command = {
    "analyze quantities",
    "",
    "names and units of all measured quantities",
    "Lists everything that the commands of analyze and the programs that write files report\n"
    "with --json.",
    {add_json_option},
    [](const Parsed& parsed) {
      if (parsed.values.count("json") > 0) {
        say("{}\n", json_text({{"quantities", quantities_of(kCommands)},
                               {"summaries", quantities_of(kWriters)}}));
        return int{kDone};
      }
      say("Quantities: name (command, then field of its --json; * is an index), unit, "
          "meaning\n");
      print_lines(quantities_of(kCommands));
      say("\nSummaries: name (program that writes files, then field of its --json), unit, "
          "meaning\n");
      print_lines(quantities_of(kWriters));
      return int{kDone};
    }};

Checkpoint checkpoint_of(const Parsed& parsed, const std::string& wanted) {
  return read_checkpoint(single_input(parsed.values, "checkpoint", wanted));
}

std::vector<std::string> files_of(const Parsed& parsed) {
  if (parsed.values.count("file") == 0) return {};
  auto files = parsed.values["file"].as<std::vector<std::string>>();
  refuse_empty_names(files);
  return files;
}

}  // namespace rupture::tools

int main(int argc, char** argv) {
  return rupture::tools::run_tool("analyze", [&] { return rupture::tools::run(argc, argv); });
}
