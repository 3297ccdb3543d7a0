// A run of load or restart with everything that it writes.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "run/alarms.hpp"
#include "run/observers.hpp"
#include "run/resume.hpp"
#include "run/summary.hpp"

namespace rupture::tools {

/// Whether to replace a checkpoint that is there already.
using IfCheckpointExists = std::function<IfExists(const std::filesystem::path&)>;

/// A run with everything that it writes on its way. The objects it is made with must outlive it.
class Run {
 public:
  Run(const Resumption& begin, const StopRule& rule, const RunFiles& files,
      IfCheckpointExists if_exists, IfExists if_record_exists, int threads,
      const OutputOptions& output);

  /// Runs; if that fails, what was sampled so far stays readable in the record's .part.
  Ending go(const StopRule& rule, const std::vector<std::int64_t>& checkpoint_steps,
            OnAlarm on_alarm);
  /// Writes the last checkpoint, then completes the record.
  void finish();
  /// Saves everything that resuming needs; returns the checkpoint.
  const std::filesystem::path& save_on_the_way();
  /// True once there is anything that was not there before.
  bool has_moved() const { return simulation_.state().step > first_step_; }
  /// What was done so far, once go() has ended.
  const RunSummary& summary() const { return summary_; }

 private:
  /// As it was before the first step.
  struct Beginning {
    std::int64_t step = 0;
    double time = 0.0;  // [s]
    Energies energies;
    std::chrono::steady_clock::time_point wall_clock;
  };

  void summarise(const Beginning& beginning, Ending ending);
  void take_last_samples();
  void save(const std::filesystem::path& path, IfExists if_exists);
  /// That of the record, if the run ends at `step`.
  std::vector<ProvenanceEntry> record_provenance(std::int64_t step) const;

  const RunFiles& files_;
  const IfCheckpointExists if_exists_;
  const std::int64_t first_step_;
  const OutputOptions& output_;
  const std::vector<ProvenanceEntry>& provenance_;
  const std::vector<ProvenanceEntry>& record_provenance_;
  std::filesystem::path saved_;  // the latest checkpoint
  RunSummary summary_;
  Simulation simulation_;
  std::unique_ptr<RecordWriter> writer_;
  std::unique_ptr<Recorder> recorder_;
  std::unique_ptr<FieldRecorder> field_recorder_;
};

}  // namespace rupture::tools
