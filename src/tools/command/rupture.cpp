// rupture TOOL: one command for all programs, which stay separate ones.
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>

#include "cli/command_line.hpp"
#include "cli/report.hpp"
#include "cli/text.hpp"
#include "command/tools.hpp"
#include "rupture/model/error.hpp"

namespace {

using namespace rupture;
using namespace rupture::tools;

using Words = std::vector<std::string>;

constexpr const char* kSummary = "simulate and analyse the rupture of frictional interfaces";
constexpr const char* kSynopsis = "rupture TOOL [argument...]";
constexpr const char* kPurpose =
    "Runs the program of this name with these arguments; rupture help TOOL says which it takes.";

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
  throw Failure(fmt::format("cannot run {}: {}", path, std::strerror(errno)));
}

/// rupture help TOOL COMMAND: what the tool says to COMMAND --help.
[[noreturn]] void help_of(Words words) {
  const std::string tool = words.front();
  words.erase(words.begin());
  words.emplace_back("--help");
  become(tool, words);
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
  help_of(words);
}

}  // namespace

int main(int argc, char** argv) {
  return run_tool("rupture", [&] { return run(Words(argv + 1, argv + argc)); });
}
