// analyze slip, loading: time series of a record.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analyze/analyze.hpp"
#include "analyze/record_command.hpp"
#include "cli/option_values.hpp"
#include "rupture/analysis/front.hpp"
#include "rupture/analysis/slip.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

Column column_of_block(const Record& record, const RowMajorArray& values, Eigen::Index block,
                       std::string name) {
  Column result{std::move(name), {}};
  for (std::size_t n = 0; n < record.time.size(); ++n) {
    result.values.emplace_back(values(static_cast<Eigen::Index>(n), block));
  }
  return result;
}

Eigen::Index block_at(const Parameters& p, double x) {
  const double block = std::round(x / block_spacing(p));
  if (block <= static_cast<double>(p.Nx - 1)) return static_cast<Eigen::Index>(block);
  throw UsageError(fmt::format("--x {:g} is beyond the interface, which ends at {:g} m", x, p.L));
}

}  // namespace

int analyze_slip(int argc, const char* const* argv) {
  po::options_description options("Options");
  add_format_options(options);
  options.add_options()("x", number("X", "m")->required(),
                        "position of the block, the nearest one is taken");
  add_window_options(options);
  const auto command =
      read_record_command(argc, argv, "slip",
                          "Slip of one block: displacement since the start of the window, split "
                          "into the fast\nslip until the block first stops and the slow slip that "
                          "follows.",
                          options);
  const Record& record = command.record;
  const Parameters& p = record.parameters;
  const Eigen::Index block = block_at(p, non_negative(command.parsed.values, "x"));
  const auto line = rupture_line(p, record.ruptures, command.from, command.to);
  const auto& t_rupture = line.t_rupture[static_cast<std::size_t>(block)];

  std::vector<double> time, u_x, slip;
  for (std::size_t n = 0; n < record.time.size(); ++n) {
    if (record.time[n] < command.from || record.time[n] > command.to) continue;
    time.push_back(record.time[n]);
    u_x.push_back(record.u_x(static_cast<Eigen::Index>(n), block));
    slip.push_back(u_x.back() - u_x.front());
  }
  std::optional<SlipMeasure> measure;
  if (t_rupture && time.size() > 2) measure = measure_slip({time, u_x}, *t_rupture, 0.5 * p.t_R);

  Report report;
  report.json = {{"x", line.x[static_cast<std::size_t>(block)]},
                 {"t_rupture", json_of(t_rupture)},
                 {"t_arrest", nullptr},
                 {"fast_slip", nullptr},
                 {"slow_slip", nullptr},
                 {"slow_from", nullptr},
                 {"slow_to", nullptr},
                 {"slow_speed", nullptr},
                 {"slow_speed_error", nullptr},
                 {"slow_r_squared", nullptr},
                 {"time", time},
                 {"slip", slip}};
  report.text = fmt::format("block at x = {:.4f} m, rupture at t = {} s\n",
                            line.x[static_cast<std::size_t>(block)],
                            t_rupture ? fmt::format("{:.7f}", *t_rupture) : "-");
  if (measure) {
    report.json["t_arrest"] = measure->t_arrest;
    report.json["fast_slip"] = measure->fast_slip;
    report.json["slow_slip"] = measure->slow_slip;
    report.json["slow_from"] = measure->t_from;
    report.json["slow_to"] = measure->t_to;
    report.text +=
        fmt::format("fast slip {:.4g} um until t = {:.6f} s, then slow slip {:.4g} um\n",
                    measure->fast_slip * 1e6, measure->t_arrest, measure->slow_slip * 1e6);
  }
  if (measure && measure->slow) {
    report.json["slow_speed"] = measure->slow->slope;
    report.json["slow_speed_error"] = measure->slow->slope_error;
    report.json["slow_r_squared"] = measure->slow->r_squared;
    report.text += fmt::format(
        "slow slip speed {:.4g} +- {:.1g} mm/s between t = {:.6f} s and {:.6f} s, R^2 = {:.4f}\n",
        measure->slow->slope * 1e3, measure->slow->slope_error * 1e3, measure->t_from,
        measure->t_to, measure->slow->r_squared);
  }
  report.series = {column("time [s]", time), column("slip [m]", slip)};
  print(report, command.parsed.values);
  return kDone;
}

int analyze_loading(int argc, const char* const* argv) {
  po::options_description options("Options");
  add_format_options(options);
  options.add_options()("x", number("X", "m"),
                        "also p, tau and u_x of the block nearest to this position");
  const auto command =
      read_record_command(argc, argv, "loading",
                          "Driving force against time; with --x also one block's forces.", options);
  const Record& record = command.record;
  const Parameters& p = record.parameters;
  Report report;
  report.series = {column("time [s]", record.time), column("F_T [N]", record.F_T),
                   column("x_drive [m]", record.x_drive)};
  report.json = {
      {"F_N", p.F_N}, {"time", record.time}, {"F_T", record.F_T}, {"x_drive", record.x_drive}};
  if (const auto x = optional_non_negative(command.parsed.values, "x")) {
    const Eigen::Index block = block_at(p, *x);
    report.series.push_back(column_of_block(record, record.p, block, "p [N]"));
    report.series.push_back(column_of_block(record, record.tau, block, "tau [N]"));
    report.series.push_back(column_of_block(record, record.u_x, block, "u_x [m]"));
    report.json["p"] = json_of(report.series[3].values);
    report.json["tau"] = json_of(report.series[4].values);
    report.json["u_x"] = json_of(report.series[5].values);
  }
  const auto peak = std::max_element(record.F_T.begin(), record.F_T.end());
  report.text = fmt::format(
      "{} samples from t = {:.7g} s to {:.7g} s\nF_T/F_N: {:.4f} at the start, {:.4f} at the end, "
      "peak {:.4f} at t = {:.7g} s\n",
      record.time.size(), record.time.front(), record.time.back(), record.F_T.front() / p.F_N,
      record.F_T.back() / p.F_N, *peak / p.F_N,
      record.time[static_cast<std::size_t>(peak - record.F_T.begin())]);
  print(report, command.parsed.values);
  return kDone;
}

}  // namespace rupture::tools
