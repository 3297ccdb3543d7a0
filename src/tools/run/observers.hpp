// The observers of a run: they record it, write its checkpoints, look for alarms (docs/guard.md)
// and show how far it is.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "run/files.hpp"
#include "run/output.hpp"
#include "rupture/dynamics/guard.hpp"
#include "rupture/dynamics/run.hpp"

namespace rupture::tools {

/// Appends to a record: ruptures, and samples of the series and of the fields that it has, each at
/// the first and last step of a run and whenever its interval has passed.
class Recorder : public Observer {
 public:
  /// `rows`: what the record holds already.
  Recorder(RecordWriter& writer, const RunFiles& files, const Content& rows, std::int64_t now,
           std::int64_t last_step);
  std::int64_t next_step() const override;
  void observe(const Simulation& simulation) override;
  /// Takes the last samples if the run ended before `last_step`.
  void finish(const Simulation& simulation);
  /// Brings the record to the disk as it is now.
  void sync(const Simulation& simulation);

 private:
  struct Sampler {
    Interval every;
    std::int64_t sampled;  // step of the last sample; negative if there is none
    std::int64_t next;
  };
  Sampler sampler(const Interval& every, std::int64_t sampled, std::int64_t now) const;
  std::int64_t sample_after(std::int64_t step, const Interval& every) const;
  bool is_due(Sampler& sampler, std::int64_t step) const;
  void append_ruptures(const Simulation& simulation);

  RecordWriter& writer_;
  const std::int64_t last_step_;
  Sampler series_;
  std::optional<Sampler> fields_;
  std::size_t ruptures_written_ = 0;
};

/// Writes checkpoints at given steps.
class CheckpointSchedule : public Observer {
 public:
  using Write = std::function<void(const Simulation&)>;
  /// `steps` in ascending order.
  CheckpointSchedule(std::vector<std::int64_t> steps, Write write);
  std::int64_t next_step() const override;
  void observe(const Simulation& simulation) override;

 private:
  std::vector<std::int64_t> steps_;
  std::size_t next_ = 0;
  Write write_;
};

enum class OnAlarm { stop, report };

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

/// Shows percentage, simulated time, steps/s and the time left: on a terminal in one line that is
/// written anew and never wider than it; elsewhere in a line per tenth of the run, but none within
/// five seconds of another or of the start. Of a run until quiet only the latest end is known.
class Progress : public Observer {
 public:
  Progress(const Simulation& simulation, const StopRule& rule, std::string tool);
  std::int64_t next_step() const override { return next_; }
  void observe(const Simulation& simulation) override;

 private:
  using Clock = std::chrono::steady_clock;

  void redraw(const Simulation& simulation, double rate);
  void print_tenth(const Simulation& simulation, double rate);
  std::int64_t tenth_after(std::int64_t step) const;

  const bool until_quiet_;
  const std::string tool_;
  const std::int64_t first_, last_;  // of the whole run
  const std::int64_t begin_;         // of this part of it
  const Clock::time_point start_;
  Clock::time_point printed_;
  std::int64_t next_;
};

/// Clears the line that Progress has drawn on a terminal, if it has, so that other words begin one.
void clear_progress_line();

}  // namespace rupture::tools
