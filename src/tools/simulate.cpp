#include "simulate.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>

#include "interruption.hpp"
#include "observers.hpp"
#include "rebuild.hpp"
#include "resume.hpp"
#include "rupture/model/error.hpp"
#include "speed.hpp"
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
  say("\nenergy [J]: supplied {:.6e} = stored {:.6e} + taken by damping {:.6e} + work against "
      "junctions {:.6e}, relative error {:.1e}\n",
      balance.supplied, balance.stored, balance.damping, balance.junctions,
      balance.relative_error());
}

/// What a run begins with: `start`, or where it was interrupted.
Resumption beginning(Checkpoint start, const StopRule& rule, const RunFiles& files, bool resume) {
  auto chain = start.provenance;
  auto found = resume ? find_resumption(start, rule, files) : std::nullopt;
  if (!found) return {std::move(start), {}, {}, std::move(chain)};
  ProvenanceEntry entry = chain.back();
  entry.parent_checksum = found->checkpoint.checksum;
  entry.rebuild = "restart";
  found->checkpoint.provenance.push_back(std::move(entry));
  found->record_provenance = std::move(chain);
  return std::move(*found);
}

/// What to do if a checkpoint on the way is there already.
using IfCheckpointExists = std::function<IfExists(const fs::path&)>;

/// A run with everything that it writes on its way.
class Run {
 public:
  Run(const Resumption& begin, std::int64_t last_step, const RunFiles& files,
      IfCheckpointExists if_exists, IfExists if_record_exists, int threads,
      const OutputOptions& output);

  /// Runs; if that fails, what was sampled so far stays readable in the record's .part.
  Ending go(const StopRule& rule, const std::vector<std::int64_t>& checkpoint_steps,
            OnAlarm on_alarm);
  /// Completes the record and writes the last checkpoint.
  void finish();
  /// Saves everything that resuming needs.
  void save_on_the_way();
  /// True once there is anything that was not there before.
  bool has_moved() const { return simulation_.state().step > first_step_; }

 private:
  void save(const fs::path& path, IfExists if_exists);
  /// That of the record, if the run ends at `step`.
  std::vector<ProvenanceEntry> record_provenance(std::int64_t step) const;

  const RunFiles& files_;
  const IfCheckpointExists if_exists_;
  const std::int64_t first_step_;
  const OutputOptions& output_;
  const std::vector<ProvenanceEntry>& provenance_;
  const std::vector<ProvenanceEntry>& record_provenance_;
  fs::path saved_;  // the latest checkpoint
  Simulation simulation_;
  std::unique_ptr<RecordWriter> writer_;
  std::unique_ptr<Recorder> recorder_;
};

Run::Run(const Resumption& begin, std::int64_t last_step, const RunFiles& files,
         IfCheckpointExists if_exists, IfExists if_record_exists, int threads,
         const OutputOptions& output)
    : files_(files),
      if_exists_(std::move(if_exists)),
      first_step_(begin.checkpoint.state.step),
      output_(output),
      provenance_(begin.checkpoint.provenance),
      record_provenance_(begin.record_provenance),
      saved_(begin.file),
      simulation_(begin.checkpoint.parameters, begin.checkpoint.state, threads) {
  simulation_.take_up(*begin.checkpoint.run);
  if (!files.record) return;
  writer_ =
      std::make_unique<RecordWriter>(*files.record, begin.checkpoint.parameters,
                                     record_provenance(last_step), if_record_exists, begin.rows);
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
    announce(output_, *files_.record, writer_->finish(record_provenance(simulation_.state().step)));
  }
  save(files_.output, output_.if_exists);
}

void Run::save_on_the_way() {
  const fs::path path = path_at(files_.output, simulation_.time());
  if (path == saved_) return;
  if (recorder_) recorder_->sync(simulation_);
  save(path, if_exists_(path));
}

std::vector<ProvenanceEntry> Run::record_provenance(std::int64_t step) const {
  return recorded_until(record_provenance_, simulation_.parameters(), step, files_.record_every);
}

void Run::save(const fs::path& path, IfExists if_exists) {
  const Parameters& p = simulation_.parameters();
  const State& state = simulation_.state();
  const Checkpoint now = {p, state, run_until(provenance_, p, state.step), simulation_.run()};
  announce(output_, path, write_checkpoint(path, now, if_exists));
  saved_ = path;
}

