// analyze events, front, classify: the fronts in a record.
#include <fmt/core.h>

#include "analyze.hpp"
#include "record_command.hpp"
#include "rupture/analysis/events.hpp"
#include "rupture/model/derived.hpp"
#include "text.hpp"

namespace rupture::tools {
namespace {

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

}  // namespace

int analyze_events(int argc, const char* const* argv) {
  po::options_description options("Options");
  add_format_options(options);
  options.add_options()("quiet-time", po::value<double>()->value_name("T"),
                        "time without ruptures that separates events [s]; default 5 t_R");
  add_criteria_options(options);
  const auto command = read_record_command(
      argc, argv, "events", "Splits the block ruptures of a record into events.", options);
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
      read_record_command(argc, argv, "front",
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
  const auto command = read_record_command(
      argc, argv, "classify", "Prints arrested, slow or fast, and nothing else.", options);
  const Front front = front_of(command);
  Report report;
  report.text = fmt::format("{}\n", front_type_name(front.type));
  report.json = {{"type", front_type_name(front.type)}, {"x_arrest", json_of(front.x_arrest)}};
  print(report, command.parsed.values);
  return kDone;
}

}  // namespace rupture::tools
