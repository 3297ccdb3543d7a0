// How load and restart act on the findings of the guard (rupture/dynamics/guard.hpp).
#pragma once

#include <string>

#include "cli/command_line.hpp"
#include "rupture/dynamics/guard.hpp"
#include "rupture/dynamics/run.hpp"

namespace rupture::tools {

enum class OnAlarm { stop, report };

void add_alarm_option(po::options_description& options);

/// The choice of --on-alarm. Throws UsageError if it is no such word.
OnAlarm on_alarm(const po::variables_map& values);

/// Looks at the first and last step of a run and every 5000 steps. Warnings and, with
/// OnAlarm::report, alarms are printed on standard error; Verbosity::quiet silences warnings.
class Alarms : public Observer {
 public:
  Alarms(const Simulation& simulation, std::int64_t last_step, OnAlarm on_alarm,
         const OutputOptions& output, std::string tool);
  std::int64_t next_step() const override { return next_; }
  /// Throws Failure on an alarm, with OnAlarm::stop.
  void observe(const Simulation& simulation) override;

 private:
  Guard guard_;
  const std::int64_t last_step_;
  const OnAlarm on_alarm_;
  const Verbosity verbosity_;
  const std::string tool_;
  std::int64_t next_;
};

}  // namespace rupture::tools
