// The observers of a run: they record it, look for alarms (docs/guard.md) and show how far it is.
#pragma once

#include <chrono>

#include "run/plan.hpp"
#include "rupture/dynamics/condition.hpp"
#include "rupture/dynamics/guard.hpp"

namespace rupture::tools {

inline constexpr const char* kSeriesSteps = "/series/step";
inline constexpr const char* kFieldsSteps = "/fields/step";

/// The steps of the samples in these rows of a record; none if it lacks the dataset.
std::vector<std::int64_t> sampled_steps(const Content& rows, const std::string& path);

/// Appends to a record: ruptures, and samples of the series and of the fields that it has, each at
/// the first and last step of a run and whenever its interval has passed, or, while an event is
/// under way, the plan's interval in events. If only those that span count, the fields keep theirs,
/// and the writer holds the other samples until the event spans.
class Recorder : public Observer {
 public:
  Recorder(RecordWriter& writer, const RunPlan& plan);
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
  Sampler sampler(const Interval& every, const std::vector<std::int64_t>& sampled,
                  std::int64_t now) const;
  std::int64_t sample_after(std::int64_t step, const Interval& every) const;
  bool is_due(Sampler& sampler, std::int64_t step, bool in_event) const;
  bool looks_at_event(const Simulation& simulation);
  void append_ruptures(const Simulation& simulation);

  RecordWriter& writer_;
  const std::int64_t last_step_;
  Sampler series_;
  std::optional<Sampler> fields_;
  const std::optional<Interval> in_events_;
  const bool holds_;                  // what is sampled in events alone
  std::int64_t next_look_ = no_step;  // whether an event is under way
  std::size_t ruptures_written_ = 0;
};

/// Looks whether the condition of a run holds.
class Watch : public Observer {
 public:
  explicit Watch(const RunPlan& plan)
      : plan_(plan), next_(plan.looks->after(plan.begin.state.step - 1)) {}
  std::int64_t next_step() const override { return next_; }
  void observe(const Simulation& simulation) override {
    held = condition_.what_holds(simulation);
    next_ = plan_.looks->after(simulation.state().step);
  }

  std::string held = {};  ///< when it last looked; empty if nothing did

 private:
  const RunPlan& plan_;
  const Condition condition_{plan_.rule.early.condition, plan_.start.parameters};
  std::int64_t next_;
};

/// Looks at the first and last step of a run and every 5000 steps. Warnings and, with
/// --on-alarm report, alarms are printed on standard error; --quiet silences warnings.
class Alarms : public Observer {
 public:
  Alarms(const RunPlan& plan, const Simulation& simulation)
      : plan_(plan), guard_(simulation), next_(simulation.state().step) {}
  std::int64_t next_step() const override { return next_; }
  /// Throws Alarm on an alarm unless it is to be reported.
  void observe(const Simulation& simulation) override;

 private:
  const RunPlan& plan_;
  Guard guard_;
  std::int64_t next_;
};

/// Shows percentage, simulated time, steps/s and the time left: on a terminal in one line that is
/// written anew and never wider than it; elsewhere in a line per tenth of the run, but none within
/// five seconds of another or of the start. Of a run until quiet only the latest end is known.
class Progress : public Observer {
 public:
  explicit Progress(const RunPlan& plan);
  Progress& operator=(Progress&&) = delete;
  ~Progress() override;  ///< clears its line of a terminal
  std::int64_t next_step() const override { return next_; }
  void observe(const Simulation& simulation) override;

 private:
  using Clock = std::chrono::steady_clock;

  std::int64_t tenth_after(std::int64_t step) const;

  const RunPlan& plan_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point printed_ = start_;
  std::int64_t next_;
};

}  // namespace rupture::tools
