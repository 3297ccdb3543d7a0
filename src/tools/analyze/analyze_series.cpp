// analyze slip, loading: time series of a record.
#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "analyze/analyze.hpp"
#include "analyze/chosen_event.hpp"
#include "run/steps.hpp"
#include "rupture/analysis/slip.hpp"
#include "rupture/analysis/slow_slip.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::tools {
namespace {

/// When a block ruptured first in its event [s].
struct FirstRupture {
  std::optional<double> in_window;
  std::optional<double> before;  ///< of the event that is under way when the window begins
};

FirstRupture rupture_of(const RecordCommand& command, std::size_t block) {
  const Record& record = command.record;
  if (record.time.empty()) return {};  // for `analyze quantities`
  const double from = first_moment(command), quiet = quiet_time(command);
  const auto ruptures = ruptures_below(record, kRupturedFraction);
  FirstRupture first;
  for (const auto event : split_at_pauses(ruptures, quiet)) {
    if (event.back().time < from - quiet || first.in_window) continue;
    const RuptureLine line = rupture_line(record.parameters, event, from, command.to);
    if (line.before[block]) first.before = line.before[block];
    first.in_window = line.t_rupture[block];
  }
  return first;
}

std::string slip_text(double x, const FirstRupture& rupture,
                      const std::optional<SlipMeasure>& measure) {
  const auto& [t_rupture, before] = rupture;
  std::string text = fmt::format(
      "block at x = {:.4f} m, {}\n", x,
      t_rupture ? fmt::format("rupture at t = {:.7f} s", *t_rupture)
      : before  ? fmt::format("which ruptured before the window, at t = {:.7f} s", *before)
                : "never ruptured");
  if (!measure) return text;
  text += fmt::format("fast slip {:.4g} um until t = {:.6f} s, then slow slip {:.4g} um\n",
                      measure->fast_slip * 1e6, measure->t_arrest, measure->slow_slip * 1e6);
  if (!measure->slow) return text;
  return text + fmt::format(
                    "slow slip speed {:.4g} +- {:.1g} mm/s between t = {:.6f} s and "
                    "{:.6f} s, R^2 = {:.4f}\n",
                    measure->slow->slope * 1e3, measure->slow->slope_error * 1e3, measure->t_from,
                    measure->t_to, measure->slow->r_squared);
}

/// Slip is fast above this many times Eq. S1.
constexpr double kFast = 10.0;

/// That speed with p at the rupture [m/s]. Without slow slip to expect, the next fast slip cannot
/// be told.
double fast_above(const Record& record, Eigen::Index block, double t_rupture) {
  const auto sample = std::ranges::lower_bound(record.time, t_rupture) - record.time.begin();
  const auto last = std::ssize(record.time) - 1;
  const double p = record.p(std::min(sample, last), block);
  const double estimate = slow_slip_estimate(record.parameters, block, p);
  return estimate > 0.0 ? kFast * estimate : std::numeric_limits<double>::infinity();
}

/// The slip of one block in the window.
Report slip_of(const RecordCommand& command, Eigen::Index block) {
  const Record& record = command.record;
  const Parameters& p = record.parameters;
  const FirstRupture rupture = rupture_of(command, static_cast<std::size_t>(block));
  const auto& t_rupture = rupture.in_window;
  std::vector<double> time, u_x, slip;
  for (std::size_t n = 0; n < record.time.size(); ++n) {
    if (record.time[n] < command.from || record.time[n] > command.to) continue;
    time.push_back(record.time[n]);
    u_x.push_back(record.u_x(static_cast<Eigen::Index>(n), block));
    slip.push_back(u_x.back() - u_x.front());
  }
  std::optional<SlipMeasure> measure;
  if (t_rupture && time.size() > 2) {
    measure = measure_slip({time, u_x}, *t_rupture, fast_above(record, block, *t_rupture));
  }
  const auto measured = [&](double SlipMeasure::*member) {
    return measure ? std::optional((*measure).*member) : std::nullopt;
  };
  const auto fitted = [&](double LineFit::*member) {
    return measure && measure->slow ? std::optional((*measure->slow).*member) : std::nullopt;
  };
  const Quantities rows = {
      {"x", "m", "position of the block", block_position(p, block)},
      {"t_rupture", "s", "first rupture of the block in the window; null if it ruptured before",
       t_rupture},
      {"t_before", "s", "first rupture of the block in the event, before the window begins",
       rupture.before},
      {"t_arrest", "s", "time at which the block first stops after its rupture",
       measured(&SlipMeasure::t_arrest)},
      {"fast_slip", "m", "slip until the block first stops", measured(&SlipMeasure::fast_slip)},
      {"slow_slip", "m", "slip after that, until the block next slips fast",
       measured(&SlipMeasure::slow_slip)},
      {"slow_end", "s", "time at which the block next slips fast, or end of the window",
       measured(&SlipMeasure::t_end)},
      {"slow_from", "s", "start of the fit of the slow slip", measured(&SlipMeasure::t_from)},
      {"slow_to", "s", "end of the fit of the slow slip", measured(&SlipMeasure::t_to)},
      {"slow_speed", "m/s", "speed of the slow slip", fitted(&LineFit::slope)},
      {"slow_speed_error", "m/s", "standard error of that speed", fitted(&LineFit::slope_error)},
      {"slow_r_squared", "1", "R^2 of the fit", fitted(&LineFit::r_squared)},
      {"slow_rms", "m", "root mean square distance from the fit", fitted(&LineFit::rms)},
      {"time", "s", "time of each sample", time, Csv::yes},
      {"slip", "m", "slip since the start of the window, at each sample", slip, Csv::yes},
  };
  return {rows, slip_text(block_position(p, block), rupture, measure)};
}

Quantities quantities_of(const Record& record) {
  return {
      {"F_N", "N", "normal load", record.parameters.F_N},
      {"time", "s", "time of each sample", record.time, Csv::yes},
      {"F_T", "N", "driving force at each sample", record.F_T, Csv::yes},
      {"x_drive", "m", "position of the driving point at each sample", record.x_drive, Csv::yes},
  };
}

std::string text_of(const Record& record) {
  const double F_N = record.parameters.F_N;
  const auto peak = std::max_element(record.F_T.begin(), record.F_T.end());
  return fmt::format(
      "{} samples from t = {:.7g} s to {:.7g} s\nF_T/F_N: {:.4f} at the start, {:.4f} at the end, "
      "peak {:.4f} at t = {:.7g} s\n",
      record.time.size(), record.time.front(), record.time.back(), record.F_T.front() / F_N,
      record.F_T.back() / F_N, *peak / F_N,
      record.time[static_cast<std::size_t>(peak - record.F_T.begin())]);
}

Quantities block_quantities(const Record& record, Eigen::Index block) {
  const auto series = [&](const RowMajorArray<double>& values) {
    const auto column = values.col(block);
    return std::vector<double>(column.begin(), column.end());
  };
  return {
      {"p", "N", "normal force on the block of --x at each sample", series(record.p), Csv::yes},
      {"tau", "N", "friction force on the block of --x at each sample", series(record.tau),
       Csv::yes},
      {"u_x", "m", "displacement of the block of --x at each sample", series(record.u_x), Csv::yes},
  };
}

}  // namespace

