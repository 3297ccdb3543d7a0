// Running a simulation from the command line: what load and restart have in common.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "alarms.hpp"
#include "command_line.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/dynamics/run.hpp"

namespace rupture::tools {

struct RunOptions {
  std::vector<double> checkpoint_at;       ///< [s]
  std::optional<double> checkpoint_every;  ///< [s]
  std::optional<std::filesystem::path> record;
  double record_every = 1e-4;  ///< [s]
  std::optional<int> threads;  ///< none: as many as pay
  OnAlarm on_alarm = OnAlarm::stop;
};

void add_run_options(po::options_description& options);
RunOptions run_options(const po::variables_map& values);

/// The step nearest to time t. Throws UsageError if it is not before step 2^53.
std::int64_t step_at(const Parameters& parameters, double t);

/// Runs `start` until the stop rule says so, writes everything asked for and prints the invariants.
/// Nothing is run if an output may not be written or would replace `input` (empty for none). The
/// provenance of `start` already names this tool.
void simulate(Checkpoint start, const StopRule& rule, const RunOptions& run,
              const OutputOptions& output, const std::filesystem::path& input);

}  // namespace rupture::tools
