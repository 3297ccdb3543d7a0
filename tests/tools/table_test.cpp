// Rows of tables/*.txt: a command, its exit code and what it says.
//
//   == BEGINNING          a new table; commands that begin with .. begin so
//   @ COMMAND             made before each row: a program that must succeed, or file NAME "TEXT",
//                         folder NAME, link NAME TARGET, copy FROM TO, mode NAME OCTAL
//   NAME EXIT COMMAND     a row: {a|b} stands for each of them, {1} for the first that was chosen;
//       TEXT              the sentence on standard error, in which ... is any text. No file changed
//
// Of a command that exits with 0, or 1> (what differs is no failure), each TEXT is a line of
// standard output, lines: N their number, or something about JSON, as in expect_json(); the first
// is the head of CSV, whose lines have as many cells. Without --force no file changed. In front of
// a command may stand [disk=BYTES], [stdout=FILE], [memory=GIB] and [nobody]: not as root.
// The command rebuilt FILE demands that the commands of its lineage make it from nothing.
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <ostream>
#include <regex>
#include <sstream>

#include "tool_test.hpp"

namespace rupture::testing {
namespace {

using Words = std::vector<std::string>;

struct Row {
  std::string name, command, exit;
  Words setup, said;
};

std::ostream& operator<<(std::ostream& out, const Row& row) {
  return out << row.command;
}

/// Reads a line; one that ends in a backslash goes on in the next.
bool read_line(std::istream& file, std::string& line) {
  if (!std::getline(file, line)) return false;
  for (std::string more; line.ends_with('\\') && std::getline(file, more);) {
    line.pop_back();
    line += more.substr(more.find_first_not_of(' '));
  }
  return true;
}

Row row_of(const std::string& line, const std::string& beginning) {
  Row row;
  std::istringstream words(line);
  words >> row.name >> row.exit >> std::ws;
  std::getline(words, row.command);
  const std::size_t dots = row.command.find("..");
  const bool begins_so = dots == 0 || (dots != row.command.npos && row.command[dots - 2] == ']');
  if (begins_so) row.command.replace(dots, 2, beginning);
  return row;
}

/// The rows of one file.
std::vector<Row> rows_in(const fs::path& path) {
  std::vector<Row> rows;
  std::string beginning;
  Words setup;
  std::ifstream file(path);
  for (std::string line; read_line(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (line.starts_with("==")) {
      beginning = line.substr(std::min(line.size(), std::size_t{3}));
      setup.clear();
    } else if (line.starts_with("@ ")) {
      setup.push_back(line.substr(2));
    } else if (line.starts_with("    ")) {
      rows.back().said.push_back(line.substr(4));
    } else {
      rows.push_back(row_of(line, beginning));
      rows.back().name = path.stem().string() + "_" + rows.back().name;
      rows.back().setup = setup;
    }
  }
  return rows;
}

std::vector<Row> all_rows() {
  std::vector<Row> all;
  for (const auto& entry : fs::directory_iterator(RUPTURE_TABLES)) {
    if (entry.path().extension() != ".txt") continue;
    const auto rows = rows_in(entry.path());
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

/// Every choice among {a|b|...} in `text`, with the words that were chosen.
std::vector<std::pair<std::string, Words>> choices_in(const std::string& text) {
  static const std::regex braces(R"(\{([^{}]*\|[^{}]*)\})");
  std::smatch found;
  if (!std::regex_search(text, found, braces)) return {{text, {}}};
  std::vector<std::pair<std::string, Words>> all;
  std::istringstream words(found[1].str() + "|");
  for (std::string word; std::getline(words, word, '|');) {
    for (auto [rest, chosen] : choices_in(found.suffix())) {
      chosen.insert(chosen.begin(), word);
      all.emplace_back(found.prefix().str() + word + rest, std::move(chosen));
    }
  }
  return all;
}

/// {1}, {2}, ... become the words that were chosen.
std::string filled(std::string text, const Words& chosen) {
  for (std::size_t n = 0; n < chosen.size(); ++n) {
    const std::string place = '{' + std::to_string(n + 1) + '}';
    for (std::size_t at = 0; (at = text.find(place)) != std::string::npos;) {
      text.replace(at, place.size(), chosen[n]);
    }
  }
  return text;
}

/// Words of a command; quotes hold spaces, or nothing.
Words words_of(const std::string& command) {
  static const std::regex word(R"('([^']*)'|[^ ]+)");
  Words words;
  for (std::sregex_iterator at(command.begin(), command.end(), word), end; at != end; ++at) {
    words.push_back((*at)[1].matched ? (*at)[1].str() : at->str());
  }
  return words;
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

class Table : public ToolTest, public ::testing::WithParamInterface<Row> {
 protected:
  void prepare(const std::string& line) const {
    Words words = words_of(line);
    for (std::string& word : words) {
      if (word.starts_with("$CHECKPOINTS")) word.replace(0, 12, RUPTURE_CHECKPOINTS);
    }
    if (words[0] == "file") {
      const std::size_t at = line.find(' ', 5) + 1;
      write(words[1], Json::parse(line.substr(at)).get<std::string>());
    } else if (words[0] == "folder") {
      fs::create_directory(path(words[1]));
    } else if (words[0] == "link") {
      fs::create_symlink(words[2], path(words[1]));
    } else if (words[0] == "copy") {
      fs::copy_file(path(words[1]), path(words[2]));
    } else if (words[0] == "mode") {
      fs::permissions(path(words[1]), fs::perms(std::stoul(words[2], nullptr, 8)));
    } else {
      const Outcome outcome = run_words(words);
      ASSERT_EQ(outcome.exit_code, kDone) << line << "\n" << outcome.err;
    }
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

  void expect_row(std::string command, const Words& chosen) {
    if (command.starts_with("rebuilt ")) return expect_rebuilt(command.substr(8));
    const RunOptions options = options_in(command);
    if (options.memory && RUPTURE_SANITIZED) GTEST_SKIP() << "AddressSanitizer needs more memory";
    if (options.user && run("load --version", options).exit_code == kCannotStart) {
      GTEST_SKIP() << "another user cannot run the programs in this folder";
    }
    const std::string& exit = GetParam().exit;
    const Words words = words_of(command);
    const Files before = files();
    const Outcome outcome = run_words(words, options);
    EXPECT_EQ(outcome.exit_code, std::stoi(exit)) << command << "\n" << outcome.err;
    if (exit == "0" || exit.ends_with(">")) {
      EXPECT_EQ(outcome.err, "") << command;
      expect_output(outcome.out, chosen, command);
      const auto is = [&](const char* word) { return std::ranges::count(words, word) > 0; };
      if (!is("-f") && !is("--force")) expect_kept(before, command);
    } else {
      expect_refusal_like(outcome, words[0], chosen, command);
      EXPECT_TRUE(exit != "2" || outcome.out.empty()) << command << "\n" << outcome.out;
      EXPECT_EQ(names_of_changed(before, files()), "") << command;
    }
  }

 private:
  void expect_kept(const Files& before, const std::string& command) const {
    Files after = files();
    std::erase_if(after, [&](const auto& file) { return !before.contains(file.first); });
    EXPECT_EQ(names_of_changed(before, after), "") << command;
  }

  void expect_refusal_like(const Outcome& outcome, const std::string& tool, const Words& chosen,
                           const std::string& command) const {
    std::string sentence = tool + ":";
    for (const std::string& line : GetParam().said) sentence += " " + filled(line, chosen);
    EXPECT_PRED2(matches, outcome.err, sentence + "\n") << command;
  }

  static void expect_csv(const Words& lines, const std::string& head) {
    EXPECT_PRED2(matches, lines.at(0), head);
    for (const auto& line : lines) {
      EXPECT_EQ(std::ranges::count(line, ','), std::ranges::count(lines[0], ',')) << line;
    }
  }

  void expect_output(const std::string& out, const Words& chosen, const std::string& command) {
    const bool is_json = out.starts_with('{');
    const Words lines = lines_of(out);
    Words all;
    for (const std::string& text : GetParam().said) {
      for (const auto& [line, ignored] : choices_in(filled(text, chosen))) all.push_back(line);
    }
    if (command.find(" --csv") != command.npos) expect_csv(lines, all.at(0));
    for (const std::string& line : all) {
      if (line.starts_with('/') && is_json) {
        expect_json(Json::parse(out), line, first_);
      } else if (line.starts_with("lines: ")) {
        EXPECT_EQ(std::to_string(lines.size()), line.substr(7)) << command << "\n" << out;
      } else {
        EXPECT_TRUE(std::any_of(lines.begin(), lines.end(),
                                [&](const auto& said) { return matches(said, line); }))
            << command << "\n"
            << out << "has no line\n"
            << line;
      }
    }
  }

  First first_;
};

TEST_P(Table, row) {
  for (const std::string& line : GetParam().setup) ASSERT_NO_FATAL_FAILURE(prepare(line));
  for (const auto& [command, chosen] : choices_in(GetParam().command)) {
    expect_row(filled(command, chosen), chosen);
  }
}

INSTANTIATE_TEST_SUITE_P(Tools, Table, ::testing::ValuesIn(all_rows()),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace rupture::testing