constinit const Command slip_command = {
    "analyze slip RECORD",
    "record",
    "fast and slow slip of one block in a record",
    "Slip of one block: displacement since the start of the window, split into the fast\n"
    "slip until the block first stops and the slow slip until it next slips fast: faster than\n"
    "10 times Eq. S1.",
    {add_format_options,
     [](po::options_description& options) {
       options.add_options()("x", number("X", "m")->required(),
                             "position of the block; the nearest block is used");
     },
     add_window_options},
    [](const Parsed& parsed) {
      const RecordCommand command = record_of(parsed);
      const double x = non_negative(parsed.values, "x");
      const Eigen::Index block = block_at(command.record.parameters, x, "x");
      return print(slip_of(command, block), parsed.values);
    },
    [] { return slip_of({}, 0).rows; }};

constinit const Command loading_command = {
    "analyze loading RECORD",
    "record",
    "driving force against time in a record",
    "Driving force against time; with --x also one block's forces.",
    {add_format_options,
     [](po::options_description& options) {
       options.add_options()("x", number("X", "m"),
                             "also p, tau and u_x of the block nearest to this position");
     }},
    [](const Parsed& parsed) {
      const Record record = record_of(parsed).record;
      Quantities rows = quantities_of(record);
      if (const auto x = optional_non_negative(parsed.values, "x")) {
        rows = join({rows, block_quantities(record, block_at(record.parameters, *x, "x"))});
      }
      return print({rows, text_of(record)}, parsed.values);
    },
    [] {
      Record none;
      none.p = none.tau = none.u_x = RowMajorArray<double>(0, 1);
      return join({quantities_of(none), block_quantities(none, 0)});
    }};

}  // namespace rupture::tools
