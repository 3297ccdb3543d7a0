// The options that load and restart have in common, and the plan of a run that is made of them
// before it does anything: running it, --dry-run and --resume read this.
#pragma once

#include "run/output.hpp"
#include "run/steps.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/dynamics/run.hpp"

namespace rupture::tools {

/// A run that ends early takes at most this long if nothing else was given [s].
inline constexpr double kLongestRun = 10.0;

void add_early_end_options(po::options_description& options);
bool may_end_early(const po::variables_map& values);
/// The time that --until gives [s]; none if it was not typed, or gives a condition. Throws
/// UsageError.
std::optional<double> until_time(const po::variables_map& values);
/// Throws UsageError.
EarlyEnd early_end(const po::variables_map& values, const Parameters& parameters);

struct RunOptions {
  OutputOptions output = {};                    ///< its checkpoints on the way are OUT-tT.h5
  std::vector<double> checkpoint_at = {};       ///< [s]
  std::optional<double> checkpoint_every = {};  ///< [s]
  std::optional<std::filesystem::path> record = {};
  double record_every = 1e-4;               ///< [s]
  std::optional<double> in_events = {};     ///< while an event is under way [s]
  std::optional<double> in_spanning = {};   ///< while one is that spans, then or later [s]
  std::vector<double> crossings = {};       ///< pinned fractions, ascending
  std::optional<double> fields = {};        ///< sampling interval of the fields [s]
  std::optional<int> threads = {};          ///< none: as many as pay
  bool reports_alarms = false;              ///< instead of stopping at one
  bool resume = false;                      ///< continue from what the same run left, if any
  bool is_dry = false;                      ///< only say what the run would need
  std::vector<std::string> arguments = {};  ///< argv, from which the resuming command is made

  /// Whether to replace a record that is there already; that of another run was refused.
  IfExists if_record_exists() const { return resume ? IfExists::replace : output.if_exists; }
};

void add_run_options(po::options_description& options);  ///< with those of outputs
RunOptions run_options(const Parsed& parsed);

using Checkpoints = std::map<std::int64_t, std::filesystem::path>;  ///< by their steps

/// A run that has not begun. Its provenance already names the program that runs.
struct RunPlan {
  RunOptions options;
  StopRule rule;
  Checkpoint start;                      ///< where the whole run begins,
  Checkpoint begin;                      ///< and this part of it: the same unless it is resumed
  std::filesystem::path resumed_from;    ///< the file of `begin`; empty if the run begins
  RecordedRun recorded_run;              ///< by which its record is known
  Content recorded;                      ///< what that holds up to there
  Interval record_every;                 ///< if there is a record
  std::optional<Interval> fields_every;  ///< if that has fields
  std::optional<Interval> in_events;     ///< if it is denser then, or in those that span
  std::optional<Interval> looks;         ///< at the condition, if there is one
  Checkpoints checkpoints;               ///< on the way, that are still to come
  bool rewrites_output = false;          ///< which is there already, as this run will write it
  bool is_complete = false;              ///< and nothing is left to do
  int threads = 1;

  bool is_dense_only_if_spanning() const { return options.in_spanning.has_value(); }
  bool is_resumed() const { return !resumed_from.empty(); }
  const std::string& tool() const { return start.provenance.back().tool; }
};

/// Looks at what is there already, and writes nothing. `input` is the file that `start` comes from;
/// empty if it is an equilibrium. Throws UsageError or Failure if a
/// file would have to be replaced that is neither the run's nor may be.
RunPlan plan_run(Checkpoint start, const StopRule& rule, RunOptions options,
                 const std::filesystem::path& input);

/// Lets the plan begin at the newest checkpoint of the run that is intact, not beyond its end, and
/// that its record reaches, if there is one; it may be that of its end. Reads each file once.
/// Throws Failure if there is a record that is not this run's.
void find_run(RunPlan& plan);

/// Whether to replace a checkpoint that is there already: as things are now, the run's own or a
/// damaged one if it is resumed.
IfExists if_checkpoint_exists(const RunPlan& plan, const std::filesystem::path& path);

/// Steps, disk and time that what is left of the run needs: a few lines for people, or one JSON
/// object. The time is that of its steps, of which it takes some for half a second.
std::string forecast(const RunPlan& plan);

/// A slider near the equilibrium under its normal load, at once: uniformly compressed, with
/// unstretched junctions.
State roughly_loaded(const Parameters& parameters);

/// Runs what a plan of these says and prints the invariants. A dry one prints what that
/// would need instead, and writes nothing. Throws as plan_run(), or Interrupted if a signal came;
/// the run can then be resumed. Returns kDone.
int simulate(Checkpoint start, const StopRule& rule, const RunOptions& options,
             const std::filesystem::path& input);

Quantities run_quantities();

/// OUT.alarm.h5 beside OUT.h5, for the state at which an alarm stops the run.
std::filesystem::path alarm_path(const std::filesystem::path& output);

/// OUT-tT.h5 beside OUT.h5, for the checkpoint at time t [s].
std::filesystem::path path_at(const std::filesystem::path& output, double t);

/// Name of the run that begins with `start`: SHA-256 of which tool began it, from which content,
/// with which parameters and at which step. Every file of the run has it, resumed or not.
std::string id_of_run(const Checkpoint& start);

}  // namespace rupture::tools
