#include "simulate.hpp"

#include <fmt/core.h>

#include <chrono>
#include <memory>

#include "interruption.hpp"
#include "observers.hpp"
#include "resume.hpp"
#include "rupture/model/error.hpp"
#include "text.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;

void announce(const OutputOptions& output, const fs::path& path, const std::string& checksum) {
  if (output.verbosity == Verbosity::normal) {
    say("wrote {}  sha256 {}\n", path.string(), checksum);
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
  say("\nenergy [J]: supplied {:.6e} = stored {:.6e} + dissipated {:.6e}, relative error {:.1e}\n",
      balance.supplied, balance.stored, balance.dissipated, balance.relative_error());
}

/// What a run begins with: `start`, or where it was interrupted.
Resumption beginning(Checkpoint start, const RunFiles& files, bool resume) {
  auto found = resume ? find_resumption(start, files) : std::nullopt;
  if (!found) return {std::move(start), {}, {}};
  ProvenanceEntry entry = start.provenance.back();
  entry.parent_checksum = found->checkpoint.checksum;
  found->checkpoint.provenance.push_back(std::move(entry));
  return std::move(*found);
}

/// True if the run has written its last checkpoint already, and the record before that.
bool is_complete(const Checkpoint& start, const StopRule& rule, const RunFiles& files) {
  if (!fs::exists(files.output) || (files.record && !fs::exists(*files.record))) return false;
  const Checkpoint end = read_checkpoint(files.output);
  return is_of_run(end, start) && ending_at(end.state.step, *end.run, rule);
}

/// The step of the last sample in these rows of a record; -1 if there is none.
std::int64_t last_sample(const Content& rows) {
  const auto found = rows.find("/series/step");
  if (found == rows.end() || found->second.bytes.empty()) return -1;
  return read_array<std::int64_t>(rows, found->first, found->second.shape).back();
}

/// A run with everything that it writes on its way.
class Run {
 public:
  Run(const Resumption& begin, std::int64_t last_step, const RunFiles& files,
      IfExists if_record_exists, std::optional<int> threads, const OutputOptions& output);

  /// Runs; if that fails, what was sampled so far stays readable in the record's .part.
  Ending go(const StopRule& rule, const std::vector<std::int64_t>& checkpoint_steps,
            OnAlarm on_alarm);
  /// Completes the record and writes the last checkpoint.
  void finish();
  /// Saves everything that resuming needs.
  void save_on_the_way();

 private:
  void save(const fs::path& path);

  const RunFiles& files_;
  const OutputOptions& output_;
  const std::vector<ProvenanceEntry>& provenance_;
  fs::path saved_;  // the latest checkpoint
  Simulation simulation_;
  std::unique_ptr<RecordWriter> writer_;
  std::unique_ptr<Recorder> recorder_;
};

Run::Run(const Resumption& begin, std::int64_t last_step, const RunFiles& files,
         IfExists if_record_exists, std::optional<int> threads, const OutputOptions& output)
    : files_(files),
      output_(output),
      provenance_(begin.checkpoint.provenance),
      saved_(begin.file),
      simulation_(begin.checkpoint.parameters, begin.checkpoint.state,
                  threads.value_or(threads_that_pay(begin.checkpoint.parameters))) {
  simulation_.take_up(*begin.checkpoint.run);
  if (!files.record) return;
  writer_ = std::make_unique<RecordWriter>(*files.record, begin.checkpoint.parameters, provenance_,
                                           if_record_exists, begin.rows);
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
  Progress progress(simulation_, rule.last_step);
  const bool show_progress = on_terminal() && output_.verbosity == Verbosity::normal;
  if (show_progress) observers.push_back(&progress);

  const std::int64_t first = simulation_.state().step;
  const Energies before = simulation_.energies();
  const auto clock = std::chrono::steady_clock::now();
  try {
    const Ending ending = run(simulation_, rule, observers);
    alarms.observe(simulation_);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - clock;
    if (show_progress) progress.finish();
    if (output_.verbosity == Verbosity::normal) {
      print_invariants(simulation_, ending,
                       energy_balance(before, simulation_.energies(), simulation_.work()),
                       simulation_.state().step - first, elapsed.count());
    }
    return ending;
  } catch (...) {
    if (writer_) writer_->flush();
    throw;
  }
}

void Run::finish() {
  if (recorder_) {
    recorder_->finish(simulation_);
    announce(output_, *files_.record, writer_->finish());
  }
  save(files_.output);
}

void Run::save_on_the_way() {
  const fs::path path = path_at(files_.output, simulation_.time());
  if (path == saved_) return;
  if (recorder_) recorder_->sync(simulation_);
  save(path);
}

void Run::save(const fs::path& path) {
  const Checkpoint now = {simulation_.parameters(), simulation_.state(), provenance_,
                          simulation_.run()};
  announce(output_, path, write_checkpoint(path, now, output_.if_exists));
  saved_ = path;
}

void check_run_outputs(const std::vector<std::int64_t>& steps, const RunFiles& files, double dt,
                       IfExists if_exists, IfExists if_record_exists, const fs::path& input) {
  std::vector<fs::path> outputs = {files.output};
  for (const std::int64_t step : steps) {
    outputs.push_back(path_at(files.output, static_cast<double>(step) * dt));
  }
  std::vector<fs::path> all = outputs;
  if (files.record) all.push_back(*files.record);
  check_distinct(all, input);
  for (const fs::path& path : outputs) check_output(path, if_exists);
  if (files.record) check_output(*files.record, if_record_exists);
}

void say_where_it_begins(const Resumption& begin) {
  if (begin.file.empty()) {
    say("nothing to resume: no checkpoint of this run was found\n");
  } else {
    say("resuming from {}\n", begin.file.string());
  }
}

}  // namespace

void simulate(Checkpoint start, StopRule rule, const RunOptions& options,
              const OutputOptions& output, const fs::path& input) {
  const Parameters p = start.parameters;
  const bool talk = output.verbosity == Verbosity::normal;
  const std::string command =
      start.provenance.back().command_line + (options.resume ? "" : " --resume");
  const RunFiles files = {output.output, options.record,
                          options.record ? sampling_steps(p, options) : 1};
  auto steps = checkpoint_steps(p, start.state.step, rule.last_step, options);
  start.run = {.first_step = start.state.step, .last_break = start.state.step};
  if (options.resume && is_complete(start, rule, files)) {
    if (talk) say("{} is complete\n", output.output.string());
    return;
  }
  const Resumption begin = beginning(std::move(start), files, options.resume);
  if (options.resume && talk) say_where_it_begins(begin);
  std::erase_if(steps, [&](std::int64_t step) { return step <= begin.checkpoint.state.step; });
  const IfExists if_record_exists = options.resume ? IfExists::replace : output.if_exists;
  check_run_outputs(steps, files, p.dt, output.if_exists, if_record_exists, input);

  const InterruptionNoted noted;
  rule.interrupted = [] { return InterruptionNoted::signal() != 0; };
  Run run(begin, rule.last_step, files, if_record_exists, options.threads, output);
  if (run.go(rule, steps, options.on_alarm) == Ending::interrupted) {
    run.save_on_the_way();
    throw Interrupted{InterruptionNoted::signal(),
                      fmt::format("interrupted, and saved; to go on: {}", command)};
  }
  run.finish();
}

}  // namespace rupture::tools
