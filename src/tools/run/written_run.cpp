// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

#include "run/written_run.hpp"

#include <fmt/core.h>

#include <chrono>
#include <utility>

#include "cli/text.hpp"
#include "run/progress.hpp"
#include "run/rebuild.hpp"
#include "rupture/dynamics/simulation.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

void announce(const OutputOptions& output, const fs::path& path, const std::string& checksum) {
  if (output.verbosity == Verbosity::normal) {
    say("{}", wrote_text(path, checksum));
    std::fflush(stdout);
  }
}

std::string_view reason(Ending ending) {
  switch (ending) {
    case Ending::quiet:
      return "no junction broke any more";
    case Ending::leading_edge:
      return "the front reached the leading edge";
    case Ending::interrupted:
      return "interrupted";
    case Ending::last_step:
      break;
  }
  return "end of the run";
}

void print_invariants(const Simulation& simulation, Ending ending, const EnergyBalance& balance,
                      std::int64_t steps, double seconds) {
  say("t = {:.7g} s ({}), {} steps", simulation.time(), reason(ending), steps);
  if (steps > 0 && seconds > 0.0) {
    say(", {:.0f} steps/s", static_cast<double>(steps) / seconds);
  }
  say("\nenergy [J]: supplied {:.6e} = stored {:.6e} + taken by damping {:.6e} + work against "
      "junctions {:.6e}, relative error {:.1e}\n",
      balance.supplied, balance.stored, balance.damping, balance.junctions,
      balance.relative_error());
}

void announce(const OutputOptions& output, const OnTheWay& written) {
  if (output.verbosity == Verbosity::quiet || written.count == 0) return;
  if (written.count == 1) {
    say("wrote 1 checkpoint on the way: {}\n", written.first.string());
  } else {
    say("wrote {} checkpoints on the way: {} ... {}\n", written.count, written.first.string(),
        written.last.string());
  }
}

}  // namespace

Run::Run(const Resumption& begin, std::int64_t last_step, const RunFiles& files,
         IfCheckpointExists if_exists, IfExists if_record_exists, int threads,
         const OutputOptions& output)
    : files_(files),
      if_exists_(std::move(if_exists)),
      first_step_(begin.checkpoint.state.step),
      output_(output),
      id_(begin.checkpoint.run_id),
      provenance_(begin.checkpoint.provenance),
      record_provenance_(begin.record_provenance),
      saved_(begin.file),
      simulation_(begin.checkpoint.parameters, begin.checkpoint.state, threads, files.crossings) {
  simulation_.resume_from(*begin.checkpoint.run);
  if (!files.record) return;
  writer_ = std::make_unique<RecordWriter>(*files.record, begin.checkpoint.parameters,
                                           record_provenance(last_step), if_record_exists,
                                           begin.rows, RecordWriter::kFlushEvery, files.crossings);
  recorder_ = std::make_unique<Recorder>(*writer_, files.record_every, begin.checkpoint.state.step,
                                         last_step, last_sample(begin.rows));
}

Ending Run::go(const StopRule& rule, const std::vector<std::int64_t>& checkpoint_steps,
               OnAlarm on_alarm) {
  Alarms alarms(simulation_, rule.last_step, on_alarm, output_, provenance_.back().tool);
  std::vector<Observer*> observers = {&alarms};
  if (recorder_) observers.push_back(recorder_.get());  // checkpoints include its sample
  CheckpointSchedule schedule(checkpoint_steps, [&](const Simulation& now) {
    alarms.observe(now);
    save_on_the_way();
  });
  observers.push_back(&schedule);
  Progress progress(simulation_, rule, provenance_.back().tool);
  if (output_.verbosity == Verbosity::normal) observers.push_back(&progress);

  const std::int64_t first = simulation_.state().step;
  const Energies before = simulation_.energies();
  const auto clock = std::chrono::steady_clock::now();
  try {
    const Ending ending = run(simulation_, rule, observers);
    alarms.observe(simulation_);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - clock;
    clear_progress_line();
    if (output_.verbosity == Verbosity::normal) {
      print_invariants(simulation_, ending,
                       energy_balance(before, simulation_.energies(), simulation_.work()),
                       simulation_.state().step - first, elapsed.count());
    }
    announce(output_, on_the_way_);
    return ending;
  } catch (...) {
    clear_progress_line();
    announce(output_, on_the_way_);
    if (writer_) writer_->flush();
    throw;
  }
}

void Run::finish() {
  if (recorder_) {
    recorder_->finish(simulation_);
    announce(output_, *files_.record,
             writer_->finish(record_provenance(simulation_.state().step), output_.sum));
  }
  announce(output_, files_.output, save(files_.output, output_.if_exists));
}

const fs::path& Run::save_on_the_way() {
  const fs::path path = path_at(files_.output, simulation_.time());
  if (path == saved_) return saved_;
  if (recorder_) recorder_->sync(simulation_);
  save(path, if_exists_(path));
  on_the_way_.add(path);
  return saved_;
}

std::vector<ProvenanceEntry> Run::record_provenance(std::int64_t step) const {
  return recorded_until(record_provenance_, simulation_.parameters(), simulation_.state().clock,
                        step, files_.record_every.steps, files_.crossings);
}

std::string Run::save(const fs::path& path, IfExists if_exists) {
  const Parameters& p = simulation_.parameters();
  const State& state = simulation_.state();
  const Checkpoint now = {
      p, state, run_until(provenance_, p, state.clock, state.step), simulation_.run(), {}, id_};
  std::string checksum = write_checkpoint(path, now, if_exists, output_.sum);
  saved_ = path;
  return checksum;
}

}  // namespace rupture::tools
