
#include <algorithm>
#include <exception>

#include "cli/interruption.hpp"
#include "run/observers.hpp"
#include "run/rebuild.hpp"
#include "rupture/analysis/front.hpp"

namespace rupture::tools {
namespace {

namespace fs = std::filesystem;
using std::chrono::steady_clock;

struct RunSummary {
  std::string ending;                   ///< in the words of kEndings, or "complete"
  std::string held = {};                ///< the part of the condition that ended it
  double time = 0.0;                    ///< simulated, at the end [s]
  std::int64_t steps = 0;               ///< taken now, as is all that follows
  double simulated_time = 0.0;          ///< [s]
  double wall_time = 0.0;               ///< [s]
  EnergyBalance energy = {};            ///< [J]
  RunSoFar run = {};                    ///< since the run began, before an interruption too
  std::vector<WrittenFile> files = {};  ///< in their order
};

Quantities quantities_of(const RunSummary& s) {
  const EnergyBalance& energy = s.energy;
  const Quantities account = {
      {"supplied", "J", "work of the driving point and of the load", energy.supplied},
      {"stored", "J", "gain of kinetic and elastic energy", energy.stored},
      {"damping", "J", "energy taken by damping", energy.damping},
      {"junctions", "J", "work done against the junctions", energy.junctions},
      {"relative_error", "1", "error, relative to the largest term", energy.relative_error()},
  };
  const Quantities rows = {
      {"ending", "",
       "end, quiet, spanned (an event did), ruptured (the block did), condition (that of --until "
       "held), rest (nothing more will rupture), interrupted, or complete (nothing was left to do)",
       s.ending},
      {"held", "", "the part of the condition of --until that held, with its values",
       if_known(!s.held.empty(), s.held)},
      {"time", "s", "simulated time at the end", s.time},
      {"steps", "1", "time steps taken", s.steps},
      {"simulated_time", "s", "simulated time of these steps", s.simulated_time},
      {"wall_time", "s", "wall-clock time of these steps", s.wall_time},
      {"ruptures", "1", "block ruptures since the run began, also before an interruption",
       s.run.ruptures},
      {"leading_edge_ruptured", "", "whether the block at the leading edge was among them",
       s.run.leading_edge_ruptured},
      {"energy", "", "energy account of these steps", Group{account}},
  };
  return with_files(rows, s.files);
}

/// How a run ended, in JSON and in the text, in the order of Ending.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kEndings = {
    {{"end", "end of the run"},
     {"quiet", "no more junctions broke"},
     {"spanned", "an event spanned the interface"},
     {"ruptured", "the block ruptured"},
     {"condition", ""},  // what held, instead
     {"rest", "at rest: the drive stands still, and nothing more will rupture"},
     {"interrupted", "interrupted"}}};

void say_invariants(const OutputOptions& output, std::string_view ending,
                    const RunSummary& summary) {
  const EnergyBalance& balance = summary.energy;
  const bool has_speed = summary.steps > 0 && summary.wall_time > 0.0;
  const double speed = static_cast<double>(summary.steps) / summary.wall_time;
  output.say("t = {:.7g} s ({}), {} steps{}\n", summary.time, ending, summary.steps,
             has_speed ? fmt::format(", {:.0f} steps/s", speed) : "");
  output.say(
      "energy [J]: supplied {:.6e} = stored {:.6e} + damping {:.6e} + junctions {:.6e}, "
      "relative error {:.1e}\n",
      balance.supplied, balance.stored, balance.damping, balance.junctions,
      balance.relative_error());
}

/// Checkpoints on the way, of which there may be many: one line names them.
void announce(const std::vector<WrittenFile>& on_the_way, const OutputOptions& output) {
  if (on_the_way.empty()) return;
  const bool is_one = on_the_way.size() == 1;
  output.say("wrote {} checkpoint{} on the way: {}{}\n", on_the_way.size(), is_one ? "" : "s",
             in_one_line(on_the_way.front().path),
             is_one ? "" : " ... " + in_one_line(on_the_way.back().path));
}

/// Counts the events in a record that was just written, as analyze does by default.
void announce_events(const fs::path& path, const OutputOptions& output) {
  if (output.is_quiet) return;
  const Record record = read_record(path);
  const Parameters& p = record.parameters;
  const auto events = find_events(p, ruptures_below(record, kRupturedFraction),
                                  {record.time, record.F_T}, pause_between_events(p), {});
  const auto spanning =
      std::ranges::count_if(events, [](const Event& event) { return spans(event.front.type); });
  if (events.empty()) return output.say("no events\n");
  output.say(
      "{} event{}, of which {} span{} the interface; to list them: rupture analyze events {}\n",
      events.size(), events.size() == 1 ? "" : "s", spanning, spanning == 1 ? "s" : "",
      shell_line({path.string()}));
}

/// A run with everything that it writes on its way. The objects it is made with must outlive it.
class Run : private Observer {
 public:
  explicit Run(const RunPlan& plan)
      : plan_(plan),
        output_(plan.options.output),
        saved_(plan.resumed_from),
        simulation_(begin_.parameters, begin_.state, plan.threads, plan.options.crossings),
        alarms_(plan, simulation_) {  // they know nothing of the run so far
    simulation_.resume_from(*begin_.run);
    if (plan.looks) watch_.emplace(plan);
    if (!plan.options.record) return;
    const RecordParts parts = {plan.options.crossings,
                               plan.fields_every ? Fields::record : Fields::omit, plan.recorded_run,
                               plan.start.run->event};
    const std::int64_t last = plan.rule.last_step;
    writer_.emplace(*plan.options.record, begin_.parameters, recorded_until(plan, last),
                    plan.options.if_record_exists(), plan.recorded, parts);
    recorder_.emplace(*writer_, plan);
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
  // Writes the checkpoints on the way.
  std::int64_t next_step() const override {
    return next_ == plan_.checkpoints.end() ? no_step : next_->first;
  }
  void observe(const Simulation& simulation) override {
    alarms_.observe(simulation);
    save_on_the_way();
    ++next_;
  }

  Ending observed();
  Checkpoint now() const;
  void save(const fs::path& path);
  std::string saved_state(const Alarm& alarm) const;

  const RunPlan& plan_;
  const OutputOptions& output_;
  const Checkpoint& begin_ = plan_.begin;
  fs::path saved_;  // the latest checkpoint
  RunSummary summary_;
  Simulation simulation_;
  Alarms alarms_;
  std::optional<RecordWriter> writer_;
  std::optional<Recorder> recorder_;
  std::optional<Watch> watch_;
  Checkpoints::const_iterator next_ = plan_.checkpoints.begin();
};

/// With all observers, in the order in which they see a step: checkpoints include its sample.
Ending Run::observed() {
  Progress progress(plan_);
  std::vector<Observer*> observers = {&alarms_};
  if (recorder_) observers.push_back(&*recorder_);
  if (watch_) observers.push_back(&*watch_);
  observers.push_back(this);
  if (!output_.is_quiet) observers.push_back(&progress);
  StopRule rule = plan_.rule;
  rule.interrupted = [] { return interruption() != 0; };
  if (watch_) rule.condition_holds = [this] { return !watch_->held.empty(); };
  const Ending ending = run(simulation_, rule, observers);
  alarms_.observe(simulation_);
  return ending;
}

Ending Run::go() {
  const Energies before = simulation_.energies();
  const auto begin = steady_clock::now();
  try {
    const Ending ending = observed();
    const auto& [in_json, in_text] = kEndings.at(static_cast<std::size_t>(ending));
    summary_.ending = in_json;
    if (ending == Ending::condition) summary_.held = watch_->held;
    summary_.time = simulation_.time();
    summary_.steps = simulation_.state().step - begin_.state.step;
    summary_.simulated_time = summary_.time - time(begin_.parameters, begin_.state);
    summary_.wall_time = std::chrono::duration<double>(steady_clock::now() - begin).count();
    summary_.energy = energy_balance(before, simulation_.energies(), simulation_.work());
    summary_.run = simulation_.run();
    say_invariants(output_, summary_.held.empty() ? in_text : summary_.held, summary_);
    announce(summary_.files, output_);
    return ending;
  } catch (const Alarm& alarm) {
    const std::string where = saved_state(alarm);
    announce(summary_.files, output_);
    if (writer_) writer_->flush();
    throw Failure("{}{}", alarm.what(), where);
  } catch (...) {
    announce(summary_.files, output_);
    if (writer_) writer_->flush();
    throw;
  }
}

void Run::finish() {
  std::exception_ptr failure;
  try {
    if (recorder_) recorder_->finish(simulation_);
    if (recorder_) recorder_->sync(simulation_);
  } catch (const Failure&) {
    failure = std::current_exception();  // the checkpoint needs no record
  }
  if (output_.output != saved_) {
    save(output_.output);
    announce(summary_.files.back(), output_);
  }
  if (failure) std::rethrow_exception(failure);
  if (!recorder_) return;
  const fs::path& record = *plan_.options.record;
  const auto checksum = writer_->finish(recorded_until(plan_, simulation_.state().step),
                                        simulation_.run().first_step);
  summary_.files.push_back({record, "record", checksum});
  announce(summary_.files.back(), output_);
  announce_events(record, output_);
}

const fs::path& Run::save_on_the_way() {
  const fs::path path = path_at(output_.output, simulation_.time());
  if (path == saved_) return saved_;
  if (recorder_) recorder_->sync(simulation_);
  save(path);
  return saved_;
}

Checkpoint Run::now() const {
  const Parameters& p = begin_.parameters;
  const State& state = simulation_.state();
  return {p, state, run_until(begin_.provenance, p, state.clock, state.step), simulation_.run()};
}

void Run::save(const fs::path& path) {
  const auto checksum = write_checkpoint(path, now(), if_checkpoint_exists(plan_, path));
  summary_.files.push_back({path, "checkpoint", checksum});
  saved_ = path;
}

/// Saves the state that an alarm found, but not that with which the run begins; says where, or why
/// not.
std::string Run::saved_state(const Alarm& alarm) const try {
  if (!has_moved()) return "";
  const fs::path path = alarm_path(output_.output);
  const IfExists if_exists = if_checkpoint_exists(plan_, path);
  check_output(path, if_exists);
  Checkpoint bad = now();
  bad.alarm = alarm.what();
  bad.provenance.back().rebuild += " --on-alarm report";
  write_checkpoint(path, bad, if_exists);
  return fmt::format("; this state is in {}", path.string());
} catch (const Failure& failure) {
  return fmt::format("; this state is not saved: {}", failure.what());
}

std::string resuming_command(const RunOptions& options) {
  auto arguments = options.arguments;
  if (!options.resume) arguments.insert(arguments.begin() + 1, "--resume");
  return shell_line(arguments);
}

void say_where_it_begins(const RunPlan& plan) {
  const OutputOptions& output = plan.options.output;
  if (plan.is_complete) {
    output.say("{} is complete\n", in_one_line(output.output.string()));
  } else if (plan.is_resumed()) {
    output.say("resuming from {}\n", in_one_line(plan.resumed_from.string()));
  } else {
    output.say("nothing to resume from: starting from the beginning\n");
  }
}

/// Runs and writes what the plan says.
void carry_out(const RunPlan& plan) {
  catch_interruptions();
  try_output(plan.options.output.output);
  Run run(plan);
  const bool is_interrupted = run.go() == Ending::interrupted;
  std::string where = " at its first step";
  if (!is_interrupted) {
    run.finish();
  } else if (run.has_moved()) {
    where = fmt::format(", and saved as {}", run.save_on_the_way().string());
  }
  if (plan.options.output.json) print_json(quantities_of(run.summary()));
  if (is_interrupted) {
    throw Interrupted{interruption(), fmt::format("interrupted{}; to continue: {}", where,
                                                  resuming_command(plan.options))};
  }
  if (const int signal = interruption()) {
    throw Interrupted{signal, "interrupted after everything had been written"};
  }
}

}  // namespace

int simulate(Checkpoint start, const StopRule& rule, const RunOptions& options,
             const fs::path& input) {
  const RunPlan plan = plan_run(std::move(start), rule, options, input);
  const bool is_silent = options.is_dry && (plan.is_complete || options.output.json);
  if (options.resume && !is_silent) say_where_it_begins(plan);
  if (options.is_dry) {
    say("{}", forecast(plan));
    return kDone;
  }
  if (plan.is_complete) {
    const Checkpoint& end = plan.begin;
    const double t = time(end.parameters, end.state);
    const RunSummary summary = {.ending = "complete", .time = t, .run = *end.run};
    if (options.output.json) print_json(quantities_of(summary));
  } else {
    carry_out(plan);
  }
  return kDone;
}

Quantities run_quantities() {
  return quantities_of(RunSummary{});
}

}  // namespace rupture::tools
