#include "run/written_run.hpp"

#include <fmt/core.h>

#include <chrono>
#include <exception>
#include <utility>

#include "cli/text.hpp"
#include "run/progress.hpp"
#include "run/rebuild.hpp"
#include "rupture/dynamics/simulation.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

void announce(const OutputOptions& output, const WrittenFile& file) {
  if (output.verbosity == Verbosity::normal) {
    say_on(output.text(), "{}", wrote_text(file.path, file.checksum));
    std::fflush(output.text());
  }
}

std::string_view reason(Ending ending) {
  switch (ending) {
    case Ending::quiet:
      return "no junction broke any more";
    case Ending::spanned:
      return "an event spanned the interface";
    case Ending::interrupted:
      return "interrupted";
    case Ending::last_step:
      break;
  }
  return "end of the run";
}

void print_invariants(std::FILE* to, Ending ending, const RunSummary& summary) {
  const EnergyBalance& balance = summary.energy;
  say_on(to, "t = {:.7g} s ({}), {} steps", summary.time, reason(ending), summary.steps);
  if (summary.steps > 0 && summary.wall_time > 0.0) {
    say_on(to, ", {:.0f} steps/s", static_cast<double>(summary.steps) / summary.wall_time);
  }
  say_on(to,
         "\nenergy [J]: supplied {:.6e} = stored {:.6e} + taken by damping {:.6e} + work against "
         "junctions {:.6e}, relative error {:.1e}\n",
         balance.supplied, balance.stored, balance.damping, balance.junctions,
         balance.relative_error());
}

/// Checkpoints on the way, of which there may be many: one line names them.
void announce(const OutputOptions& output, const std::vector<WrittenFile>& on_the_way) {
  if (output.verbosity == Verbosity::quiet || on_the_way.empty()) return;
  const std::string first = in_one_line(on_the_way.front().path);
  const std::string last = in_one_line(on_the_way.back().path);
  if (on_the_way.size() == 1) {
    say_on(output.text(), "wrote 1 checkpoint on the way: {}\n", first);
  } else {
    say_on(output.text(), "wrote {} checkpoints on the way: {} ... {}\n", on_the_way.size(), first,
           last);
  }
}

RecordParts parts_of(const RunFiles& files, const Checkpoint& begin) {
  return {files.crossings, files.fields_every ? Fields::record : Fields::omit,
          recorded_run(begin, files)};
}

RunSoFar with_rule(RunSoFar run, const StopRule& rule) {
  run.quiet_steps = rule.quiet_steps;
  run.arrived_below = rule.arrived_below;
  return run;
}

}  // namespace

Run::Run(const Resumption& begin, const StopRule& rule, const RunFiles& files,
         IfCheckpointExists if_exists, IfExists if_record_exists, int threads,
         const OutputOptions& output)
    : files_(files),
      if_exists_(std::move(if_exists)),
      first_step_(begin.checkpoint.state.step),
      output_(output),
      provenance_(begin.checkpoint.provenance),
      record_provenance_(begin.record_provenance),
      saved_(begin.file),
      simulation_(begin.checkpoint.parameters, begin.checkpoint.state, threads, files.crossings) {
  simulation_.resume_from(with_rule(*begin.checkpoint.run, rule));
  if (!files.record) return;
  writer_ = std::make_unique<RecordWriter>(
      *files.record, begin.checkpoint.parameters, record_provenance(rule.last_step),
      if_record_exists, begin.rows, RecordWriter::kFlushEvery, parts_of(files, begin.checkpoint));
  const std::int64_t now = begin.checkpoint.state.step;
  recorder_ = std::make_unique<Recorder>(*writer_, files.record_every, now, rule.last_step,
                                         last_sample(begin.rows, kSeriesGroup));
  if (!files.fields_every) return;
  field_recorder_ = std::make_unique<FieldRecorder>(
      *writer_, *files.fields_every, now, rule.last_step, last_sample(begin.rows, kFieldsGroup));
}

Ending Run::go(const StopRule& rule, const std::vector<std::int64_t>& checkpoint_steps,
               OnAlarm on_alarm) {
  Alarms alarms(simulation_, rule.last_step, on_alarm, output_, provenance_.back().tool);
  std::vector<Observer*> observers = {&alarms};
  if (recorder_) observers.push_back(recorder_.get());  // checkpoints include its sample
  if (field_recorder_) observers.push_back(field_recorder_.get());
  CheckpointSchedule schedule(checkpoint_steps, [&](const Simulation& now) {
    alarms.observe(now);
    save_on_the_way();
  });
  observers.push_back(&schedule);
  Progress progress(simulation_, rule, provenance_.back().tool);
  if (output_.verbosity == Verbosity::normal) observers.push_back(&progress);

  const Beginning beginning = {simulation_.state().step, simulation_.time(), simulation_.energies(),
                               std::chrono::steady_clock::now()};
  try {
    const Ending ending = run(simulation_, rule, observers);
    alarms.observe(simulation_);
    clear_progress_line();
    summarise(beginning, ending);
    if (output_.verbosity == Verbosity::normal) print_invariants(output_.text(), ending, summary_);
    announce(output_, summary_.files);
    return ending;
  } catch (...) {
    clear_progress_line();
    announce(output_, summary_.files);
    if (writer_) writer_->flush();
    throw;
  }
}

void Run::summarise(const Beginning& beginning, Ending ending) {
  const std::chrono::duration<double> elapsed =
      std::chrono::steady_clock::now() - beginning.wall_clock;
  summary_.ending = name_of(ending);
  summary_.time = simulation_.time();
  summary_.steps = simulation_.state().step - beginning.step;
  summary_.simulated_time = summary_.time - beginning.time;
  summary_.wall_time = elapsed.count();
  summary_.energy = energy_balance(beginning.energies, simulation_.energies(), simulation_.work());
  summary_.run = simulation_.run();
}

void Run::finish() {
  std::exception_ptr failure;
  try {
    take_last_samples();
  } catch (const Failure&) {
    failure = std::current_exception();  // the checkpoint needs no record
  }
  if (files_.output != saved_) {
    save(files_.output, if_exists_(files_.output));
    announce(output_, summary_.files.back());
  }
  if (failure) std::rethrow_exception(failure);
  if (!recorder_) return;
  const auto provenance = record_provenance(simulation_.state().step);
  const auto checksum = writer_->finish(provenance, output_.sum, simulation_.run().first_step);
  summary_.files.push_back({*files_.record, "record", checksum});
  announce(output_, summary_.files.back());
}

void Run::take_last_samples() {
  if (!recorder_) return;
  recorder_->finish(simulation_);
  if (field_recorder_) field_recorder_->finish(simulation_);
  recorder_->sync(simulation_);
}

const fs::path& Run::save_on_the_way() {
  const fs::path path = path_at(files_.output, simulation_.time());
  if (path == saved_) return saved_;
  if (recorder_) recorder_->sync(simulation_);
  save(path, if_exists_(path));
  return saved_;
}

std::vector<ProvenanceEntry> Run::record_provenance(std::int64_t step) const {
  return recorded_until(record_provenance_, simulation_.parameters(), simulation_.state().clock,
                        step, files_);
}

void Run::save(const fs::path& path, IfExists if_exists) {
  const Parameters& p = simulation_.parameters();
  const State& state = simulation_.state();
  const Checkpoint now = {
      p, state, run_until(provenance_, p, state.clock, state.step), simulation_.run(), {}};
  const auto checksum = write_checkpoint(path, now, if_exists, output_.sum);
  summary_.files.push_back({path, "checkpoint", checksum});
  saved_ = path;
}

}  // namespace rupture::tools
