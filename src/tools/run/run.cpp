#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <optional>
#include <utility>

#include "cli/interruption.hpp"
#include "cli/text.hpp"
#include "run/forecast.hpp"
#include "run/observers.hpp"
#include "run/plan.hpp"
#include "rupture/analysis/front.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;
using std::chrono::steady_clock;

void announce(const OutputOptions& output, const WrittenFile& file) {
  if (output.verbosity == Verbosity::normal) {
    say_on(output.text(), "{}", wrote_text(file));
    std::fflush(output.text());
  }
}

/// How a run ended, in JSON and in the text, in the order of Ending.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kEndings = {
    {{"end", "end of the run"},
     {"quiet", "no more junctions broke"},
     {"spanned", "an event spanned the interface"},
     {"interrupted", "interrupted"}}};

const auto& words_for(Ending ending) {
  return kEndings.at(static_cast<std::size_t>(ending));
}

void print_invariants(std::FILE* to, Ending ending, const RunSummary& summary) {
  const EnergyBalance& balance = summary.energy;
  say_on(to, "t = {:.7g} s ({}), {} steps", summary.time, words_for(ending).second, summary.steps);
  if (summary.steps > 0 && summary.wall_time > 0.0) {
    say_on(to, ", {:.0f} steps/s", static_cast<double>(summary.steps) / summary.wall_time);
  }
  say_on(to,
         "\nenergy [J]: supplied {:.6e} = stored {:.6e} + damping {:.6e} + junctions {:.6e}, "
         "relative error {:.1e}\n",
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

/// Counts the events in a record that was just written, as analyze does by default.
void announce_events(const OutputOptions& output, const fs::path& path) {
  if (output.verbosity == Verbosity::quiet) return;
  const Record record = read_record(path);
  const Parameters& p = record.parameters;
  const auto events =
      find_events(p, record.ruptures, {record.time, record.F_T}, pause_between_events(p), {});
  const auto spanning =
      std::ranges::count_if(events, [](const Event& event) { return spans(event.front.type); });
  say_on(output.text(), "{} event{}, {} span{} the interface: rupture analyze events {}\n",
         events.size(), events.size() == 1 ? "" : "s", spanning, spanning == 1 ? "s" : "",
         shell_line({path.string()}));
}

/// A run with everything that it writes on its way. The objects it is made with must outlive it.
class Run {
 public:
  explicit Run(const RunPlan& plan)
      : plan_(plan),
        output_(plan.options.output),
        begin_(plan.begin.checkpoint),
        saved_(plan.begin.file),
        simulation_(begin_.parameters, begin_.state, plan.threads, plan.files.crossings) {
    simulation_.resume_from(*begin_.run);
    if (plan.files.record) begin_record();
  }

  /// Runs; if that fails, what was sampled so far stays readable in the record's .part.
  Ending go();
  /// Writes the last checkpoint, then completes the record.
  void finish();
  /// Saves everything that resuming needs; returns the checkpoint.
  const fs::path& save_on_the_way();
  /// True once there is anything that was not there before.
  bool has_moved() const { return simulation_.state().step > begin_.state.step; }
  /// What was done so far, once go() has ended.
  const RunSummary& summary() const { return summary_; }

 private:
  void begin_record();
  Ending observed();
  void summarise(const Energies& before, steady_clock::time_point begin, Ending ending);
  void save(const fs::path& path);
  /// That of the record, if the run ends at `step`.
  std::vector<ProvenanceEntry> record_provenance(std::int64_t step) const {
    return recorded_until(plan_.start.provenance, begin_.parameters, simulation_.state().clock,
                          step, plan_.files);
  }

  const RunPlan& plan_;
  const OutputOptions& output_;
  const Checkpoint& begin_;
  fs::path saved_;  // the latest checkpoint
  RunSummary summary_;
  Simulation simulation_;
  std::optional<RecordWriter> writer_;
  std::optional<Recorder> recorder_;
};

void Run::begin_record() {
  const RunFiles& files = plan_.files;
  const RecordParts parts = {files.crossings, files.fields_every ? Fields::record : Fields::omit,
                             recorded_run(begin_.run->id, files)};
  const std::int64_t last = plan_.rule.last_step;
  writer_.emplace(*files.record, begin_.parameters, record_provenance(last),
                  if_record_exists(plan_.options), plan_.begin.rows, RecordWriter::kFlushEvery,
                  parts);
  recorder_.emplace(*writer_, files, plan_.begin.rows, begin_.state.step, last);
}

/// With all observers, in the order in which they see a step.
Ending Run::observed() {
  const std::string& tool = begin_.provenance.back().tool;
  Alarms alarms(simulation_, plan_.rule.last_step, plan_.options.on_alarm, output_, tool);
  std::vector<Observer*> observers = {&alarms};
  if (recorder_) observers.push_back(&*recorder_);  // checkpoints include its sample
  CheckpointSchedule schedule(plan_.checkpoint_steps, [&](const Simulation& now) {
    alarms.observe(now);
    save_on_the_way();
  });
  observers.push_back(&schedule);
  Progress progress(simulation_, plan_.rule, tool);
  if (output_.verbosity == Verbosity::normal) observers.push_back(&progress);
  StopRule rule = plan_.rule;
  rule.interrupted = [] { return InterruptionNoted::signal() != 0; };
  const Ending ending = run(simulation_, rule, observers);
  alarms.observe(simulation_);
  return ending;
}

Ending Run::go() {
  const Energies before = simulation_.energies();
  const auto begin = steady_clock::now();
  try {
    const Ending ending = observed();
    clear_progress_line();
    summarise(before, begin, ending);
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

void Run::summarise(const Energies& before, steady_clock::time_point begin, Ending ending) {
  summary_.ending = words_for(ending).first;
  summary_.time = simulation_.time();
  summary_.steps = simulation_.state().step - begin_.state.step;
  summary_.simulated_time = summary_.time - time(begin_.parameters, begin_.state);
  summary_.wall_time = std::chrono::duration<double>(steady_clock::now() - begin).count();
  summary_.energy = energy_balance(before, simulation_.energies(), simulation_.work());
  summary_.run = simulation_.run();
}

void Run::finish() {
  std::exception_ptr failure;
  try {
    if (recorder_) recorder_->finish(simulation_);
    if (recorder_) recorder_->sync(simulation_);
  } catch (const Failure&) {
    failure = std::current_exception();  // the checkpoint needs no record
  }
  if (plan_.files.output != saved_) {
    save(plan_.files.output);
    announce(output_, summary_.files.back());
  }
  if (failure) std::rethrow_exception(failure);
  if (!recorder_) return;
  const auto checksum = writer_->finish(record_provenance(simulation_.state().step), output_.sum,
                                        simulation_.run().first_step);
  summary_.files.push_back({*plan_.files.record, "record", checksum});
  announce(output_, summary_.files.back());
  announce_events(output_, *plan_.files.record);
}

const fs::path& Run::save_on_the_way() {
  const fs::path path = path_at(plan_.files.output, simulation_.time());
  if (path == saved_) return saved_;
  if (recorder_) recorder_->sync(simulation_);
  save(path);
  return saved_;
}

void Run::save(const fs::path& path) {
  const Parameters& p = begin_.parameters;
  const State& state = simulation_.state();
  const Checkpoint now = {
      p, state, run_until(begin_.provenance, p, state.clock, state.step), simulation_.run(), {}};
  const auto checksum = write_checkpoint(path, now, if_checkpoint_exists(plan_, path), output_.sum);
  summary_.files.push_back({path, "checkpoint", checksum});
  saved_ = path;
}

/// Writes the .sum of each of these files that lacks it, if they are asked for: the part of the run
/// that wrote them was killed, or not asked for them. One that is there is that of its file.
void restore_sums(const std::vector<fs::path>& paths, const OutputOptions& output) {
  if (output.sum == SumFile::omit) return;
  for (const fs::path& path : paths) {
    if (fs::exists(path) && !fs::exists(sum_path(path))) restore_sum(path);
  }
}

/// The command that goes on with the run.
std::string resuming_command(const RunOptions& options) {
  auto arguments = options.arguments;
  if (options.resume == Resume::no) arguments.insert(arguments.begin() + 1, "--resume");
  return shell_line(arguments);
}

void say_where_it_begins(std::FILE* to, const RunPlan& plan) {
  if (plan.is_complete) {
    say_on(to, "{} is complete\n", in_one_line(plan.files.output.string()));
  } else if (plan.is_resumed()) {
    say_on(to, "resuming from {}\n", in_one_line(plan.begin.file.string()));
  } else {
    say_on(to, "nothing to resume from: starting from the beginning\n");
  }
}

/// Runs and writes what the plan says.
void carry_out(const RunPlan& plan) {
  const InterruptionNoted interruption;
  Run run(plan);
  const bool is_interrupted = run.go() == Ending::interrupted;
  std::string where = " at its first step";
  if (!is_interrupted) {
    run.finish();
  } else if (run.has_moved()) {
    where = fmt::format(", and saved as {}", run.save_on_the_way().string());
  }
  print_if_asked(quantities_of(run.summary()), plan.options.output);
  if (is_interrupted) {
    throw Interrupted{
        InterruptionNoted::signal(),
        fmt::format("interrupted{}; to continue: {}", where, resuming_command(plan.options))};
  }
  if (const int signal = InterruptionNoted::signal()) {
    throw Interrupted{signal, "interrupted after everything had been written"};
  }
}

}  // namespace

int simulate(Checkpoint start, const StopRule& rule, const RunOptions& options,
             const fs::path& input) {
  const RunPlan plan = plan_run(std::move(start), rule, options, input);
  const OutputOptions& output = options.output;
  const bool is_dry = options.dry_run != DryRun::no;
  if (options.resume == Resume::yes && output.verbosity == Verbosity::normal &&
      options.dry_run != DryRun::json && !(is_dry && plan.is_complete)) {
    say_where_it_begins(output.text(), plan);
  }
  if (is_dry) {
    say("{}", forecast(plan, options.dry_run));
    return kDone;
  }
  restore_sums(plan.written_before, output);
  if (plan.is_complete) {
    print_if_asked(quantities_of(summary_of_complete(plan.begin.checkpoint)), output);
  } else {
    carry_out(plan);
  }
  return kDone;
}

}  // namespace rupture::tools
