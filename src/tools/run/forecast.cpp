// What a run needs: steps, samples and bytes from its plan, and time from some steps taken now.
#include <fmt/core.h>

#include <ctime>
#include <thread>

#include "cli/report.hpp"
#include "run/plan.hpp"
#include "rupture/dynamics/equilibrium.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::tools {
namespace {

constexpr double kMB = 1e6;        // [bytes]
constexpr double kRest = 0.033e6;  // in any file: header, parameters, provenance [bytes]

/// The needs of what is left of a run: the largest possible, if samples are dense in events or the
/// run may end early. Ruptures in the record, 24 bytes each, are not counted.
struct Forecast {
  const RunPlan& plan;
  const Parameters& parameters;
  std::int64_t steps = 0;
  std::int64_t checkpoints = 0;    ///< that at the end included
  std::int64_t samples = 0;        ///< of the record; 0 without one
  std::int64_t field_samples = 0;  ///< of its fields; 0 without them
  double time_per_step = 0;        ///< [s]

  bool at_most() const { return plan.rule.early.may_come() && !plan.is_complete; }
  double simulated_time() const { return static_cast<double>(steps) * parameters.dt; }  ///< [s]
  double blocks() const { return static_cast<double>(parameters.Nx * parameters.Nz); }
  double junctions() const {
    return static_cast<double>(parameters.Nx * springs_per_block(parameters));
  }

  /// Six numbers per block, 21 bytes per junction [bytes].
  double checkpoint() const { return kRest + 48.0 * blocks() + 21.0 * junctions(); }

  /// Per sample four numbers, and three and a count per interface block; per sample of the fields
  /// two numbers, and two of four bytes per block [bytes]. 0 without a record.
  double record() const {
    if (samples == 0) return 0.0;
    const double per_sample = 32.0 + 26.0 * static_cast<double>(parameters.Nx);
    return kRest + static_cast<double>(samples) * per_sample +
           static_cast<double>(field_samples) * (16.0 + 8.0 * blocks());
  }

