#include "run/observers.hpp"

#include <algorithm>
#include <span>

namespace rupture::tools {
namespace {

Sample sample_of(const Simulation& simulation) {
  const auto& state = simulation.state();
  Sample sample;
  sample.time = simulation.time();
  sample.step = state.step;
  sample.F_T = simulation.F_T();
  sample.x_drive = simulation.x_drive();
  for (const auto count : simulation.pinned()) {
    sample.pinned.push_back(static_cast<std::uint16_t>(count));
  }
  sample.p.assign(simulation.p().begin(), simulation.p().end());
  sample.tau.assign(simulation.tau().begin(), simulation.tau().end());
  sample.u_x.assign(state.u_x.row(0), state.u_x.row(0) + state.u_x.Nx());
  return sample;
}

std::vector<float> rounded(const Field& field) {
  const auto blocks = field.blocks();
  std::vector<float> values(static_cast<std::size_t>(blocks.size()));
  using Rounded = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::Map<Rounded>(values.data(), blocks.rows(), blocks.cols()) = blocks.cast<float>();
  return values;
}

}  // namespace

Sampler::Sampler(const Interval& every, std::int64_t now, std::int64_t last_step,
                 std::int64_t sampled)
    : every_(every),
      last_step_(last_step),
      sampled_(sampled),
      next_(sampled < 0 ? now : sample_after(now)) {}

std::int64_t Sampler::sample_after(std::int64_t step) const {
  const std::int64_t next = every_.after(step);
  return step < last_step_ ? std::min(next, last_step_) : next;
}

void Sampler::observe(const Simulation& simulation) {
  take(simulation);
  sampled_ = simulation.state().step;
  next_ = sample_after(sampled_);
}

void Sampler::finish(const Simulation& simulation) {
  if (sampled_ < simulation.state().step) observe(simulation);
}

Recorder::Recorder(RecordWriter& writer, const Interval& every, std::int64_t now,
                   std::int64_t last_step, std::int64_t sampled)
    : Sampler(every, now, last_step, sampled), writer_(writer) {}

void Recorder::append_ruptures(const Simulation& simulation) {
  const std::span<const Rupture> ruptures = simulation.ruptures();
  writer_.append(ruptures.subspan(ruptures_written_));
  ruptures_written_ = ruptures.size();
}

void Recorder::take(const Simulation& simulation) {
  append_ruptures(simulation);  // first, so that a .part has all ruptures up to its last sample
  writer_.append(sample_of(simulation));
}

void Recorder::sync(const Simulation& simulation) {
  append_ruptures(simulation);
  writer_.sync();
}

FieldRecorder::FieldRecorder(RecordWriter& writer, const Interval& every, std::int64_t now,
                             std::int64_t last_step, std::int64_t sampled)
    : Sampler(every, now, last_step, sampled), writer_(writer) {}

void FieldRecorder::take(const Simulation& simulation) {
  const State& state = simulation.state();
  writer_.append(
      FieldSample{simulation.time(), state.step, rounded(state.u_x), rounded(state.u_z)});
}

CheckpointSchedule::CheckpointSchedule(std::vector<std::int64_t> steps, Write write)
    : steps_(std::move(steps)), write_(std::move(write)) {}

std::int64_t CheckpointSchedule::next_step() const {
  return next_ < steps_.size() ? steps_[next_] : no_step;
}

void CheckpointSchedule::observe(const Simulation& simulation) {
  write_(simulation);
  ++next_;
}

}  // namespace rupture::tools
