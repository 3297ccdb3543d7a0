#include "run/observers.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

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
  Eigen::Map<RowMajorArray<float>>(values.data(), blocks.rows(), blocks.cols()) =
      blocks.cast<float>();
  return values;
}

bool on_terminal() {
  return isatty(STDERR_FILENO) == 1;
}

/// Whether there is a line of progress on the terminal.
bool& is_drawn() {
  static bool drawn = false;
  return drawn;
}

/// Columns that a line on the terminal may fill: a full one would make some terminals wrap.
std::size_t columns() {
  constexpr std::size_t usual = 80;
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return (known ? size.ws_col : usual) - 1;
}

/// Decimals by which a thousandth of the duration [s] shows.
int decimals_for(double duration) {
  constexpr double most = 9.0;
  return static_cast<int>(std::clamp(3.0 - std::floor(std::log10(duration)), 0.0, most));
}

/// "12 %   t = 0.0360 s of 0.3000 s   31,000 steps/s   8.5 s left", where `rate` is in steps/s.
std::string progress_text(const RunPlan& plan, const Simulation& now, double rate) {
  const std::int64_t first = now.run().first_step, last = plan.rule.last_step;
  const std::int64_t step = now.state().step;
  const auto whole = static_cast<double>(last - first);
  const int decimals = decimals_for(whole * now.parameters().dt);
  const double end = time_at(now.parameters(), now.state().clock, last);
  const auto text = [&](const char* limit) {
    return fmt::format("t = {:.{}f} s of {}{:.{}f} s   {:>9} steps/s", now.time(), decimals, limit,
                       end, decimals, grouped(rate));
  };
  if (plan.rule.early.may_come()) return text("at most ");
  const double percent = std::floor(100.0 * static_cast<double>(step - first) / whole);
  const double left = std::ceil(static_cast<double>(last - step) / rate);  // [s]
  return fmt::format("{:3.0f} %   {}   {:>6} left", percent, text(""), time_text(left));
}

/// So that other words begin a line.
void clear_progress_line() {
  if (std::exchange(is_drawn(), false)) say_on(stderr, "\r{:{}}\r", "", columns());
}

}  // namespace

std::vector<std::int64_t> sampled_steps(const Content& rows, const std::string& path) {
  const auto found = rows.find(path);
  if (found == rows.end()) return {};
  return read_array<std::int64_t>(rows, found->first, found->second.shape);
}

Recorder::Recorder(RecordWriter& writer, const RunPlan& plan)
    : writer_(writer),
      last_step_(plan.rule.last_step),
      series_(sampler(plan.record_every, sampled_steps(plan.recorded, kSeriesSteps),
                      plan.begin.state.step)),
      in_events_(plan.in_events),
      holds_(plan.is_dense_only_if_spanning()) {
  const std::int64_t now = plan.begin.state.step;
  if (plan.fields_every) {
    fields_ = sampler(*plan.fields_every, sampled_steps(plan.recorded, kFieldsSteps), now);
  }
  if (in_events_) next_look_ = in_events_->after(now);
}

Recorder::Sampler Recorder::sampler(const Interval& every, const std::vector<std::int64_t>& sampled,
                                    std::int64_t now) const {
  if (sampled.empty()) return {every, -1, now};
  return {every, sampled.back(), sample_after(now, every)};
}

std::int64_t Recorder::sample_after(std::int64_t step, const Interval& every) const {
  const std::int64_t next = every.after(step);
  return step < last_step_ ? std::min(next, last_step_) : next;
}

std::int64_t Recorder::next_step() const {
  return std::min({series_.next, fields_ ? fields_->next : no_step, next_look_});
}

/// Whether a sample is to be taken, which counts as taken then.
bool Recorder::is_due(Sampler& sampler, std::int64_t step, bool in_event) const {
  if (step < sampler.next && !in_event) return false;
  sampler = {sampler.every, step, sample_after(step, sampler.every)};
  return true;
}