  double disk() const { return static_cast<double>(checkpoints) * checkpoint() + record(); }
  double time() const { return static_cast<double>(steps) * time_per_step; }  ///< [s]
};

/// Samples at one interval, and at the one in events, if there is one, as if all was one event.
std::int64_t most_samples(const RunPlan& plan, const Interval& every,
                          const std::optional<Interval>& in_events) {
  const std::int64_t first = plan.start.run->first_step, last = plan.rule.last_step;
  std::int64_t samples = every.samples(first, last);
  if (in_events) samples += in_events->number_at(last) - in_events->number_at(first);
  return std::min(samples, last - first + 1);
}

/// The mean processor time [s] of so many threads, which other programs do not make longer.
double time_per_step(Simulation& simulation, int threads) {
  constexpr double whole = 0.5, stretch = 0.01;  // [s]
  const auto at_once =
      std::min(static_cast<unsigned>(threads), std::thread::hardware_concurrency());
  const double ticks = static_cast<double>(CLOCKS_PER_SEC) * std::max(at_once, 1U);  // per second
  double sum = 0.0;
  std::int64_t steps = 0;
  for (std::int64_t next = 1; sum < whole;) {
    const std::clock_t begin = std::clock();  // of all threads
    simulation.advance(next);
    const double t = static_cast<double>(std::clock() - begin) / ticks;
    sum += t;
    steps += next;
    if (t < stretch) next *= 2;
  }
  return sum / static_cast<double>(steps);
}

// --- words

std::string size_text(double bytes) {
  return bytes < 1000.0 * kMB ? rounded(bytes / kMB) + " MB"
                              : rounded(bytes / (1000.0 * kMB)) + " GB";
}

std::string disk_text(const Forecast& f) {
  std::string text = fmt::format("{}: {} checkpoint{} of {}", size_text(f.disk()),
                                 grouped(static_cast<double>(f.checkpoints)),
                                 f.checkpoints == 1 ? "" : "s", size_text(f.checkpoint()));
  if (f.samples > 0) {
    const auto fields = static_cast<double>(f.field_samples);
    text +=
        fmt::format("; record of {} samples{}{}{}, {}, and 24 bytes for each rupture of a block{}",
                    grouped(static_cast<double>(f.samples)),
                    fields > 0 ? fmt::format(" and {} of all blocks", grouped(fields)) : "",
                    f.plan.in_events ? ", if all of the run is an event" : "",
                    f.plan.is_dense_only_if_spanning() ? " that spans" : "", size_text(f.record()),
                    f.plan.options.crossings.empty() ? "" : ", 32 for each crossing");
  }
  return text;
}

std::string end_text(const Forecast& f) {
  const EarlyEnd& early = f.plan.rule.early;
  const auto when = early.condition.empty() ? "" : fmt::format(", when {}", early.condition);
  return f.at_most() ? "; the run may end earlier" + when : "";
}

/// What a longer time step buys, where one is stable.
std::string step_text(const Parameters& p) {
  const double limit = stable_time_step(p);
  std::string text = fmt::format("dt       {:.3g} s; up to {:.3g} s are stable", p.dt, limit);
  if (limit < 1.5 * p.dt) return text;
  return text + fmt::format(
                    ", with {:.2g} of the steps; then speeds and edges of fronts change by about "
                    "1 %, and a load becomes another run (docs/performance.md)",
                    p.dt / limit);
}

std::string memory_text(const Forecast& f) {
  if (!f.plan.is_dense_only_if_spanning()) return "";
  return fmt::format(
      "memory   at most {} of samples until it is known whether their event spans; what is beyond "
      "is kept in {}\n",
      size_text(static_cast<double>(RecordWriter::kMostHeld)),
      in_one_line(part_path(*f.plan.options.record).string()));
}

std::string text_of(const Forecast& f) {
  const auto about = [](bool at_most) { return at_most ? "at most about" : "about"; };
  return fmt::format(
      "steps    {}{}, {:.6g} s simulated{}\n"
      "slider   {} blocks, {} junctions\n"
      "threads  {}\n"
      "disk     {} {}\n"
      "{}"
      "time     {} {}: {} of processor time per step, measured now\n"
      "{}\n",
      f.at_most() ? "at most " : "", grouped(static_cast<double>(f.steps)), f.simulated_time(),
      end_text(f), grouped(f.blocks()), grouped(f.junctions()), f.plan.threads,
      about(f.at_most() || f.plan.in_events), disk_text(f), memory_text(f), about(f.at_most()),
      time_text(f.time()), time_text(f.time_per_step), step_text(f.parameters));
}

Json json_of(const Forecast& f) {
  const auto whole = [](double value) { return static_cast<std::int64_t>(value); };
  return {{"steps", f.steps},
          {"simulated_time", f.simulated_time()},
          {"at_most", f.at_most()},
          {"blocks", whole(f.blocks())},
          {"junctions", whole(f.junctions())},
          {"threads", f.plan.threads},
          {"disk", whole(f.disk())},
          {"checkpoints", f.checkpoints},
          {"time", f.time()},
          {"time_per_step", f.time_per_step}};
}

}  // namespace

std::string forecast(const RunPlan& plan) {
  const Parameters& p = plan.start.parameters;
  Forecast needs = {plan, p};
  if (!plan.is_complete) {
    needs.steps = plan.rule.last_step - plan.begin.state.step;
    needs.checkpoints = std::ssize(plan.checkpoints) + 1;
    if (plan.options.record) needs.samples = most_samples(plan, plan.record_every, plan.in_events);
    const auto of_fields = plan.is_dense_only_if_spanning() ? std::nullopt : plan.in_events;
    if (plan.fields_every) needs.field_samples = most_samples(plan, *plan.fields_every, of_fields);
  }
  Simulation simulation(p, plan.begin.state, plan.threads);
  needs.time_per_step = time_per_step(simulation, plan.threads);
  return plan.options.output.json ? json_text(json_of(needs)) + "\n" : text_of(needs);
}

State roughly_loaded(const Parameters& p) {
  State state = compressed(p);
  const double strain = p.F_N / (p.L * p.B) / p.E;
  for (std::int64_t i = 0; i < p.Nx; ++i) {
    // Also sideways: where nothing at all moves, steps would take another time.
    const double u_x = kPoissonRatio * strain * (block_position(p, i) - 0.5 * p.L);
    state.u_x.blocks().col(i).setConstant(u_x);
    state.junctions.attachment.row(i).setConstant(u_x);
  }
  state.drive.origin_position = state.u_x(0, driving_row(p));
  return state;
}

}  // namespace rupture::tools
