// Rows of tables/*.txt: a command, its exit code and what it says.
//
//   == BEGINNING          a new table; commands that begin with .. begin so
//   @ COMMAND             made before each row: a program that must succeed, file NAME "TEXT",
//                         folder NAME, link NAME TARGET, copy FROM TO, move FROM TO, mode NAME
//                         OCTAL, flip NAME BYTE, cut NAME BYTES or remove PATTERN; or what holds:
//                         same A B (bytes), equal A B (checksums), summed NAME (by its .sum),
//                         absent NAME
//   NAME [EXIT COMMAND]   a row: {a|b} stands for each of them, {1} for the first that was chosen,
//                         sum(FILE) for its checksum
//       TEXT              the sentence on standard error, in which ... is any text. No file changed
//       @ COMMAND         made then
//       > EXIT COMMAND    then this, which says the TEXTs that follow
//
// Of a command that exits with 0, or 1> (what differs is no failure), each TEXT is a line of
// standard output, lines: N their number, or something about JSON, as in expect_json(); the first
// is the head of CSV, whose lines have as many cells. Lines of the other stream are marked stdout:
// or stderr:. Without --force or --resume no file changed, behind 0= none at all; with 1+ files
// came although the command failed. In front of a command may stand [disk=BYTES], [stdout=FILE],
// [memory=GIB] and [nobody]: not as root. The command rebuilt FILE demands that the commands of its
// lineage make it from nothing.
#pragma once

#include <fstream>
#include <ostream>
#include <regex>
#include <sstream>

#include "tool_test.hpp"

namespace rupture::testing {

using Words = std::vector<std::string>;

/// A command and what it says, or behind @ what is made.
struct Step {
  std::string exit, command;
  Words said = {};
};

struct TableRow {
  std::string name;
  Words setup;
  std::vector<Step> steps;
};

inline std::ostream& operator<<(std::ostream& out, const TableRow& row) {
  return out << row.steps.front().command;
}

/// Reads a line; one that ends in a backslash goes on in the next.
inline bool read_line(std::istream& file, std::string& line) {
  if (!std::getline(file, line)) return false;
  for (std::string more; line.ends_with('\\') && std::getline(file, more);) {
    line.pop_back();
    line += more.substr(more.find_first_not_of(' '));
  }
  return true;
}

/// The command behind some words, with the beginning in place of its dots.
inline std::string command_in(std::istream& line, const std::string& beginning) {
  std::string command;
  std::getline(line >> std::ws, command);
  const std::size_t dots = command.find("..");
  const bool begins_so = dots == 0 || (dots != command.npos && command[dots - 2] == ']');
  return begins_so ? command.replace(dots, 2, beginning) : command;
}

/// The rows of one file.
inline std::vector<TableRow> rows_in(const fs::path& path) {
  std::vector<TableRow> rows;
  std::string beginning, word;
  Words setup;
  std::ifstream file(path);
  for (std::string line; read_line(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    words >> word;
    const auto step = [&] { return Step{word, command_in(words, beginning)}; };
    if (line.starts_with("==")) {
      beginning = line.substr(std::min(line.size(), std::size_t{3}));
      setup.clear();
    } else if (line.starts_with("@ ")) {
      setup.push_back(step().command);
    } else if (!line.starts_with("    ")) {
      rows.push_back({path.stem().string() + "_" + word, setup, {}});
      if (words >> word) rows.back().steps.push_back(step());
    } else if (word == "@" || (word == ">" && words >> word)) {
      rows.back().steps.push_back(step());
    } else {
      rows.back().steps.back().said.push_back(line.substr(4));
    }
  }
  return rows;
}

/// Every choice among {a|b|...} in `text`, with the words that were chosen.
inline std::vector<std::pair<std::string, Words>> choices_in(const std::string& text) {
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
inline std::string filled(std::string text, const Words& chosen) {
  for (std::size_t n = 0; n < chosen.size(); ++n) {
    const std::string place = '{' + std::to_string(n + 1) + '}';
    for (std::size_t at = 0; (at = text.find(place)) != std::string::npos;) {
      text.replace(at, place.size(), chosen[n]);
    }
  }
  return text;
}

/// Words of a command; quotes hold spaces, or nothing; double ones are those of JSON.
inline Words words_of(const std::string& command) {
  static const std::regex word(R"('([^']*)'|"(?:[^"\\]|\\.)*"|[^ ]+)");
  Words words;
  for (std::sregex_iterator at(command.begin(), command.end(), word), end; at != end; ++at) {
    const std::string text = at->str();
    if (text[0] == '"') {
      words.push_back(Json::parse(text));
    } else {
      words.push_back((*at)[1].matched ? (*at)[1].str() : text);
    }
  }
  return words;
}

}  // namespace rupture::testing
