// The outputs of programs that write files: their options, which files may be written, and what was
// done, in words or with --json.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/dynamics/energy.hpp"

namespace rupture::tools {

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

struct WrittenFile {
  std::filesystem::path path;
  std::string holds;     ///< "checkpoint" or "record"
  std::string checksum;  ///< of its content
};

/// "wrote x.h5  content-sha256 4f2c…", with the end of the line.
std::string wrote_text(const WrittenFile& file);

/// Of load and restart.
struct RunSummary {
  std::string ending;                   ///< in the words of kEndings, or "complete"
  double time = 0.0;                    ///< simulated, at the end [s]
  std::int64_t steps = 0;               ///< taken now, as is all that follows
  double simulated_time = 0.0;          ///< [s]
  double wall_time = 0.0;               ///< [s]
  EnergyBalance energy = {};            ///< [J]
  RunSoFar run = {};                    ///< since the run began, before an interruption too
  std::vector<WrittenFile> files = {};  ///< in their order
};

/// Of a run that was complete before: nothing was done.
RunSummary summary_of_complete(const Checkpoint& end);

Quantities quantities_of(const RunSummary& summary);

/// The rows, and one for the files that were written.
Quantities with_files(Quantities rows, const std::vector<WrittenFile>& files = {});

/// None for NaN and the infinities, which JSON does not have.
std::optional<double> if_finite(double value);

/// Prints them as one JSON object if the options ask for it.
void print_if_asked(const Quantities& rows, const OutputOptions& output);

// Of the programs that write one file:

/// Writes the output.
WrittenFile write(const Checkpoint& checkpoint, const OutputOptions& output);
WrittenFile write(FileKind kind, const Content& content, const OutputOptions& output);

/// Says what was done, in words unless they are unwanted, and as JSON if asked for; kDone.
int report(const Quantities& rows, const std::string& text, const WrittenFile& file,
           const OutputOptions& output);

}  // namespace rupture::tools
