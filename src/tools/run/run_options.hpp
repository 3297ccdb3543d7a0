// The options that load and restart have in common: how long, and what to write on the way.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "cli/command_line.hpp"
#include "run/alarms.hpp"
#include "run/interval.hpp"
#include "rupture/model/state.hpp"

namespace rupture::tools {

/// Whether to run, or only to say what the run would need, and how.
enum class DryRun { no, text, json };
/// Whether to go on with what the same run has left, if it was interrupted.
enum class Resume { no, yes };

struct RunOptions {
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

void add_run_options(po::options_description& options);
RunOptions run_options(const Parsed& parsed);

/// The step nearest to time t [s]. Throws UsageError if it is not before step 2^53.
std::int64_t step_at(const Parameters& parameters, const Clock& clock, double t);

/// The number of steps nearest to a duration [s]; throws as step_at().
std::int64_t steps_in(const Parameters& parameters, double duration);

/// The steps in a run from `first` to `last` at which checkpoints are wanted, in order. Throws
/// UsageError if one is outside.
std::vector<std::int64_t> checkpoint_steps(const Parameters& parameters, const State& first,
                                           std::int64_t last, const RunOptions& run);

/// When to sample for the record. Throws UsageError if that is more than once per step.
Interval sampling_interval(const Parameters& parameters, const Clock& clock, const RunOptions& run);

/// The same for the fields, if they are recorded.
std::optional<Interval> fields_interval(const Parameters& parameters, const Clock& clock,
                                        const RunOptions& run);

}  // namespace rupture::tools
