// The options that load and restart have in common, and the plan of a run that is made of them
// before it does anything: running it, --dry-run and --resume read this.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <vector>

#include "run/observers.hpp"
#include "run/output.hpp"
#include "run/resume.hpp"

namespace rupture::tools {

/// Whether to run, or only to say what the run would need, and how.
enum class DryRun { no, text, json };
/// Whether to go on with what the same run has left, if it was interrupted.
enum class Resume { no, yes };

struct RunOptions {
  OutputOptions output;
  std::vector<double> checkpoint_at;       ///< [s]
  std::optional<double> checkpoint_every;  ///< [s]
  std::optional<std::filesystem::path> record;
  double record_every = 1e-4;     ///< [s]
  std::vector<double> crossings;  ///< pinned fractions, ascending
  std::optional<double> fields;   ///< sampling interval of the fields [s]
  std::optional<int> threads;     ///< none: as many as pay
  OnAlarm on_alarm = OnAlarm::stop;
  Resume resume = Resume::no;
  DryRun dry_run = DryRun::no;
  std::vector<std::string> arguments;  ///< argv, of which the command that goes on is made
};

void add_run_options(po::options_description& options);  ///< with those of outputs
RunOptions run_options(const Parsed& parsed);

/// A run that has not begun. Its provenance already names the program that runs.
struct RunPlan {
  RunOptions options;
  Checkpoint start;  ///< where the whole run begins,
  Resumption begin;  ///< and where this part of it does, if it was interrupted: else the same
  StopRule rule;
  RunFiles files;
  std::vector<std::int64_t> checkpoint_steps;         ///< on the way, that are still to come
  std::vector<std::filesystem::path> written_before;  ///< files of the run that are there already
  std::set<std::filesystem::path> replaceable;        ///< checkpoints of the run, or damaged ones
  bool is_complete = false;                           ///< and nothing is left to do
  bool finds_equilibrium = false;                     ///< first, which costs something, too
  int threads = 1;

  bool is_resumed() const { return !begin.file.empty(); }
};

/// Looks at what is there already, and writes nothing. `input` is the file that `start` comes from;
/// empty if it is an equilibrium, which costs something, too. Throws UsageError or Failure if a
/// file would have to be replaced that is neither the run's nor may be.
RunPlan plan_run(Checkpoint start, const StopRule& rule, RunOptions options,
                 const std::filesystem::path& input);

/// Runs what a plan of these says and prints the invariants. With DryRun, prints what that would
/// need instead, and writes nothing. Throws as plan_run(), or Interrupted if a signal came; the run
/// can then be resumed. Returns kDone.
int simulate(Checkpoint start, const StopRule& rule, const RunOptions& options,
             const std::filesystem::path& input);

/// Whether to replace a checkpoint that is there already.
IfExists if_checkpoint_exists(const RunPlan& plan, const std::filesystem::path& path);

/// Whether to replace a record that is there already; that of another run was refused.
IfExists if_record_exists(const RunOptions& options);

}  // namespace rupture::tools
