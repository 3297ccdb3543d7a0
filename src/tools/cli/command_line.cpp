#include "cli/command_line.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <new>
#include <set>
#include <sstream>

#include "cli/config_file.hpp"
#include "cli/interruption.hpp"
#include "cli/option_values.hpp"
#include "cli/report.hpp"
#include "cli/text.hpp"
#include "rupture/forces/kernels.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/laws.hpp"
#include "rupture/version.hpp"

namespace rupture::tools {
namespace {

po::options_description common_options(UsesParameters uses_parameters) {
  po::options_description common("Common options");
  auto add = common.add_options();
  if (uses_parameters == UsesParameters::yes) {
    add("config", input_file("options and parameters"),
        "INI file with options and parameters ([slider] L = 0.14 ...)");
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
  out << "Usage: rupture " << command.synopsis() << "\n\n" << command.purpose << "\n\n" << shown;
  if (command.uses_parameters == UsesParameters::yes) {
    out << "\nParameters for --set and --config: rupture parameters lists them, with units and "
           "defaults;\nrupture parameters NAME describes one.\n";
  }
  return out.str();
}

/// The exit code of a tool's body, or kDone after the help that was asked for.
int body_or_help(const std::function<int()>& body) {
  try {
    return body();
  } catch (const HelpRequested& help) {
    say("{}", help.text);
    return kDone;
  }
}

int complain(const std::string& name, const std::string& message, ExitCode code) {
  std::fflush(stdout);
  say_on(stderr, "{}: {}\n", name, in_one_line(message));
  return code;
}

}  // namespace

std::string Command::synopsis() const {
  return fmt::format("{}{}{} [options]", name, arguments.empty() ? "" : " ", arguments);
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
    po::store(given, parsed.values);
    if (parsed.values.count("help") > 0) {
      throw HelpRequested{help_text(command, shown)};
    }
    if (parsed.values.count("describe") > 0) {
      throw HelpRequested{json_text(description(command, shown)) + "\n"};
    }
    if (parsed.values.count("version") > 0) {
      throw HelpRequested{version_text(std::string(command.name))};
    }
    if (parsed.values.count("unexpected") > 0) {
      const auto words = parsed.values["unexpected"].as<std::vector<std::string>>();
      throw UsageError(
          fmt::format("unexpected argument '{}': {} reads no files; see rupture {} --help",
                      words.front(), command.name, command.name));
    }
    if (parsed.values.count("config") > 0) {
      parsed.parameters =
          read_config(parsed.values["config"].as<std::string>(), all, parsed.values);
    }
    po::notify(parsed.values);
    const auto changes = changes_by(given);
    parsed.parameters.insert(parsed.parameters.end(), changes.begin(), changes.end());
  } catch (const po::unknown_option& error) {
    throw UsageError(unknown_option_text(error.get_option_name(), all, command.name));
  } catch (const po::error& error) {
    throw UsageError(fmt::format("{}; see rupture {} --help", error.what(), command.name));
  }
  return parsed;
}

std::string version_text(const std::string& tool) {
  return fmt::format("{} (rupture {}, commit {}, {})\n", tool, version, commit, kernels().name);
}

void apply(const ParameterChanges& changes, Parameters& parameters) {
  for (const auto& [name, value, where] : changes) {
    try {
      set_parameter(parameters, name, value);
    } catch (const UsageError& error) {
      throw UsageError(where + error.what());
    }
  }
}

void add_output_options(po::options_description& options, const std::string& holds) {
  const std::string help = holds + " to write";
  options.add_options()("output,o", output_file(holds)->required(), help.c_str())(
      "force,f", "replace existing files")(
      "sum", "beside each file, write FILE.sum with its content checksum, for workflows")(
      "quiet,q", "print errors only")(
      "json", "print a summary as one JSON object; text goes to standard error");
}

void add_checkpoint_options(po::options_description& options) {
  add_output_options(options, "checkpoint");
}

OutputOptions output_options(const po::variables_map& values) {
  OutputOptions options;
  options.output = file_to_write(values, "output");
  if (values.count("force") > 0) options.if_exists = IfExists::replace;
  if (values.count("quiet") > 0) options.verbosity = Verbosity::quiet;
  if (values.count("sum") > 0) options.sum = SumFile::write;
  if (values.count("json") > 0) options.summary = Summary::json;
  return options;
}

std::filesystem::path file_to_write(const po::variables_map& values, const std::string& option) {
  const auto name = values[option].as<std::string>();
  if (name.empty()) throw UsageError("the name of an output is empty; give the path of a file");
  if (name != "-") return name;
  throw UsageError(fmt::format(
      "--{} needs the path of a file (got -): checkpoints and records cannot go to standard output",
      option));
}

void check_distinct(const std::vector<std::filesystem::path>& outputs,
                    const std::filesystem::path& input) {
  namespace fs = std::filesystem;
  std::map<fs::path, fs::path> folders;  // a run can have thousands of files in one
  const auto place = [&folders](const fs::path& path) {
    std::error_code ignored;  // is met again when the file is written
    if (fs::is_symlink(path, ignored)) return fs::weakly_canonical(fs::absolute(path));
    fs::path& folder = folders[path.parent_path()];
    if (folder.empty()) folder = fs::weakly_canonical(fs::absolute(path).parent_path());
    return folder / path.filename();
  };
  const fs::path place_of_input = input.empty() ? input : place(input);
  std::set<fs::path> taken;
  for (const fs::path& output : outputs) {
    for (const fs::path& file : {output, sum_path(output)}) {
      const fs::path place_of_file = place(file);
      if (place_of_file == place_of_input) {
        throw UsageError(fmt::format("{} is the input, which is never changed: give another output",
                                     file.string()));
      }
      if (taken.insert(place_of_file).second) continue;
      throw UsageError(
          fmt::format("two outputs would have the name {}: give different names", file.string()));
    }
  }
}

void check_outputs(const std::vector<std::filesystem::path>& outputs, IfExists if_exists,
                   const std::filesystem::path& input) {
  check_distinct(outputs, input);
  for (const auto& output : outputs) check_output(output, if_exists);
}

PhiShape shape_named(const std::string& name) {
  return name == "bell" ? PhiShape::bell : PhiShape::uniform;
}

void refuse_other_laws(const Parameters& p) {
  if (law_info(p.law).closed_form == ClosedForm::known) return;
  std::vector<std::string_view> known;
  for (const LawInfo& law : law_table()) {
    if (law.closed_form == ClosedForm::known) known.push_back(law.name);
  }
  throw UsageError(fmt::format("junctions.law = {} is not supported here: use the {} law",
                               law_info(p.law).name, fmt::join(known, " or the ")));
}

void refuse_empty_names(const std::vector<std::string>& inputs) {
  if (std::find(inputs.begin(), inputs.end(), "") == inputs.end()) return;
  throw UsageError("the name of an input is empty; give the path of a file");
}

std::string single_input(const po::variables_map& values, const std::string& positional,
                         const std::string& wanted) {
  if (values.count(positional) == 0) throw UsageError("no file was given: name " + wanted);
  const auto inputs = values[positional].as<std::vector<std::string>>();
  if (inputs.size() > 1) {
    throw UsageError(fmt::format("unexpected file '{}': give only one file", inputs[1]));
  }
  refuse_empty_names(inputs);
  return inputs.front();
}

int run_tool(const std::string& name, const std::function<int()>& body) {
  occupy_standard_streams();
  ignore_broken_pipes();
  try {
    const int code = body_or_help(body);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      if (nobody_reads_output()) end_by_signal(SIGPIPE);
      return complain(name, "cannot write to standard output", kFailed);
    }
    return code;
  } catch (const Interrupted& interrupted) {
    complain(name, interrupted.message, kFailed);
    end_by_signal(interrupted.signal);
  } catch (const UsageError& error) {
    return complain(name, error.what(), kUsage);
  } catch (const std::bad_alloc&) {
    return complain(name, "not enough memory for a lattice of this size", kFailed);
  } catch (const std::exception& error) {
    return complain(name, error.what(), kFailed);
  }
}

int run_tool(const Command& command, int argc, const char* const* argv) {
  return run_tool(std::string(command.name),
                  [&] { return command.run(parse(command, argc, argv)); });
}

}  // namespace rupture::tools
