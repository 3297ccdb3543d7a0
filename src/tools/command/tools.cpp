#include "command/tools.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>

#include "rupture/checkpoint/provenance.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/user_text.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

fs::path tool_folder() {
  const fs::path own = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path installed = own / RUPTURE_TOOLS_FROM_BIN;
  return fs::is_directory(installed) ? installed.lexically_normal() : own;
}

bool can_run(const fs::path& program) {
  return fs::is_regular_file(program) && ::access(program.c_str(), X_OK) == 0;
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

}  // namespace

std::vector<std::string_view> tool_names() {
  constexpr std::string_view all = RUPTURE_TOOLS;  // with a space behind each
  std::vector<std::string_view> names;
  for (std::size_t from = 0, to = 0; (to = all.find(' ', from)) != all.npos; from = to + 1) {
    names.push_back(all.substr(from, to - from));
  }
  return names;
}

fs::path tool_path(const std::string& name) {
  const fs::path folder = tool_folder(), program = folder / name;
  if (fs::path(name).filename() == name && can_run(program)) return program;
  if (std::ranges::count(tool_names(), name) != 0) {
    throw Failure(fmt::format(
        "there is no program {} in {}: install rupture, or link to it instead of copying it", name,
        folder.string()));
  }
  throw UsageError(fmt::format("unknown tool '{}': did you mean '{}'? See rupture help", name,
                               nearest(name, tool_names())));
}

Json tool_descriptions() {
  std::vector<Answer> answers;  // all are asked at once, because some take a while
  for (const auto name : tool_names()) answers.push_back(ask(tool_folder() / name));
  Json all = Json::array();
  for (std::size_t i = 0; i < answers.size(); ++i) {
    all.push_back(description_in(answers[i], tool_names()[i]));
  }
  return all;
}

}  // namespace rupture::tools
