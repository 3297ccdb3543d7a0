// analyze: measure, compare and check what the other tools wrote.
#include "analyze/analyze.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <string_view>

#include "cli/report.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/user_text.hpp"

namespace rupture::tools {
namespace {

constexpr std::string_view kSynopsis = "analyze COMMAND [FILE...] [options]";
constexpr std::string_view kPurpose =
    "Measures, compares and checks checkpoints and records; never changes them.";
constexpr std::string_view kSummary = "measure, compare and check checkpoints and records";

/// Its name without "analyze".
std::string_view word_for(const Command& command) {
  return command.name().substr(command.name().find(' ') + 1);
}

std::string help() {
  std::string text = fmt::format(
      "Usage: rupture {}\n\n{}\n\nCommands (rupture help analyze COMMAND describes one):\n"
      "  help         show this list, or the help of a command\n",
      kSynopsis, kPurpose);
  for (const Command* command : commands()) {
    text += fmt::format("  {:<12} {}\n", word_for(*command), command->summary);
  }
  return text;
}

[[noreturn]] void answer(const Command& command, const char* question) {
  const std::array<const char*, 2> asked = {"analyze", question};
  parse(command, asked.size(), asked.data());
  throw std::logic_error(fmt::format("{} does not answer {}", command.name(), question));
}

std::string describe() {
  Json json = {{"name", "analyze"},
               {"summary", kSummary},
               {"synopsis", kSynopsis},
               {"purpose", kPurpose},
               {"commands", Json::array()}};
  for (const Command* command : commands()) {
    try {
      answer(*command, "--describe");
    } catch (const HelpRequested& said) {
      json["commands"].push_back(Json::parse(said.text));
    }
  }
  return json_text(json) + "\n";
}

std::vector<std::string_view> names_of_commands() {
  std::vector<std::string_view> names = {"help"};
  for (const Command* command : commands()) names.push_back(word_for(*command));
  return names;
}

const Command& find(std::string_view name) {
  for (const Command* command : commands()) {
    if (word_for(*command) == name) return *command;
  }
  throw UsageError(unknown_text("command", name, names_of_commands(), "rupture analyze --help"));
}

bool asks_for_help(std::string_view word) {
  return word == "help" || word == "--help" || word == "-h";
}

/// analyze help [COMMAND]
[[noreturn]] void answer_help(const std::vector<std::string>& words) {
  if (words.size() > 1) {
    throw UsageError(fmt::format("unexpected word '{}': help takes one command", words[1]));
  }
  if (words.empty() || asks_for_help(words.front())) throw HelpRequested{help()};
  answer(find(words.front()), "--help");
}

int run(int argc, char** argv) {
  const std::string_view first = argc > 1 ? argv[1] : "";
  if (first.empty()) {
    throw UsageError(
        fmt::format("no command was given: choose one of {} (rupture analyze help describes them)",
                    fmt::join(names_of_commands(), ", ")));
  }
  if (first == "help") answer_help({argv + 2, argv + argc});
  if (asks_for_help(first)) throw HelpRequested{help()};
  if (first == "--describe") throw HelpRequested{describe()};
  if (first == "--version") throw HelpRequested{version_text("analyze")};
  const Command& command = find(first);
  return command.run(parse(command, argc - 1, argv + 1));
}

}  // namespace

const std::vector<const Command*>& commands() {
  static const std::vector<const Command*> all = {
      &events_command,    &front_command,    &classify_command,     &slip_command,
      &slow_slip_command, &loading_command,  &stress_command,       &phi_command,
      &strength_command,  &estimate_command, &steady_state_command, &quantities_command,
      &checksum_command,  &verify_command,   &diff_command,         &show_command,
      &lineage_command};
  return all;
}

}  // namespace rupture::tools

int main(int argc, char** argv) {
  return rupture::tools::run_tool("analyze", [&] { return rupture::tools::run(argc, argv); });
}
