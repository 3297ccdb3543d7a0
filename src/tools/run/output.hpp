// The programs that are one command each, and what they write them have in common: options, which
// files may be written, and what was done, in words or with --json.
#pragma once

#include "cli/command_line.hpp"
#include "cli/text.hpp"
#include "rupture/checkpoint/checkpoint.hpp"

namespace rupture::tools {

extern const Command load_command, restart_command, prepare_command, modify_phi_command,
    finish_command, seal_command, parameters_command;

/// Options of every tool that writes a file, which `holds` a checkpoint or record.
struct OutputOptions {
  std::filesystem::path output;
  std::vector<std::filesystem::path> inputs;  ///< that options name; no output may replace them
  IfExists if_exists = IfExists::refuse;
  bool is_quiet = false;  ///< no text but errors
  bool json = false;      ///< a summary on standard output

  /// Prints text at once, unless it is unwanted; on standard error if standard output is for JSON.
  template <class... Args>
  void say(fmt::format_string<Args...> format, Args&&... args) const {
    if (is_quiet) return;
    std::FILE* const to = json ? stderr : stdout;
    say_on(to, format, std::forward<Args>(args)...);
    std::fflush(to);
  }
};
void add_output_options(po::options_description& options, const std::string& holds);
void add_checkpoint_options(po::options_description& options);  ///< the same, of a checkpoint
OutputOptions output_options(const po::variables_map& values);

/// --from-alarm, of the tools that start from a checkpoint.
void add_start_options(po::options_description& options);
/// The checkpoint that a tool starts from. Throws Failure if it is that of an alarm, unless
/// --from-alarm was given and its numbers are finite; or if that was given and it is none.
Checkpoint read_start(const std::filesystem::path& path, const po::variables_map& values);

/// The file to write that an option names. Throws UsageError for "-", by which other programs mean
/// standard output.
std::filesystem::path file_to_write(const po::variables_map& values, const std::string& option);

/// Throws UsageError if two of the files have the same name, or one is an input,
/// which no tool ever changes: this one, or one that options name.
void check_distinct(const std::vector<std::filesystem::path>& files, const OutputOptions& output,
                    const std::filesystem::path& input);

/// Throws unless the output may be written: UsageError as check_distinct(), Failure as
/// check_output().
void check_output(const OutputOptions& output, const std::filesystem::path& input = {});

struct WrittenFile {
  std::filesystem::path path;
  std::string holds;     ///< "checkpoint" or "record"
  std::string checksum;  ///< of its content
};

/// Says "wrote x.h5  content-sha256 4f2c…".
void announce(const WrittenFile& file, const OutputOptions& output);

/// The rows, and one for the files that were written.
Quantities with_files(Quantities rows, const std::vector<WrittenFile>& files = {});

/// None for NaN and the infinities, which JSON does not have.
std::optional<double> if_finite(double value);

/// What a program does at its end that writes one file: writes the output, says what was done, in
/// words and as the options ask for it; kDone.
int write_and_report(FileKind kind, const Content& content, const Quantities& rows,
                     const std::string& text, const OutputOptions& output);

}  // namespace rupture::tools