void check_run_outputs(const std::vector<std::int64_t>& steps, const RunFiles& files,
                       const Parameters& p, IfExists if_output_exists,
                       const IfCheckpointExists& if_exists, IfExists if_record_exists,
                       const fs::path& input) {
  std::vector<fs::path> on_the_way;
  on_the_way.reserve(steps.size());
  for (const std::int64_t step : steps) {
    on_the_way.push_back(path_at(files.output, static_cast<double>(step) * p.dt));
  }
  std::vector<fs::path> all = on_the_way;
  all.push_back(files.output);
  if (files.record) all.push_back(*files.record);
  check_distinct(all, input);
  check_output(files.output, if_output_exists);
  for (const fs::path& path : on_the_way) check_output(path, if_exists(path));
  if (files.record) check_record(*files.record, p, if_record_exists);
}

/// The command that goes on with the run. What follows " -- " are files.
std::string resuming_command(const Checkpoint& start, bool resume) {
  std::string command = start.provenance.back().command_line;
  if (!resume) command.insert(std::min(command.find(" -- "), command.size()), " --resume");
  return command;
}

void say_where_it_begins(const Resumption& begin) {
  if (begin.file.empty()) {
    say("nothing to resume from: the run begins anew\n");
  } else {
    say("resuming from {}\n", begin.file.string());
  }
}

/// Prints what a run needs that does this and takes its steps from `state`.
void print_forecast(const Workload& work, const State& state, DryRun how) {
  const Forecast needs = forecast(work, measure_speed(work, state));
  say("{}", how == DryRun::json ? json_text(json_of(needs)) + "\n" : text_of(needs));
}

}  // namespace

void simulate(Checkpoint start, StopRule rule, const RunOptions& options,
              const OutputOptions& output, const fs::path& input) {
  const Parameters p = start.parameters;
  const bool talk = output.verbosity == Verbosity::normal;
  const std::string command = resuming_command(start, options.resume);
  const RunFiles files = {output.output, options.record,
                          options.record ? sampling_steps(p, options) : 1, output.if_exists};
  auto steps = checkpoint_steps(p, start.state.step, rule.last_step, options);
  start.run = {.first_step = start.state.step, .last_break = start.state.step};
  const bool dry = options.dry_run != DryRun::no;
  // Nothing is left to do unless it is found below that there is.
  Workload work = {.parameters = p,
                   .start = input.empty() ? Start::equilibrium : Start::checkpoint,
                   .first_step = rule.last_step,
                   .last_step = rule.last_step,
                   .threads = options.threads.value_or(threads_that_pay(p))};
  if (options.resume && is_complete(start, rule, files)) {
    if (dry) return print_forecast(work, start.state, options.dry_run);
    restore_sum(files.output);
    if (talk) say("{} is complete\n", output.output.string());
    return;
  }
  const auto if_exists = [&](const fs::path& path) {
    return options.resume && may_write(path, start) ? IfExists::replace : output.if_exists;
  };
  const Resumption begin = beginning(start, rule, files, options.resume);
  if (options.resume && talk && options.dry_run != DryRun::json) say_where_it_begins(begin);
  if (!begin.file.empty()) {  // what lies before was written already
    std::erase_if(steps, [&](std::int64_t step) { return step <= begin.checkpoint.state.step; });
  }
  const IfExists if_record_exists = options.resume ? IfExists::replace : output.if_exists;
  check_run_outputs(steps, files, p, output.if_exists, if_exists, if_record_exists, input);

  if (dry) {
    work.first_step = begin.checkpoint.state.step;
    work.end = rule.quiet_steps ? End::at_the_latest : End::known;
    work.checkpoints = static_cast<std::int64_t>(steps.size()) + 1;
    if (files.record) {
      work.samples = sample_count(start.run->first_step, rule.last_step, files.record_every);
    }
    return print_forecast(work, begin.checkpoint.state, options.dry_run);
  }
  if (!begin.file.empty()) restore_sum(begin.file);

  const InterruptionNoted noted;
  rule.interrupted = [] { return InterruptionNoted::signal() != 0; };
  Run run(begin, rule.last_step, files, if_exists, if_record_exists, work.threads, output);
  if (run.go(rule, steps, options.on_alarm) == Ending::interrupted) {
    if (run.has_moved()) run.save_on_the_way();
    throw Interrupted{InterruptionNoted::signal(),
                      fmt::format("interrupted{}; to go on: {}",
                                  run.has_moved() ? ", and saved" : " at its first step", command)};
  }
  run.finish();
  if (const int signal = InterruptionNoted::signal()) {
    throw Interrupted{signal, "interrupted when everything was done and written"};
  }
}

}  // namespace rupture::tools
