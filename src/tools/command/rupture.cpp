// rupture TOOL: one command for all programs, which stay separate ones.
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>

#include "cli/report.hpp"
#include "run/output.hpp"
#include "rupture/checkpoint/layout.hpp"
#include "rupture/model/user_text.hpp"

namespace {

using namespace rupture;
using namespace rupture::tools;

using Words = std::vector<std::string>;

constexpr const char* kSummary = "simulate and analyse the rupture of frictional interfaces";
constexpr const char* kSynopsis = "rupture TOOL [argument...]";
constexpr const char* kPurpose =
    "Runs the program TOOL with these arguments; rupture help TOOL describes them.";

struct Tool {
  std::string_view name, summary;
  std::string_view begins = {};  ///< heading in the help of this tool and the next ones
};

/// All programs, in the order of the help. What those in C++ do stands in their own files.
const std::array kTools = {
    Tool{"load", load_command.summary, "Simulate"},
    Tool{"prepare", prepare_command.summary},
    Tool{"restart", restart_command.summary},
    Tool{"modify-phi", modify_phi_command.summary},
    Tool{"parameters", parameters_command.summary},
    Tool{"analyze", "measure, compare and check checkpoints and records", "Measure and draw"},
    Tool{"map", "draw a record in space and time"},
    Tool{"movie", "make a film of a record"},
    Tool{"xdmf", "write a series of checkpoints for ParaView and VTK"},
    Tool{"finish", finish_command.summary, "Rescue and edit files"},
    Tool{"seal", seal_command.summary},
    Tool{"reproduce", "compute figures of the paper, their claims, and sweeps of your own",
         "Compute many runs"},
};

namespace fs = std::filesystem;

/// The program of this name: in ../libexec/rupture if this one is installed, else beside it. Throws
/// Failure if one of kTools is not there, UsageError for other names.
fs::path tool_path(const std::string& name) {
  std::vector<std::string_view> names;
  for (const Tool& tool : kTools) names.push_back(tool.name);
  const fs::path own = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path installed = own / RUPTURE_TOOLS_FROM_BIN;
  const fs::path folder = fs::is_directory(installed) ? installed.lexically_normal() : own;
  const fs::path program = folder / name;
  std::error_code ignored;
  const bool can_run =
      fs::is_regular_file(program, ignored) && ::access(program.c_str(), X_OK) == 0;
  if (can_run && fs::path(name).filename() == name) return program;
  if (std::ranges::count(names, name) != 0) {
    throw Failure(
        "there is no program {} in {}: install rupture, or link to it instead of copying it", name,
        folder.string());
  }
  throw UsageError(unknown_text("tool", name, names, "rupture help"));
}

std::string help() {
  std::string text = fmt::format(
      "Usage: {}\n       rupture help [TOOL [COMMAND]]\n       rupture --version\n\n{}\n",
      kSynopsis, kPurpose);
  for (const Tool& tool : kTools) {
    if (!tool.begins.empty()) text += fmt::format("\n{}:\n", tool.begins);
    text += fmt::format("  {:<12} {}\n", tool.name, tool.summary);
  }
  text +=
      "\nExit codes: 0 done, 1 failed, 2 wrong use of the command line, 3 this machine failed "
      "(full disk, no\nmemory, no permission)\n";
  return text;
}

std::string describe() {
  Json json = {{"name", "rupture"},
               {"summary", kSummary},
               {"synopsis", kSynopsis},
               {"purpose", kPurpose},
               {"tools", Json::array()}};
  for (const Tool& tool : kTools) {
    json["tools"].push_back({{"name", tool.name}, {"summary", tool.summary}});
  }
  for (const FileKind kind : {FileKind::checkpoint, FileKind::record}) {
    Json& list = json["datasets"][std::string(kind_name(kind))];
    for (const DatasetInfo& row : datasets_of(kind)) {
      list.push_back(
          {{"path", row.path}, {"type", row.type}, {"lengths", row.lengths}, {"unit", row.unit}});
    }
  }
  return json_text(json) + "\n";
}

/// Becomes the tool, so that its exit code and all signals are its own.
[[noreturn]] void become(const std::string& tool, const Words& arguments) {
  const std::string path = tool_path(tool).string();
  std::vector<char*> argv = {const_cast<char*>(path.c_str())};
  for (const std::string& word : arguments) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  std::signal(SIGPIPE, SIG_DFL);  // ignored signals are inherited
  ::execv(path.c_str(), argv.data());
  throw MachineFailure("cannot run {}: {}", path, std::strerror(errno));
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
