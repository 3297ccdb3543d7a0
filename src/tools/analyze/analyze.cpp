// analyze: measure, compare and check what the other tools wrote.
#include "analyze/analyze.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <string_view>

#include "cli/report.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/user_text.hpp"

namespace {

using namespace rupture;
using namespace rupture::tools;

int analyze_help(int argc, const char* const* argv);

const std::vector<Command> kCommands = {
    {"help", "this list, or what analyze COMMAND --help says", analyze_help},
    {"events", "rupture events in a record", analyze_events, events_quantities},
    {"front", "rupture line, speed and type of the front in a record", analyze_front,
     front_quantities},
    {"classify", "the front's type alone: none, arrested, slow or fast", analyze_classify,
     classify_quantities},
    {"slip", "fast and slow slip of one block in a record", analyze_slip, slip_quantities},
    {"slow-slip", "slip speed of the blocks behind the slow front in a record", analyze_slow_slip,
     slow_slip_quantities},
    {"loading", "driving force against time in a record", analyze_loading, loading_quantities},
    {"stress", "normal and friction forces along the interface of a checkpoint", analyze_stress,
     stress_quantities},
    {"phi", "distribution of junction forces in a checkpoint", analyze_phi, phi_quantities},
    {"strength", "effective static friction of a shape of phi or of a checkpoint's blocks",
     analyze_strength, strength_quantities},
    {"estimate", "slow slip to expect from a checkpoint's parameters", analyze_estimate,
     estimate_quantities},
    {"steady-state", "friction of a block that slides at constant speed", analyze_steady_state,
     steady_state_quantities},
    {"quantities", "names and units of all parameters and of what these commands measure",
     analyze_quantities},
    {"checksum", "content checksum of a file", analyze_checksum},
    {"verify", "check that files and folders are intact, also against a manifest", analyze_verify},
    {"diff", "where and by how much two files differ", analyze_diff},
    {"show", "parameters, time and provenance of a file", analyze_show},
    {"lineage", "the steps that led to a file, also as a script", analyze_lineage},
};

const ToolText kText = {
    "analyze",
    "analyze COMMAND [FILE...] [options]",
    "Measures, compares and checks checkpoints and records; never changes them.",
    {},
    "measure, compare and check checkpoints and records"};

std::string help() {
  std::string text = fmt::format(
      "Usage: rupture {}\n\n{}\n\nCommands (rupture help analyze COMMAND tells more):\n",
      kText.synopsis, kText.purpose);
  for (const auto& command : kCommands) {
    text += fmt::format("  {:<12} {}\n", command.name, command.purpose);
  }
  return text;
}

/// A command's own description, with the line of help() as its summary.
Json description_of(const Command& command) {
  const std::array<const char*, 2> asked = {command.name.c_str(), "--describe"};
  try {
    command.run(asked.size(), asked.data());
  } catch (const HelpRequested& answer) {
    Json json = Json::parse(answer.text);
    json["summary"] = command.purpose;
    return json;
  }
  throw std::logic_error(command.name + " does not describe itself");
}

std::string describe() {
  Json json = {{"name", kText.name},
               {"summary", kText.summary},
               {"synopsis", kText.synopsis},
               {"purpose", kText.purpose},
               {"commands", Json::array()}};
  for (const auto& command : kCommands) {
    if (command.run != analyze_help) json["commands"].push_back(description_of(command));
  }
  return json_text(json) + "\n";
}

std::vector<std::string_view> names_of_commands() {
  std::vector<std::string_view> names;
  names.reserve(kCommands.size());
  for (const auto& command : kCommands) names.emplace_back(command.name);
  return names;
}

std::string no_command_text() {
  return fmt::format("no command was given: name one of {}; analyze help says what they do",
                     fmt::join(names_of_commands(), ", "));
}

const Command& find(std::string_view name) {
  for (const auto& command : kCommands) {
    if (command.name == name) return command;
  }
  throw UsageError(
      fmt::format("unknown command '{}': did you mean '{}'? See rupture analyze --help", name,
                  nearest(name, names_of_commands())));
}

bool asks_for_help(std::string_view word) {
  return word == "help" || word == "--help" || word == "-h";
}

int analyze_help(int argc, const char* const* argv) {
  if (argc > 2)
    throw UsageError(fmt::format("'{}' is one word too many: name one command", argv[2]));
  if (argc < 2 || asks_for_help(argv[1])) throw HelpRequested{help()};
  const std::array<const char*, 2> asked = {argv[1], "--help"};
  return find(argv[1]).run(asked.size(), asked.data());
}

int run(int argc, char** argv) {
  const std::string_view first = argc > 1 ? argv[1] : "";
  if (first.empty()) throw UsageError(no_command_text());
  if (first == "--help" || first == "-h") throw HelpRequested{help()};
  if (first == "--describe") throw HelpRequested{describe()};
  if (first == "--version") throw HelpRequested{version_text("analyze")};
  return find(first).run(argc - 1, argv + 1);
}

}  // namespace

const std::vector<Command>& rupture::tools::commands() {
  return kCommands;
}

int main(int argc, char** argv) {
  return run_tool("analyze", [&] { return run(argc, argv); });
}
