// The command line of all tools: parsing, --help, parameters, errors and exit codes.
#pragma once

#include <array>

#include "cli/quantity.hpp"
#include "rupture/model/parameters.hpp"
#include "rupture/model/phi_shape.hpp"

namespace rupture::tools {

enum ExitCode : int { kDone = 0, kFailed = 1, kUsage = 2, kMachine = 3 };

/// Thrown by parse() when --help, --describe or --version was given; holds the text for standard
/// output.
struct HelpRequested {
  std::string text;
};

struct ParameterChange {
  std::string name, value;
  std::string where;  ///< "small.ini:3: ", for errors; empty on the command line
};

/// Parameter assignments in the order in which they apply.
using ParameterChanges = std::vector<ParameterChange>;

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
  std::string_view call;          ///< "analyze front RECORD": its name in small letters, arguments
  const char* input;              ///< kind of the positional arguments; empty: none are taken
  const char* summary;            ///< a line for lists of programs and commands
  const char* purpose;            ///< a sentence or two
  std::array<AddOptions, 4> own;  ///< options, in the order of --help
  int (*run)(const Parsed&);      ///< all of it but the parsing; returns the exit code
  Quantities (*quantities)() = nullptr;  ///< rows of what it reports, whatever their values
  UsesParameters uses_parameters = UsesParameters::no;
  std::array<const char*, 5> one_needed = {};  ///< options of which one must be given

  std::string_view name() const;
  std::string synopsis() const { return std::string(call) + " [options]"; }
};

/// Parses argv; positional arguments go to the option that is called as `input`. Touches no file
/// but the one --config names. Throws UsageError, Failure (unreadable --config) or HelpRequested.
Parsed parse(const Command& command, int argc, const char* const* argv);

/// The text of --version: the last word names the instruction set that the time steps use here.
std::string version_text(const std::string& tool);

/// Applies the changes one by one. Throws UsageError as set_parameter() does, with the place.
void set_parameters(const ParameterChanges& changes, Parameters& parameters);

PhiShape shape_named(const std::string& name);

void refuse_empty_names(const std::vector<std::string>& inputs);

/// The one positional argument. Throws UsageError, saying what is wanted, if there is none or more.
std::string single_input(const po::variables_map& values, const std::string& positional,
                         const std::string& wanted);

/// Runs a tool's body and turns exceptions into one line on standard error and an exit code. If the
/// reader of standard output goes away, the body continues; then SIGPIPE ends the process.
int run_tool(const std::string& name, const std::function<int()>& body);

int run_tool(const Command& command, int argc, const char* const* argv);

}  // namespace rupture::tools
