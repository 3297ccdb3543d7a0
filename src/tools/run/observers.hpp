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

/// Takes a sample at the first and last step of a run and whenever `every` has passed.
class Sampler : public Observer {
 public:
  /// `sampled`: the step of the last sample that there is already; negative if there is none.
  Sampler(const Interval& every, std::int64_t now, std::int64_t last_step, std::int64_t sampled);
  std::int64_t next_step() const override { return next_; }
  void observe(const Simulation& simulation) override;
  /// Takes the last sample if the run ended before `last_step`.
  void finish(const Simulation& simulation);

 private:
  virtual void take(const Simulation& simulation) = 0;
  std::int64_t sample_after(std::int64_t step) const;

  const Interval every_;
  const std::int64_t last_step_;
  std::int64_t sampled_, next_;
};

/// Appends to the series of a record, and ruptures.
class Recorder : public Sampler {
 public:
  Recorder(RecordWriter& writer, const Interval& every, std::int64_t now, std::int64_t last_step,
           std::int64_t sampled = -1);
  /// Brings the record to the disk as it is now.
  void sync(const Simulation& simulation);

 private:
  void take(const Simulation& simulation) override;
  void append_ruptures(const Simulation& simulation);

  RecordWriter& writer_;
  std::size_t ruptures_written_ = 0;
};

/// Appends to the fields of a record.
class FieldRecorder : public Sampler {
 public:
  FieldRecorder(RecordWriter& writer, const Interval& every, std::int64_t now,
                std::int64_t last_step, std::int64_t sampled = -1);

 private:
  void take(const Simulation& simulation) override;

  RecordWriter& writer_;
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
