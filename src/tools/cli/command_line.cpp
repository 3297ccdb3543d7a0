#include "cli/command_line.hpp"

#include <fmt/core.h>
#include <sys/mman.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include "cli/interruption.hpp"
#include "cli/report.hpp"
#include "cli/text.hpp"
#include "rupture/checkpoint/file.hpp"
#include "rupture/forces/kernels.hpp"
#include "rupture/model/user_text.hpp"
#include "rupture/version.hpp"

namespace rupture::tools {
namespace {

/// Options that a file cannot have.
constexpr std::array kTyped = {"force", "resume", "config", "describe", "version", "help"};

po::options_description common_options(UsesParameters uses_parameters) {
  po::options_description common("Common options");
  auto add = common.add_options();
  if (uses_parameters == UsesParameters::yes) {
    add("config", input_file("options and parameters"),
        "INI file with options and parameters ([slider] L = 0.14 ...). Flags are yes or no "
        "there, and lists have blanks between their values");
    add("set", assignments(), "set one parameter, overriding --config; may be repeated");
    add("seed", seed(), "short for --set numerics.seed=N");
  }
  add("help,h", "show this help and exit");
  add("describe", "print name, options, input and outputs as one JSON object and exit");
  add("version", "show version, commit and instruction set and exit");
  return common;
}

std::string help_text(const Command& command, const po::options_description& shown) {
  std::ostringstream out;
  out << "Usage: rupture " << command.synopsis() << "\n\n" << command.purpose << "\n" << shown;
  if (command.uses_parameters == UsesParameters::yes) {
    out << "\nParameters for --set and --config: rupture parameters lists them. Values are in SI "
           "units; a\nunit may be given, as in --until 10ms or --set slider.E=3GPa.\n";
  }
  return out.str();
}

/// The parameter that an option sets: --set, --seed, or in an INI file a name of no option.
std::optional<ParameterChange> change_by(const po::option& option, const std::string& where) {
  const std::string value = option.value.empty() ? "" : option.value.front();
  if (option.string_key == "seed") return ParameterChange{"numerics.seed", value, where};
  if (option.unregistered) return ParameterChange{option.string_key, value, where};
  if (option.string_key != "set") return std::nullopt;
  const auto equals = value.find('=');
  if (equals == std::string::npos) {
    throw UsageError("{}--set {} has no '=': write --set NAME=VALUE", where, value);
  }
  return ParameterChange{value.substr(0, equals), value.substr(equals + 1), where};
}

/// Only values for a part of the interface may follow each other.
void add_once(ParameterChange change, ParameterChanges& changes) {
  if (!is_along_x(change.value) &&
      std::ranges::count(changes, change.name, &ParameterChange::name) > 0) {
    throw UsageError("{}{} is given twice: give it once", change.where, change.name);
  }
  changes.push_back(std::move(change));
}

/// What yes or no, or other words for them, say; none if it is neither.
std::optional<bool> yes_or_no(const std::string& word) try {
  boost::any value;
  po::validate(value, {word.empty() ? "neither" : word}, static_cast<bool*>(nullptr), 0);
  return boost::any_cast<bool>(value);
} catch (const po::validation_error&) {
  return std::nullopt;
}

/// An option in an INI file as on the command line; none if the file switches it off.
std::optional<po::option> as_typed(po::option option, const po::options_description& options,
                                   const std::string& where) {
  const auto& kind = *options.find(option.string_key, /*approx=*/false).semantic();
  const std::string value = option.value.front();
  const bool is_list = kind.max_tokens() > 1 && !value.empty();
  if (is_list) option.value = po::split_unix(value, " \t", "\"", /*escape=*/"");
  const std::optional<bool> is_on = yes_or_no(value);
  const bool is_flag = kind.max_tokens() == 0 || (is_on && !number_in(value, "s"));
  if (kind.min_tokens() > 0 || !is_flag) return option;
  if (!is_on) throw UsageError("{} must be yes or no (got '{}')", where + option.string_key, value);
  option.value.clear();
  return *is_on ? std::optional(option) : std::nullopt;
}

/// A line of an INI file without the comment that ; begins, there or behind a space, as in sweeps.
std::string without_comment(const std::string& line) {
  const std::string text = " " + line;
  return line.substr(0, std::min(text.find(" ;"), text.find("\t;")));
}

/// What a line of an INI file gives in the group that is open, or none; it may open another one.
std::vector<po::option> options_in(std::string line, std::string& group,
                                   const po::options_description& options) {
  if (const auto begin = line.find_first_not_of(" \t"); line.substr(0, 1 + begin).ends_with('[')) {
    group = std::exchange(line, "");
  }
  std::istringstream lines(group + "\n" + line);
  return po::parse_config_file(lines, options, /*allow_unregistered=*/true).options;
}

/// Throws UsageError for a name without a group that no option has: parameters have groups.
void check_name(const std::string& name, const po::options_description& options,
                const std::string& where) {
  if (name.find('.') != std::string::npos) return;  // a parameter's, checked when it is set
  std::vector<std::string_view> known;
  for (const auto& option : options.options()) known.push_back(option->long_name());
  for (const ParameterInfo& info : parameter_table()) known.push_back(info.name);
  throw UsageError(where + unknown_text("option or parameter", name, known, "rupture parameters"));
}

/// Options in the file go to `values` unless the command line gave them; other names are
/// parameters. Throws UsageError with the line, or Failure if the file cannot be read.
ParameterChanges read_config(const std::string& path, const po::options_description& options,
                             po::variables_map& values) {
  std::istringstream lines(text_of_file(path, "configuration file", "INI file"));
  ParameterChanges changes;
  po::parsed_options known(&options);
  std::set<std::string> given;
  std::string group, line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::string where = fmt::format("{}:{}: ", path, number);
    try {
      for (const po::option& option : options_in(without_comment(line), group, options)) {
        if (option.unregistered) check_name(option.string_key, options, where);
        const std::string& name = option.string_key;
        if (std::ranges::count(kTyped, name) > 0)
          throw UsageError("{}give {} on the command line, not in a file", where, name);
        if (auto change = change_by(option, where)) {
          add_once(*std::move(change), changes);
        } else if (!given.insert(name).second) {
          throw UsageError("{}{} is given twice: give it once", where, name);
        } else if (const auto typed = as_typed(option, options, where)) {
          known.options.push_back(*typed);
          po::variables_map so_far;  // an impossible value throws
          po::store(known, so_far);
        }
      }
    } catch (const po::invalid_syntax&) {
      throw UsageError("{}expected NAME = VALUE or [GROUP] (got '{}')", where, line);
    } catch (const po::error& error) {
      throw po::error(where + error.what());
    }
  }
  po::store(known, values);
  return changes;
}

/// Throws UsageError for an = behind a short option: -o=x.h5 would name the file =x.h5.
void refuse_equals_sign(const std::string& word) {
  if (!word.starts_with('-') || word.starts_with("--") || word.find('=') == word.npos) return;
  throw UsageError("'{}' has an '=' behind a short option: leave a blank, as in -o x.h5", word);
}

/// "unknown option '--untill': did you mean '--until'?"
std::string unknown_option_text(const std::string& option, const po::options_description& known,
                                std::string_view tool) {
  refuse_equals_sign(option);
  std::vector<std::string> names;
  for (const auto& description : known.options()) {
    names.push_back("--" + description->long_name());
  }
  return unknown_text("option", option.substr(0, option.find('=')), {names.begin(), names.end()},
                      fmt::format("rupture {} --help", tool));
}

/// Throws UsageError if the word belongs to what stands in front of it, and is no file.
void refuse_part_of_value(const std::string& word) {
  if (word == "from" && !is_there(word)) {
    throw UsageError("unexpected word 'from': quote the value, as in \"0.6 from 70mm to 84mm\"");
  }
  for (const ParameterInfo& info : parameter_table()) {
    if (!in_unit("1 " + word, info.unit) || is_there(word)) continue;
    throw UsageError("unexpected word '{}': write the number and its unit as one word, as in 1{}",
                     word, word);
  }
}

/// The sentence; the middle of a long one, which may quote whole files, is left out.
int complain(const std::string& name, const std::string& message, ExitCode code) {
  constexpr std::size_t most = 1000, tail = 300;  // bytes
  std::string line = in_one_line(message);
  if (line.size() > most) line.replace(most - tail, line.size() - most, "…");
  std::fflush(stdout);
  say_on(stderr, "{}: {}\n", name, line);
  return code;
}

/// Whether there is memory for small tasks. Libraries crash where they get none.
bool has_memory() {
  constexpr std::size_t enough = 16'000'000;  // bytes
  void* const room = ::mmap(nullptr, enough, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return room != MAP_FAILED && ::munmap(room, enough) == 0;
}

}  // namespace

std::string_view Command::name() const {
  std::size_t end = call.find(' ');
  while (end < call.size() && std::islower(static_cast<unsigned char>(call[end + 1])) != 0)
    end = call.find(' ', end + 1);
  return call.substr(0, end);
}

Parsed parse(const Command& command, int argc, const char* const* argv) {
  po::options_description options("Options");
  for (const AddOptions add : command.own) {
    if (add != nullptr) add(options);
  }
  po::options_description shown;
  shown.add(options).add(common_options(command.uses_parameters));
  po::options_description all;
  all.add(shown);
  const std::string inputs = *command.input == '\0' ? "unexpected" : command.input;
  all.add_options()(inputs.c_str(), po::value<std::vector<std::string>>());
  po::positional_options_description positions;
  positions.add(inputs.c_str(), -1);
  using Style = po::command_line_style::style_t;
  const int style = Style::unix_style & ~Style::allow_guessing;

  Parsed parsed;
  parsed.arguments.assign(argv, argv + argc);
  try {
    const po::parsed_options given =
        po::command_line_parser(argc, argv).options(all).positional(positions).style(style).run();
    for (const po::option& option : given.options) {  // -o =x.h5 are two words
      const bool begins_so = !option.value.empty() && option.value.front().starts_with('=');
      if (begins_so) refuse_equals_sign(option.original_tokens.front());
    }
    po::store(given, parsed.values);
    if (parsed.values.count("help") > 0) throw HelpRequested{help_text(command, shown)};
    if (parsed.values.count("describe") > 0) {
      throw HelpRequested{json_text(description(command, shown)) + "\n"};
    }
    if (parsed.values.count("version") > 0) {
      throw HelpRequested{version_text(std::string(command.name()))};
    }
    if (parsed.values.count("unexpected") > 0) {
      const auto words = parsed.values["unexpected"].as<std::vector<std::string>>();
      refuse_part_of_value(words.front());
      throw UsageError("unexpected argument '{}': {} reads no files; see rupture {} --help",
                       words.front(), command.name(), command.name());
    }
    if (parsed.values.count("config") > 0) {
      parsed.parameters =
          read_config(parsed.values["config"].as<std::string>(), all, parsed.values);
    }
    po::notify(parsed.values);
    ParameterChanges changes;
    for (const po::option& option : given.options) {
      if (auto change = change_by(option, "")) add_once(*std::move(change), changes);
    }
    for (const auto& change : changes) {  // a part leaves the rest as in the file
      const auto same = [&](const ParameterChange& other) { return other.name == change.name; };
      if (!is_along_x(change.value)) std::erase_if(parsed.parameters, same);
    }
    parsed.parameters.insert(parsed.parameters.end(), changes.begin(), changes.end());
  } catch (const po::unknown_option& error) {
    throw UsageError(unknown_option_text(error.get_option_name(), all, command.name()));
  } catch (const po::error& error) {
    throw UsageError("{}; see rupture {} --help", error.what(), command.name());
  }
  return parsed;
}

std::string version_text(const std::string& tool) {
  return fmt::format("{} (rupture {}, commit {}, {})\n", tool, version, commit, kernels().name);
}

void set_parameters(const ParameterChanges& changes, Parameters& parameters) {
  for (const auto& [name, value, where] : changes) {
    try {
      set_parameter(parameters, name, value);
    } catch (const UsageError& error) {
      throw UsageError(where + error.what());
    }
  }
}

PhiShape shape_named(const std::string& name) {
  return name == "bell" ? PhiShape::bell : PhiShape::uniform;
}

void refuse_empty_names(const std::vector<std::string>& inputs) {
  if (std::ranges::count(inputs, "") == 0) return;
  throw UsageError("the name of an input is empty; give the path of a file");
}

std::string single_input(const po::variables_map& values, const std::string& positional,
                         const std::string& wanted) {
  if (values.count(positional) == 0) throw UsageError("no file was given: name " + wanted);
  const auto inputs = values[positional].as<std::vector<std::string>>();
  if (inputs.size() > 1) {
    std::ranges::for_each(inputs, refuse_part_of_value);
    throw UsageError("unexpected file '{}': give only one file", inputs[1]);
  }
  refuse_empty_names(inputs);
  return inputs.front();
}

int run_tool(const std::string& name, const std::function<int()>& body) {
  occupy_standard_streams();
  if (!has_memory()) {
    for (const char* const part : {name.c_str(), ": not enough memory\n"}) std::fputs(part, stderr);
    return kMachine;
  }
  std::signal(SIGPIPE, SIG_IGN);  // writing to a pipe that nobody reads only fails
  try {
    check_arithmetic();
    int code = kDone;
    try {
      code = body();
    } catch (const HelpRequested& help) {
      say("{}", help.text);
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      if (nobody_reads_output()) end_by_signal(SIGPIPE);
      return complain(name, "cannot write to standard output", kMachine);
    }
    return code;
  } catch (const Interrupted& interrupted) {
    complain(name, interrupted.message, kFailed);
    end_by_signal(interrupted.signal);
  } catch (const UsageError& error) {
    return complain(name, error.what(), kUsage);
  } catch (const std::bad_alloc&) {
    return complain(name, "not enough memory for a lattice of this size", kMachine);
  } catch (const MachineFailure& error) {
    return complain(name, error.what(), kMachine);
  } catch (const std::exception& error) {
    return complain(name, error.what(), kFailed);
  }
}

int run_tool(const Command& command, int argc, const char* const* argv) {
  return run_tool(std::string(command.name()),
                  [&] { return command.run(parse(command, argc, argv)); });
}

}  // namespace rupture::tools
