// analyze events: the events in a record.
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "analyze/analyze.hpp"
#include "analyze/front_report.hpp"
#include "analyze/record_command.hpp"
#include "rupture/analysis/events.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::tools {
namespace {

Json event_json(const Parameters& p, const Event& event, std::size_t number) {
  return {{"number", number},
          {"t_start", event.t_start},
          {"t_end", event.t_end},
          {"x_first", event.x_first},
          {"x_last", event.x_last},
          {"spanning", spans(event.front.type)},
          {"type", front_type_name(event.front.type)},
          {"slow", slow_json(event.front.slow)},
          {"F_T_before", event.F_T_before},
          {"F_T_after", event.F_T_after},
          {"c_s", shear_wave_speed(p)},
          {"L", p.L},
          {"t_rupture", json_of(event.front.line.t_rupture)}};
}

/// What --csv prints of an event: names as in the JSON, with units.
constexpr std::array kEventColumns = {"number",
                                      "t_start [s]",
                                      "t_end [s]",
                                      "x_first [m]",
                                      "x_last [m]",
                                      "spanning",
                                      "type",
                                      "slow.x_from [m]",
                                      "slow.x_to [m]",
                                      "slow.t_from [s]",
                                      "slow.t_to [s]",
                                      "slow.duration [s]",
                                      "slow.speed [m/s]",
                                      "slow.fast_before [m/s]",
                                      "slow.fast_after [m/s]",
                                      "F_T_before [N]",
                                      "F_T_after [N]"};

/// Where a column's value is in the JSON of an event: "slow.x_from [m]" is /slow/x_from.
Json::json_pointer place_of(std::string heading) {
  heading.resize(std::min(heading.find(" ["), heading.size()));
  std::replace(heading.begin(), heading.end(), '.', '/');
  return Json::json_pointer("/" + heading);
}

void append(Column& column, const Json& value) {
  if (value.is_string()) {
    column.texts.push_back(value);
  } else if (value.is_boolean()) {
    column.texts.push_back(value.dump());
  } else {
    column.values.push_back(value.is_null() ? std::nullopt : std::optional<double>(value));
  }
}

std::vector<Column> event_columns(const Json& events) {
  std::vector<Column> columns;
  for (const char* const heading : kEventColumns) {
    Column column = {heading, {}};
    const auto place = place_of(heading);
    for (const Json& event : events) {
      append(column, event.contains(place) ? event.at(place) : Json());
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace

int analyze_events(int argc, const char* const* argv) {
  po::options_description options("Options");
  add_format_options(options);
  add_quiet_time_option(options);
  add_criteria_options(options);
  const auto command = read_record_command(
      argc, argv, "events", "Splits the block ruptures of a record into events, numbered from 0.",
      options);
  const Record& record = command.record;
  const Parameters& p = record.parameters;
  const auto events = find_events(p, record.ruptures, {record.time, record.F_T},
                                  quiet_time(command), criteria(command.parsed.values));
  Report report;
  report.json = {{"events", Json::array()}};
  report.text = "number  t_start [s]    t_end [s]  reaches x [m]      type   drop of F_T [N]\n";
  for (std::size_t n = 0; n < events.size(); ++n) {
    const Event& event = events[n];
    report.json["events"].push_back(event_json(p, event, n));
    report.text += fmt::format(
        "{:6}{:13.7f}{:13.7f}{:15.4f}{:>10}{:18.1f}   {}\n", n, event.t_start, event.t_end,
        event.x_last, front_type_name(event.front.type), event.F_T_before - event.F_T_after,
        slow_text(event.front.slow, shear_wave_speed(p)));
  }
  report.series = event_columns(report.json["events"]);
  print(report, command.parsed.values);
  return kDone;
}

}  // namespace rupture::tools
