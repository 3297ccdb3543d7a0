// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

// Observers of a run: the record and the checkpoint schedule.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "run/interval.hpp"
#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/dynamics/run.hpp"

namespace rupture::tools {

/// Appends a sample to a record at the first and last step of a run and whenever `every` has
/// passed.
class Recorder : public Observer {
 public:
  /// `sampled`: the step of the last sample that the record has already; negative if it has none.
  Recorder(RecordWriter& writer, const Interval& every, std::int64_t now, std::int64_t last_step,
           std::int64_t sampled = -1);
  std::int64_t next_step() const override { return next_; }
  void observe(const Simulation& simulation) override;
  /// Brings the record to the disk as it is now.
  void sync(const Simulation& simulation);
  /// Takes the last sample if the run ended before `last_step`.
  void finish(const Simulation& simulation);

 private:
  void append_ruptures(const Simulation& simulation);
  std::int64_t sample_after(std::int64_t step) const;

  RecordWriter& writer_;
  const Interval every_;
  const std::int64_t last_step_;
  std::int64_t sampled_, next_;
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

}  // namespace rupture::tools
