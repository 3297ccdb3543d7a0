#include "tool_test.hpp"

#include <stdlib.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "support/files.hpp"

namespace rupture::testing {
namespace {

constexpr std::string_view kSmallSlider =
    "[slider]\nNx = 9\nNz = 5\nH = 0.07\n[driving]\nh = 0.0175\nV = 1\n";

fs::path fresh_folder() {
  std::string name = fs::temp_directory_path() / "rupture-test-XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  return name;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::string tool_of(std::string_view command) {
  return std::string(command.substr(0, command.find(' ')));
}

}  // namespace

std::string names_of_changed(const Files& before, const Files& after) {
  std::string names;
  for (const auto& [name, bytes] : before) {
    const auto found = after.find(name);
    if (found == after.end() || found->second != bytes) names += name + " ";
  }
  for (const auto& [name, bytes] : after) {
    if (!before.contains(name)) names += name + " ";
  }
  return names;
}

ToolTest::ToolTest() : folder_(fresh_folder()) {
  write("small.ini", kSmallSlider);
}

ToolTest::~ToolTest() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

Outcome ToolTest::run(std::string_view command, RunOptions options) const {
  return run_words(split(command, ' '), std::move(options));
}

Outcome ToolTest::run_words(std::vector<std::string> words, RunOptions options) const {
  words.front() = fs::path(RUPTURE_BIN_DIR) / words.front();
  options.folder = folder_;
  return run_program(words, options);
}

std::string ToolTest::output_of(std::string_view command) const {
  const Outcome outcome = run(command);
  EXPECT_EQ(outcome.exit_code, kDone) << command;
  EXPECT_EQ(outcome.err, "") << command;
  return outcome.out;
}

Json ToolTest::json_of(std::string_view command) const {
  return Json::parse(output_of(command));
}

std::string ToolTest::checksum_of(const std::string& file) const {
  const std::string text = checksum_in(file);
  EXPECT_EQ(text.size(), 65U);
  return text.substr(0, 64);
}

void ToolTest::expect_refusal(std::string_view command, ExitCode code, std::string_view sentence,
                              RunOptions options) const {
  const Files before = files();
  const Outcome outcome = run(command, std::move(options));
  EXPECT_EQ(outcome.exit_code, code) << command;
  EXPECT_EQ(outcome.err, tool_of(command) + ": " + std::string(sentence) + "\n") << command;
  EXPECT_EQ(names_of_changed(before, files()), "") << command;
}

void ToolTest::expect_refusal_with(std::string_view command, ExitCode code, std::string_view part,
                                   RunOptions options) const {
  const Files before = files();
  const Outcome outcome = run(command, std::move(options));
  EXPECT_EQ(outcome.exit_code, code) << command;
  expect_one_sentence(outcome.err, tool_of(command), part);
  EXPECT_EQ(names_of_changed(before, files()), "") << command;
}

Outcome ToolTest::run_script(const std::string& script) const {
  const fs::path folder = path("again");
  fs::remove_all(folder);
  fs::create_directory(folder);
  const std::string search = std::string(RUPTURE_BIN_DIR) + ":" + std::getenv("PATH");
  return run_program({"/bin/bash", "-c", script},
                     {.folder = folder, .environment = {{"PATH", search}}});
}

std::string ToolTest::script_for(const std::string& file,
                                 const std::vector<std::string>& more) const {
  std::vector<std::string> words = {"analyze", "lineage", file, "--commands"};
  words.insert(words.end(), more.begin(), more.end());
  const Outcome outcome = run_words(words);
  EXPECT_EQ(outcome.exit_code, kDone) << outcome.err;
  return outcome.out;
}

void ToolTest::expect_rebuilt(const std::string& file) const {
  const std::string script = script_for(file);
  const Outcome outcome = run_script(script);
  EXPECT_EQ(outcome.exit_code, kDone) << script;
  EXPECT_EQ(outcome.err, "") << script;
  EXPECT_EQ(checksum_in("again/rebuilt.h5"), checksum_in(file)) << script;
}

Files ToolTest::files() const {
  Files all;
  for (const auto& entry :
       fs::recursive_directory_iterator(folder_, fs::directory_options::skip_permission_denied)) {
    const std::string name = entry.path().lexically_relative(folder_);
    if (entry.is_symlink()) {
      all[name + "@"] = fs::read_symlink(entry.path());
    } else if (entry.is_directory()) {
      all[name + "/"] = "";
    } else {
      all[name] = slurp(entry.path());
    }
  }
  return all;
}

std::string ToolTest::read(const std::string& file) const {
  EXPECT_TRUE(fs::exists(path(file))) << file;
  return slurp(path(file));
}

void ToolTest::write(const std::string& file, std::string_view bytes) const {
  std::ofstream out(path(file), std::ios::binary | std::ios::trunc);
  out << bytes;
}

void expect_one_sentence(const std::string& err, const std::string& tool, std::string_view part) {
  EXPECT_EQ(err.find(tool + ": "), 0U) << err;
  EXPECT_EQ(lines_of(err).size(), 1U) << err;
  EXPECT_NE(err.find(part), std::string::npos) << err << "lacks '" << part << "'";
}

bool matches(std::string_view text, std::string_view pattern) {
  const std::size_t gap = pattern.find("...");
  if (gap == std::string_view::npos) return text == pattern;
  if (!text.starts_with(pattern.substr(0, gap))) return false;
  text.remove_prefix(gap);
  for (; !matches(text, pattern.substr(gap + 3)); text.remove_prefix(1)) {
    if (text.empty() || text[0] == '\n') return false;
  }
  return true;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines = split(text, '\n');
  if (lines.back().empty()) lines.pop_back();  // what follows the last line's end
  return lines;
}

std::vector<std::vector<std::string>> csv_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& line : lines_of(text)) rows.push_back(split(line, ','));
  return rows;
}

}  // namespace rupture::testing
