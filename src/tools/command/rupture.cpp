// rupture TOOL: one command for all programs, which stay separate ones.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string_view>

#include "cli/command_line.hpp"
#include "cli/report.hpp"
#include "cli/text.hpp"
#include "rupture/checkpoint/provenance.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/user_text.hpp"

namespace {

using namespace rupture;
using namespace rupture::tools;

using Words = std::vector<std::string>;

constexpr const char* kSummary = "simulate and analyse the rupture of frictional interfaces";
constexpr const char* kSynopsis = "rupture TOOL [argument...]";
constexpr const char* kPurpose =
    "Runs the program TOOL with these arguments; rupture help TOOL describes them.";

namespace fs = std::filesystem;

fs::path tool_folder() {
  const fs::path own = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path installed = own / RUPTURE_TOOLS_FROM_BIN;
  return fs::is_directory(installed) ? installed.lexically_normal() : own;
}

bool can_run(const fs::path& program) {
  std::error_code ignored;
  return fs::is_regular_file(program, ignored) && ::access(program.c_str(), X_OK) == 0;
}

using Answer = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Asks a program, and leaves it to answer.
Answer ask(const fs::path& program) {
  const std::string question = shell_line({program.string(), "--describe"});
  return {::popen((question + " 2>/dev/null </dev/null").c_str(), "re"), ::pclose};
}

std::string read_all(std::FILE* file) {
  std::string text;
  std::array<char, 4096> part{};
  while (const auto size = std::fread(part.data(), 1, part.size(), file)) {
    text.append(part.data(), size);
  }
  return text;
}

Json description_in(const Answer& answer, std::string_view name) {
  Json json =
      answer ? Json::parse(read_all(answer.get()), nullptr, /*allow_exceptions=*/false) : Json();
  return json.is_object() ? json : Json({{"name", name}});
}

/// The names of the programs that are built and installed with this one, in the order of the help.
Words tool_names() {
  return split(RUPTURE_TOOLS, ' ');
}

/// The program of this name: in ../libexec/rupture if this one is installed, else beside it. Throws
/// Failure if one of tool_names() is not there, UsageError for other names.
fs::path tool_path(const std::string& name) {
  const Words names = tool_names();
  const fs::path folder = tool_folder(), program = folder / name;
  if (fs::path(name).filename() == name && can_run(program)) return program;
  if (std::ranges::count(names, name) != 0) {
    throw Failure(
        "there is no program {} in {}: install rupture, or link to it instead of copying it", name,
        folder.string());
  }
  throw UsageError(unknown_text("tool", name, {names.begin(), names.end()}, "rupture help"));
}

/// What each of tool_names() answers to --describe (docs/schema.md); of one that does not, only its
/// name.
Json tool_descriptions() {
  const Words names = tool_names();
  std::vector<Answer> answers;  // all are asked at once, because some take a while
  for (const auto& name : names) answers.push_back(ask(tool_folder() / name));
  Json all = Json::array();
  for (std::size_t i = 0; i < answers.size(); ++i) {
    all.push_back(description_in(answers[i], names[i]));
  }
  return all;
}

std::string help() {
  std::string text = fmt::format(
      "Usage: {}\n       rupture help [TOOL [COMMAND]]\n       rupture --version\n\n{}\n\nTools:\n",
      kSynopsis, kPurpose);
  for (const Json& tool : tool_descriptions()) {
    const std::string summary = tool.value("summary", tool.value("purpose", ""));
    text += fmt::format("  {:<12} {}\n", std::string(tool.at("name")), summary);
  }
  return text;
}

std::string describe() {
  return json_text({{"name", "rupture"},
                    {"summary", kSummary},
                    {"synopsis", kSynopsis},
                    {"purpose", kPurpose},
                    {"tools", tool_descriptions()}}) +
         "\n";
}

/// Becomes the tool, so that its exit code and all signals are its own.
[[noreturn]] void become(const std::string& tool, const Words& arguments) {
  const std::string path = tool_path(tool).string();
  std::vector<char*> argv = {const_cast<char*>(path.c_str())};
  for (const std::string& word : arguments) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  std::signal(SIGPIPE, SIG_DFL);  // ignored signals are inherited
  ::execv(path.c_str(), argv.data());
  throw Failure("cannot run {}: {}", path, std::strerror(errno));
}

int run(Words words) {
  if (words.empty()) {
    say_on(stderr, "{}", help());
    return kUsage;
  }
  const std::string first = words.front();
  words.erase(words.begin());
  if (first == "--version") throw HelpRequested{version_text("rupture")};
  if (first == "--describe") throw HelpRequested{describe()};
  if (first != "help" && first != "--help" && first != "-h") become(first, words);
  if (words.empty() || words.front() == "help") throw HelpRequested{help()};
  words.emplace_back("--help");  // rupture help TOOL COMMAND: what the tool says to COMMAND --help
  become(words.front(), {words.begin() + 1, words.end()});
}

}  // namespace

int main(int argc, char** argv) {
  return run_tool("rupture", [&] { return run(Words(argv + 1, argv + argc)); });
}
