// The files of a run: at which steps they are written, their names, and the commands that make them
// anew.
#pragma once

#include <cmath>

#include "cli/command_line.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/record.hpp"

namespace rupture::tools {

struct RunPlan;

/// The number of steps nearest to a duration [s]. Throws UsageError if it is not below 2^53.
std::int64_t steps_in(const Parameters& parameters, double duration);

/// The block nearest to `x` [m], the value of an option. Throws UsageError beyond the interface.
std::int64_t block_at(const Parameters& parameters, double x, const std::string& option);

/// The step nearest to time t [s]; throws as steps_in().
std::int64_t step_at(const Parameters& parameters, const Clock& clock, double t);

/// The steps nearest to the multiples of an interval of time. They are counted from t = 0, so that
/// split runs do it at the same steps.
struct Interval {
  double time = 1;        ///< the interval, at least dt [s]
  double dt = 1;          ///< [s]
  std::int64_t zero = 0;  ///< step nearest to t = 0 by the clock; below 0 if dt was longer before
  double offset = 0;      ///< t = 0 comes so much later than that step [steps]

  /// Step of the multiple with that number.
  std::int64_t step_of(std::int64_t number) const {
    return zero + std::llround(static_cast<double>(number) * time / dt + offset);
  }
  /// Number of the last such step that is not after `step`.
  std::int64_t number_at(std::int64_t step) const {
    const double passed = (static_cast<double>(step - zero) - offset) * dt;  // [s]
    const auto number = static_cast<std::int64_t>(passed / time);
    return step_of(number + 1) <= step ? number + 1 : number;
  }
  std::int64_t last_until(std::int64_t step) const { return step_of(number_at(step)); }
  /// The first such step after `step`.
  std::int64_t after(std::int64_t step) const { return step_of(number_at(step) + 1); }
  /// Samples from step `first` to `last`: at both, and at such steps between.
  std::int64_t samples(std::int64_t first, std::int64_t last) const {
    const bool extra_at_end = last > first && last != last_until(last);
    return 1 + number_at(last) - number_at(first) + (extra_at_end ? 1 : 0);
  }
};

/// The interval that `option` gives. Throws UsageError if it is shorter than a step.
Interval interval(const Parameters& parameters, const Clock& clock, double t,
                  std::string_view option);

/// OUT-tT.h5 beside OUT.h5, for the checkpoint at time t [s].
std::filesystem::path path_at(const std::filesystem::path& output, double t);

/// Name of the run that begins with `start`: SHA-256 of which tool began it, from which content,
/// with which parameters and at which step. Every file of the run has it, resumed or not.
std::string id_of_run(const Checkpoint& start);

/// By which its record is known.
RecordedRun recorded_run(const RunPlan& plan);

// The commands that make a file anew (ProvenanceEntry::rebuild) are complete, so that they need
// nothing but the parent, and canonical, so that equal content has equal commands. A command as a
// user types it is neither: it may name an INI file that has changed since, stop where the front
// happens to stop, or write several files at several times.

/// `tool` and --set NAME=VALUE for each parameter that is not what it was before: by default, or in
/// the parent. One that a law does not use counts as its default, as in the content checksum, so
/// that a parent of equal checksum will do.
std::vector<std::string> rebuild_command(const std::string& tool, const Parameters& before,
                                         const Parameters& parameters);

/// The command with all the tool's `own` options that have a value, defaults included. Their values
/// are numbers or texts, or they have none at all.
std::vector<std::string> with_options(std::vector<std::string> command, AddOptions add_own,
                                      const po::variables_map& values);

/// The chain of a checkpoint that a run writes at `step`. Its last entry, which names the run,
/// lacks only the time.
std::vector<ProvenanceEntry> run_until(std::vector<ProvenanceEntry> chain,
                                       const Parameters& parameters, const Clock& clock,
                                       std::int64_t step);

/// The chain of a record that ends with the samples it has: its last entry gets the time of the
/// last one instead of the planned one. Without a command it stays as it is.
std::vector<ProvenanceEntry> cut_at_end(const Record& record);

/// The chain of the run's record if that ends at `step`.
std::vector<ProvenanceEntry> recorded_until(const RunPlan& plan, std::int64_t step);

}  // namespace rupture::tools
