// Runs the rows of tables/*.txt, whose form stands in table_rows.hpp.
#include <fnmatch.h>
#include <unistd.h>

#include <cmath>
#include <functional>

#include "table_rows.hpp"

namespace rupture::testing {
namespace {

std::vector<TableRow> all_rows() {
  std::vector<TableRow> all;
  for (const auto& entry :
       fs::directory_iterator(fs::path(RUPTURE_SOURCE) / "tests/tools/tables")) {
    if (entry.path().extension() != ".txt") continue;
    const auto rows = rows_in(entry.path());
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

/// What was found first for each line that ends in "same".
using First = std::map<std::string, Json>;

/// One line about JSON: PATH = JSON, PATH ~ NUMBER or LIST +- NUMBER, PATH < NUMBER, PATH > NUMBER,
/// or PATH same, in all that the row runs.
void expect_json(const Json& json, const std::string& line, First& first) {
  std::istringstream words(line);
  std::string path, relation, value;
  words >> path >> relation >> std::ws;
  std::getline(words, value);
  const bool is_size = path.ends_with("/#");
  if (is_size) path.resize(path.size() - 2);
  const Json::json_pointer pointer(path == "/" ? "" : path);
  ASSERT_TRUE(json.contains(pointer)) << line;
  const Json found = is_size ? Json(json.at(pointer).size()) : json.at(pointer);
  if (relation == "=") {
    EXPECT_EQ(found, Json::parse(value)) << line;
  } else if (relation == "~") {
    const std::size_t end = value.find("+-");
    const Json wanted = Json::parse(value.substr(0, end));
    ASSERT_EQ(found.size(), wanted.size()) << line;
    for (auto one = found.begin(); const Json& number : wanted) {
      EXPECT_LE(std::abs((one++)->get<double>() - number.get<double>()),
                std::stod(value.substr(end + 2)))
          << line << ": " << found;
    }
  } else if (relation == "same") {
    EXPECT_EQ(found, first.emplace(line, found).first->second) << line;
  } else {
    ASSERT_TRUE(relation == "<" || relation == ">") << line;
    const double sign = relation == "<" ? 1.0 : -1.0;
    EXPECT_LT(sign * found.get<double>(), sign * std::stod(value)) << line << ": " << found;
  }
}

class Table : public ToolTest, public ::testing::WithParamInterface<TableRow> {
 protected:
  /// Runs a step in all its choices, which follow those of the row.
  void take(const Step& step, const std::string& text, const Words& chosen_before) {
    for (const auto& [command, more] : choices_in(text)) {
      Words chosen = chosen_before;
      chosen.insert(chosen.end(), more.begin(), more.end());
      const std::string whole = with_sums(filled(command, chosen));
      if (step.exit == "@") {
        ASSERT_NO_FATAL_FAILURE(make(whole));
      } else {
        expect_command(step, whole, chosen);
      }
    }
  }

 private:
  std::string with_sums(std::string text) const {
    static const std::regex sum(R"(sum\(([^)]*)\))");
    for (std::smatch found; std::regex_search(text, found, sum);) {
      text = found.prefix().str() + checksum_in(found[1]).substr(0, 64) + found.suffix().str();
    }
    return text;
  }

  using Name = const std::string&;
  using Verb = std::function<void(Name name, Name second)>;

  std::map<std::string, Verb> verbs() const {
    return {
        {"file", [=, this](Name name, Name text) { write(name, text); }},
        {"folder", [=, this](Name name, Name) { fs::create_directories(path(name)); }},
        {"link", [=, this](Name name, Name target) { fs::create_symlink(target, path(name)); }},
        {"copy",
         [=, this](Name from, Name to) {
           fs::copy_file(path(from), path(to), fs::copy_options::overwrite_existing);
         }},
        {"move", [=, this](Name from, Name to) { fs::rename(path(from), path(to)); }},
        {"mode",
         [=, this](Name name, Name octal) {
           fs::permissions(path(name), fs::perms(std::stoul(octal, nullptr, 8)));
         }},
        {"flip",
         [=, this](Name name, Name at) {
           std::string bytes = read(name);
           bytes.at(std::stoul(at)) ^= 1;
           write(name, bytes);
         }},
        {"cut",
         [=, this](Name name, Name size) { write(name, read(name).substr(0, std::stoul(size))); }},
        {"remove", [=, this](Name pattern, Name) { remove(pattern); }},
        {"absent", [=, this](Name name, Name) { EXPECT_FALSE(fs::exists(path(name))) << name; }},
        {"same", [=, this](Name a, Name b) { EXPECT_TRUE(read(a) == read(b)) << a << b; }},
        {"equal",
         [=, this](Name a, Name b) { EXPECT_EQ(checksum_of(a), checksum_of(b)) << a << b; }},
        {"summed", [=, this](Name a, Name) { EXPECT_EQ(read(a + ".sum"), sum_line(a)) << a; }},
    };
  }

  /// Files whose names match, as a shell takes it.
  void remove(const std::string& pattern) const {
    for (const auto& [name, bytes] : files()) {
      if (::fnmatch(pattern.c_str(), name.c_str(), FNM_PATHNAME) == 0) fs::remove(path(name));
    }
  }

  /// What stands behind an @.
  void make(std::string line) const {
    static const std::string source = "$SOURCE";
    const std::size_t at = line.find(source);
    if (at != line.npos) line.replace(at, source.size(), RUPTURE_SOURCE);
    const Words words = words_of(line);
    const auto known = verbs();
    if (const auto verb = known.find(words[0]); verb != known.end()) {
      return verb->second(words[1], words.size() > 2 ? words[2] : "");
    }
    const Outcome outcome = run_words(words);
    ASSERT_EQ(outcome.exit_code, kDone) << line << "\n" << outcome.err;
  }

  /// [disk=BYTES], [stdout=FILE], [memory=GIB] or [nobody] in front of a command.
  static RunOptions options_in(std::string& command) {
    RunOptions options;
    static const std::regex option(R"(^\[(\w+)=?([^\]]*)\] )");
    std::smatch found;
    if (!std::regex_search(command, found, option)) return options;
    const std::string name = found[1], value = found[2];
    if (name == "disk") options.largest_file = std::stoull(value);
    if (name == "stdout") options.standard_output = value;
    if (name == "memory") options.memory = std::stoull(value) << 30U;
    if (name == "nobody" && ::geteuid() == 0) options.user = 65534;  // root may write everywhere
    command = found.suffix();
    return options;
  }

  void expect_command(const Step& step, std::string command, const Words& chosen) {
    if (command.starts_with("rebuilt ")) return expect_rebuilt(command.substr(8));
    const RunOptions options = options_in(command);
    if (options.memory && RUPTURE_SANITIZED) GTEST_SKIP() << "AddressSanitizer needs more memory";
    if (options.user && run("load --version", options).exit_code == kCannotStart) {
      GTEST_SKIP() << "another user cannot run the programs in this folder";
    }
    const Words words = words_of(command);
    const Files before = files();
    const Outcome outcome = run_words(words, options);
    EXPECT_EQ(outcome.exit_code, std::stoi(step.exit)) << command << "\n" << outcome.err;
    expect_texts(outcome, step, words[0], chosen);
    expect_kept(before, step.exit, words);
  }

  void expect_texts(const Outcome& outcome, const Step& step, const std::string& tool,
                    const Words& chosen) {
    const bool is_done = step.exit[0] == '0' || step.exit.ends_with('>');
    std::string err, sentence = is_done ? "" : tool + ":";
    Words out;
    for (const std::string& text : step.said) {
      const std::string line = with_sums(filled(text, chosen));
      if (line.starts_with("stderr: ")) {
        err += line.substr(8) + "\n";
      } else if (is_done || line.starts_with("stdout: ")) {
        out.push_back(line.substr(line.starts_with("stdout: ") ? 8 : 0));
      } else {
        sentence += " " + line;
      }
    }
    EXPECT_PRED2(matches, outcome.err, err + sentence + (is_done ? "" : "\n")) << step.command;
    EXPECT_TRUE(step.exit != "2" || outcome.out.empty()) << step.command << "\n" << outcome.out;
    if (!out.empty()) expect_output(outcome.out, out, step.command);
  }

  /// Which files may have changed depends on the exit code and the options.
  void expect_kept(const Files& before, const std::string& exit, const Words& words) const {
    const auto is = [&](const char* word) { return std::ranges::count(words, word) > 0; };
    Files after = files();
    const bool may_write = std::string_view("0>+").find(exit.back()) != std::string_view::npos;
    if (may_write && (is("-f") || is("--force") || is("--resume"))) return;
    if (may_write)
      std::erase_if(after, [&](const auto& file) { return !before.contains(file.first); });
    EXPECT_EQ(names_of_changed(before, after), "") << GetParam();
  }

  static void expect_csv(const Words& lines, const std::string& head) {
    EXPECT_PRED2(matches, lines.at(0), head);
    for (const auto& line : lines) {
      EXPECT_EQ(std::ranges::count(line, ','), std::ranges::count(lines[0], ',')) << line;
    }
  }

  void expect_output(const std::string& out, const Words& said, const std::string& command) {
    const bool is_json = out.starts_with('{');
    const Words lines = lines_of(out);
    auto at = lines.begin();
    Words all;
    for (const std::string& text : said) {
      for (const auto& [line, ignored] : choices_in(text)) all.push_back(line);
    }
    if (command.find(" --csv") != command.npos) expect_csv(lines, all.at(0));
    for (const std::string& line : all) {
      if (line.starts_with('/') && is_json) {
        expect_json(Json::parse(out), line, first_);
      } else if (line.starts_with("lines: ")) {
        EXPECT_EQ(std::to_string(lines.size()), line.substr(7)) << command << "\n" << out;
      } else {
        at = std::find_if(at, lines.end(), [&](const auto& text) { return matches(text, line); });
        ASSERT_NE(at, lines.end()) << command << "\n" << out << "has no line\n" << line;
        ++at;
      }
    }
  }

  First first_;
};

TEST_P(Table, row) {
  const Step setup = {"@", ""};
  for (const auto& line : GetParam().setup) ASSERT_NO_FATAL_FAILURE(take(setup, line, {}));
  const std::vector<Step>& steps = GetParam().steps;
  for (const auto& [front, chosen] : choices_in(steps.front().command)) {
    for (const Step& step : steps) {
      const std::string& text = &step == &steps.front() ? front : step.command;
      ASSERT_NO_FATAL_FAILURE(take(step, filled(text, chosen), chosen));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Tools, Table, ::testing::ValuesIn(all_rows()),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace rupture::testing