/// Whether an event is under way.
bool Recorder::looks_at_event(const Simulation& simulation) {
  const Parameters& p = simulation.parameters();
  const RunSoFar& run = simulation.run();
  next_look_ = in_events_->after(simulation.state().step);
  const bool in_event = run.event.is_under_way(simulation.time(), quiet_time(p, run.early));
  if (holds_ && !in_event) writer_.no_event();
  if (holds_ && in_event && spans(p, run.event.first)) writer_.event_spans();
  return in_event;
}

void Recorder::observe(const Simulation& simulation) {
  const State& state = simulation.state();
  const bool in_event = state.step >= next_look_ && looks_at_event(simulation);
  const bool is_dense = in_event && !holds_;
  if (is_due(series_, state.step, is_dense)) {
    append_ruptures(simulation);  // first, so that a .part has all ruptures up to its last sample
    writer_.append(sample_of(simulation));
  } else if (in_event) {
    append_ruptures(simulation);
    writer_.hold(sample_of(simulation));
  }
  if (fields_ && is_due(*fields_, state.step, is_dense)) {
    writer_.append(
        FieldSample{simulation.time(), state.step, rounded(state.u_x), rounded(state.u_z)});
  }
}

void Recorder::finish(const Simulation& simulation) {
  const std::int64_t step = simulation.state().step;
  if (series_.sampled < step) series_.next = step;
  if (fields_ && fields_->sampled < step) fields_->next = step;
  observe(simulation);
}

void Recorder::append_ruptures(const Simulation& simulation) {
  const std::span<const Rupture> ruptures = simulation.ruptures();
  writer_.append(ruptures.subspan(std::exchange(ruptures_written_, ruptures.size())));
}

void Recorder::sync(const Simulation& simulation) {
  append_ruptures(simulation);
  writer_.sync();
}

void Alarms::observe(const Simulation& simulation) {
  const std::int64_t step = simulation.state().step, last = plan_.rule.last_step;
  next_ = next_look(step);
  if (step < last) next_ = std::min(next_, last);
  for (const Finding& finding : guard_.look(simulation)) {
    const bool alarm = finding.severity == Severity::alarm;
    if (alarm && !plan_.options.reports_alarms) {
      throw Alarm(finding.sentence + ", or continue anyway with --on-alarm report");
    }
    if (!alarm && plan_.options.output.is_quiet) continue;
    clear_progress_line();
    say_on(stderr, "{}: {}: {}\n", plan_.tool(), alarm ? "alarm" : "warning", finding.sentence);
  }
}

Progress::Progress(const RunPlan& plan)
    : plan_(plan),
      next_(on_terminal() ? plan.begin.state.step + 100 : tenth_after(plan.begin.state.step)) {}

void Progress::observe(const Simulation& simulation) {
  constexpr std::chrono::seconds pause(5);
  const std::int64_t step = simulation.state().step;
  const auto now = Clock::now();
  const std::chrono::duration<double> elapsed = now - start_;
  const double rate =
      static_cast<double>(step - plan_.begin.state.step) / std::max(elapsed.count(), 1e-9);
  const std::string text = progress_text(plan_, simulation, rate);
  if (on_terminal()) {
    const std::size_t width = columns();
    say_on(stderr, "\r{:<{}}", text.substr(0, width), width);
    std::fflush(stderr);
    is_drawn() = true;
    next_ = step + std::max<std::int64_t>(1, std::llround(0.2 * rate));  // 0.2 s later
    return;
  }
  next_ = tenth_after(step);
  if (now - printed_ < pause) return;
  printed_ = now;
  say_on(stderr, "{}: {}\n", plan_.tool(), text);
}

std::int64_t Progress::tenth_after(std::int64_t step) const {
  constexpr std::int64_t tenths = 10;
  const std::int64_t first = plan_.begin.run->first_step, last = plan_.rule.last_step;
  for (std::int64_t n = 1; n < tenths; ++n) {
    const std::int64_t next = first + (last - first) * n / tenths;
    if (next > step) return next;
  }
  return no_step;
}

Progress::~Progress() {
  clear_progress_line();
}

}  // namespace rupture::tools
