// The command line of all tools: parsing, --help, parameters, errors and exit codes.
#pragma once

#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/quantity.hpp"
#include "rupture/analysis/phi.hpp"
#include "rupture/checkpoint/file.hpp"
#include "rupture/model/parameters.hpp"
#include "rupture/model/phi_shape.hpp"

namespace rupture::tools {

/// Exit codes: 0 done, 1 failed, 2 usage.
enum ExitCode : int { kDone = 0, kFailed = 1, kUsage = 2 };

/// Thrown by parse() when --help, --describe or --version was given; holds the text for standard
/// output.
struct HelpRequested {
  std::string text;
};

/// A parameter that is given a value.
struct ParameterChange {
  std::string name, value;
  std::string where;  ///< "small.ini:3: ", for errors; empty on the command line
};

/// Parameter assignments in the order in which they apply.
using ParameterChanges = std::vector<ParameterChange>;

/// A parsed command line.
struct Parsed {
  po::variables_map values;
  ParameterChanges parameters;         ///< from --config, then from --set and --seed
  std::vector<std::string> arguments;  ///< argv, for the provenance
};

enum class UsesParameters { yes, no };

using AddOptions = void (*)(po::options_description&);

/// Everything about one program, or one command of analyze: --help, --describe, the man pages and
/// `analyze quantities` come from it.
struct Command {
  std::string_view name;          ///< such as "restart" or "analyze front"
  std::string_view arguments;     ///< in the synopsis, before [options]
  const char* input;              ///< kind of the positional arguments; empty: none are taken
  const char* summary;            ///< a line for lists of programs and commands
  const char* purpose;            ///< a sentence or two
  std::array<AddOptions, 4> own;  ///< options, in the order of --help
  int (*run)(const Parsed&);      ///< all of it but the parsing; returns the exit code
  Quantities (*quantities)() = nullptr;  ///< rows of what it reports, whatever their values
  UsesParameters uses_parameters = UsesParameters::no;
  std::array<const char*, 3> one_needed = {};  ///< options of which one must be given

  std::string synopsis() const;
};

/// Parses argv; positional arguments go to the option that is called as `input`. Touches no file
/// but the one --config names. Throws UsageError, Failure (unreadable --config) or HelpRequested.
Parsed parse(const Command& command, int argc, const char* const* argv);

/// The text of --version: the last word names the instruction set that the time steps use here.
std::string version_text(const std::string& tool);

/// Applies the changes one by one. Throws UsageError as set_parameter() does, with the place.
void apply(const ParameterChanges& changes, Parameters& parameters);

enum class Verbosity { normal, quiet };
enum class Summary { text, json };

/// Options of every tool that writes a file, which `holds` a checkpoint or record.
struct OutputOptions {
  std::filesystem::path output;
  IfExists if_exists = IfExists::refuse;
  Verbosity verbosity = Verbosity::normal;
  SumFile sum = SumFile::omit;
  Summary summary = Summary::text;

  /// Where text goes: standard output, unless that is for JSON.
  std::FILE* text() const { return summary == Summary::json ? stderr : stdout; }
};
void add_output_options(po::options_description& options, const std::string& holds);
void add_checkpoint_options(po::options_description& options);  ///< the same, of a checkpoint
OutputOptions output_options(const po::variables_map& values);

/// The file to write that an option names. Throws UsageError for "-", by which other programs mean
/// standard output.
std::filesystem::path file_to_write(const po::variables_map& values, const std::string& option);

/// Throws UsageError if two outputs, their .sum files included, have the same name or one is the
/// input, which no tool ever changes.
void check_distinct(const std::vector<std::filesystem::path>& outputs,
                    const std::filesystem::path& input);

/// Throws unless all outputs may be written: UsageError as check_distinct(), Failure as
/// check_output().
void check_outputs(const std::vector<std::filesystem::path>& outputs, IfExists if_exists,
                   const std::filesystem::path& input);

/// The shape that --shape names.
PhiShape shape_named(const std::string& name);

/// Throws UsageError unless the interface follows the reference law, for which alone there is
/// theory.
void refuse_other_laws(const Parameters& parameters);

/// Throws UsageError if one of them is empty.
void refuse_empty_names(const std::vector<std::string>& inputs);

/// The one positional argument. Throws UsageError, saying what is wanted, if there is none or more.
std::string single_input(const po::variables_map& values, const std::string& positional,
                         const std::string& wanted);

/// Runs a tool's body and turns exceptions into one line on standard error and an exit code. If the
/// reader of standard output goes away, the body goes on; then SIGPIPE ends the process.
int run_tool(const std::string& name, const std::function<int()>& body);

/// Runs a program that is one command.
int run_tool(const Command& command, int argc, const char* const* argv);

}  // namespace rupture::tools
