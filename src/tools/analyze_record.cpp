// analyze events, front, classify, slip, loading: what is measured in a record.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analyze.hpp"
#include "rupture/analysis/events.hpp"
#include "rupture/analysis/slip.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"

namespace rupture::tools {
namespace {

/// Parsed arguments of a command that reads one record.
struct RecordCommand {
  Parsed parsed;
  Record record;
  double from = 0, to = 0;  ///< window of time that counts [s]
};

void add_window_options(po::options_description& options) {
  auto add = options.add_options();
  add("from", po::value<double>()->value_name("T"), "start of the time window [s]");
  add("to", po::value<double>()->value_name("T"), "end of the time window [s]");
}

void add_criteria_options(po::options_description& options) {
  auto add = options.add_options();
  add("slow-below", po::value<double>()->default_value(0.05)->value_name("R"),
      "the front is slow where v_c < R c_s");
  add("skip-below-x", po::value<double>()->default_value(0.02)->value_name("X"),
      "loading zone in which speeds do not count [m]");
}

FrontCriteria criteria(const po::variables_map& values) {
  return {non_negative(values, "slow-below"), non_negative(values, "skip-below-x")};
}

/// A window beside the record is a mistake; one that reaches beyond it is not.
void check_overlap(const RecordCommand& command) {
  const double first = command.record.time.front(), last = command.record.time.back();
  const auto refuse = [&](const char* option, double t) {
    throw UsageError(
        fmt::format("{} {:g} is outside the record, which goes from {:.7g} s to {:.7g} s", option,
                    t, first, last));
  };
  if (command.from > last) refuse("--from", command.from);
  if (command.to < first) refuse("--to", command.to);
}

RecordCommand read(int argc, const char* const* argv, const std::string& name,
                   const std::string& purpose, po::options_description& options) {
  RecordCommand command;
  command.parsed =
      parse(argc, argv, {"analyze " + name, "analyze " + name + " RECORD [options]", purpose},
            options, "record", UsesParameters::no);
  const auto& values = command.parsed.values;
  command.record = read_record(single_input(values, "record", "a record"));
  if (command.record.time.empty()) throw Failure("the record holds no samples yet");
  const bool windowed = options.find_nothrow("from", false) != nullptr;
  command.from = command.record.time.front();
  command.to = command.record.time.back();
  if (windowed && values.count("from") > 0) command.from = non_negative(values, "from");
  if (windowed && values.count("to") > 0) command.to = non_negative(values, "to");
  check_overlap(command);
  if (command.to < command.from)
    throw UsageError("the time window is empty: --to is before --from");
  return command;
}

Json slow_json(const std::optional<SlowStretch>& slow) {
  if (!slow) return nullptr;
  return {{"x_from", slow->x_from},
          {"x_to", slow->x_to},
          {"t_from", slow->t_from},
          {"t_to", slow->t_to},
          {"duration", slow->duration()},
          {"speed", slow->speed},
          {"fast_before", json_of(slow->fast_before)},
          {"fast_after", json_of(slow->fast_after)}};
}

std::string slow_text(const std::optional<SlowStretch>& slow, double c_s) {
  if (!slow) return "no slow stretch";
  return fmt::format("slow from x = {:.4f} m to {:.4f} m for {:.3g} ms at {:.3g} m/s (c_s/{:.0f})",
                     slow->x_from, slow->x_to, slow->duration() * 1e3, slow->speed,
                     c_s / slow->speed);
}

Json event_json(const Parameters& p, const Event& event) {
  return {{"t_start", event.t_start},
          {"t_end", event.t_end},
          {"x_first", event.x_first},
          {"x_last", event.x_last},
          {"spanning", event.front.type != FrontType::arrested},
          {"type", front_type_name(event.front.type)},
          {"slow", slow_json(event.front.slow)},
          {"F_T_before", event.F_T_before},
          {"F_T_after", event.F_T_after},
          {"c_s", shear_wave_speed(p)},
          {"L", p.L},
          {"t_rupture", json_of(event.front.line.t_rupture)}};
}

Front front_of(const RecordCommand& command) {
  const Parameters& p = command.record.parameters;
  return measure_front(p, rupture_line(p, command.record.ruptures, command.from, command.to),
                       criteria(command.parsed.values));
}

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

int analyze_events(int argc, const char* const* argv) {
  po::options_description options("Options");
  add_format_options(options);
  options.add_options()("quiet-time", po::value<double>()->value_name("T"),
                        "time without ruptures that separates events [s]; default 5 t_R");
  add_criteria_options(options);
  const auto command =
      read(argc, argv, "events", "Splits the block ruptures of a record into events.", options);
  const Record& record = command.record;
  const Parameters& p = record.parameters;
  const double quiet =
      optional_non_negative(command.parsed.values, "quiet-time").value_or(5.0 * p.t_R);
  const auto events = find_events(p, record.ruptures, {record.time, record.F_T}, quiet,
                                  criteria(command.parsed.values));
  Report report;
  report.json = {{"events", Json::array()}};
  report.series = {{"t_start [s]", {}}, {"t_end [s]", {}},      {"x_first [m]", {}},
                   {"x_last [m]", {}},  {"F_T_before [N]", {}}, {"F_T_after [N]", {}}};
  report.text = "  t_start [s]    t_end [s]  reaches x [m]      type   drop of F_T [N]\n";
  for (const Event& event : events) {
    report.json["events"].push_back(event_json(p, event));
    const double values[] = {event.t_start, event.t_end,      event.x_first,
                             event.x_last,  event.F_T_before, event.F_T_after};
    for (std::size_t c = 0; c < report.series.size(); ++c) {
      report.series[c].values.emplace_back(values[c]);
    }
    report.text += fmt::format("{:13.7f}{:13.7f}{:15.4f}{:>10}{:18.1f}   {}\n", event.t_start,
                               event.t_end, event.x_last, front_type_name(event.front.type),
                               event.F_T_before - event.F_T_after,
                               slow_text(event.front.slow, shear_wave_speed(p)));
  }
  print(report, command.parsed.values);
  return kDone;
}

int analyze_front(int argc, const char* const* argv) {
  po::options_description options("Options");
  add_format_options(options);
  add_window_options(options);
  add_criteria_options(options);
  const auto command =
      read(argc, argv, "front",
           "Rupture line, speed and type of the front: first rupture of each block "
           "in the\ntime window, v_c from the end points of a five-block stencil.",
           options);
  const Front front = front_of(command);
  const double c_s = shear_wave_speed(command.record.parameters);
  Report report;
  report.json = {{"x", front.line.x},
                 {"t_rupture", json_of(front.line.t_rupture)},
                 {"v_c", json_of(front.v_c)},
                 {"type", front_type_name(front.type)},
                 {"x_arrest", json_of(front.x_arrest)},
                 {"slow", slow_json(front.slow)},
                 {"c_s", c_s},
                 {"L", command.record.parameters.L}};
  report.series = {column("x [m]", front.line.x),
                   {"t_rupture [s]", front.line.t_rupture},
                   {"v_c [m/s]", front.v_c}};
  report.text = "    x [m]    t_rupture [s]   v_c [m/s]\n";
  for (std::size_t i = 0; i < front.line.x.size(); ++i) {
    const auto& t = front.line.t_rupture[i];
    report.text += fmt::format("{:9.4f}{:>17}{:>12}\n", front.line.x[i],
                               t ? fmt::format("{:.7f}", *t) : "-", text_of(front.v_c[i]));
  }
  report.text +=
      fmt::format("{} front; {}\n", front_type_name(front.type), slow_text(front.slow, c_s));
  print(report, command.parsed.values);
  return kDone;
}

int analyze_classify(int argc, const char* const* argv) {
  po::options_description options("Options");
  options.add_options()("json", "print one JSON object");
  add_window_options(options);
  add_criteria_options(options);
  const auto command =
      read(argc, argv, "classify", "Prints arrested, slow or fast, and nothing else.", options);
  const Front front = front_of(command);
  Report report;
  report.text = fmt::format("{}\n", front_type_name(front.type));
  report.json = {{"type", front_type_name(front.type)}, {"x_arrest", json_of(front.x_arrest)}};
  print(report, command.parsed.values);
  return kDone;
}

int analyze_slip(int argc, const char* const* argv) {
  po::options_description options("Options");
  add_format_options(options);
  options.add_options()("x", po::value<double>()->required()->value_name("X"),
                        "position of the block, the nearest one is taken [m]");
  add_window_options(options);
  const auto command =
      read(argc, argv, "slip",
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
  options.add_options()("x", po::value<double>()->value_name("X"),
                        "also p, tau and u_x of the block nearest to this position [m]");
  const auto command =
      read(argc, argv, "loading", "Driving force against time; with --x also one block's forces.",
           options);
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
