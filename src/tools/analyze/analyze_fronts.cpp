// analyze events, front, classify: the events in a record, and the front of one of them.
#include <fmt/core.h>

#include "analyze/analyze.hpp"
#include "analyze/common_quantities.hpp"
#include "analyze/event_choice.hpp"
#include "analyze/front_report.hpp"
#include "analyze/inputs.hpp"
#include "cli/text.hpp"
#include "rupture/analysis/front.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::tools {
namespace {

Quantities classification_of(const Front& front) {
  return join({kind_quantities(front), {arrest_quantity(front)}});
}

Quantities quantities_of(const Front& front, const Parameters& p) {
  const TextColumn times = {17, "{:.7f}"}, speeds = {12, "{:.4g}"};
  const Quantities line = {
      positions(front.line.x),
      in_csv(rupture_times(front.line), times),
      {"v_c", "m/s", "front speed at each block", front.v_c, Csv::yes, speeds},
  };
  const Quantities slow = {
      slow_quantity(front.slow),
      shear_wave_quantity(p),
      length_quantity(p),
  };
  return join({line, classification_of(front), slow});
}

Quantities event_quantities(const Parameters& p, const Event& event, std::int64_t number) {
  const TextColumn times = {13, "{:.7f}"};
  const double drop = event.F_T_before - event.F_T_after;
  const std::string slow = "   " + slow_text(event.front, shear_wave_speed(p));
  Quantities kind = kind_quantities(event.front);
  for (Quantity& row : kind) row = in_csv(row);
  const Quantities before = {
      {"number", "1", "as --event counts, from 0", number, Csv::yes, TextColumn{6}},
      {"t_start", "s", "first block rupture of the event", event.t_start, Csv::yes, times},
      {"t_end", "s", "last block rupture of the event", event.t_end, Csv::yes, times},
      {"x_first", "m", "block that ruptured first", event.x_first, Csv::yes},
      {"x_last", "m", "furthest block that ruptured", event.x_last, Csv::yes,
       TextColumn{15, "{:.4f}", "reaches x [m]"}},
      {"spanning", "",
       "whether more than half of the blocks beyond the loading zone ruptured, the leading edge "
       "among them and not first",
       spans(event.front.type), Csv::yes},
      text_only(kind_name(event.front), {16, "{}", "type"}),
  };
  const Quantities after = {
      in_csv(slow_quantity(event.front.slow)),
      {"F_T_before", "N", "driving force at the first rupture", event.F_T_before, Csv::yes},
      {"F_T_after", "N", "lowest driving force until the event is over", event.F_T_after, Csv::yes},
      text_only(drop, {18, "{:.1f}", "drop of F_T [N]"}),
      text_only(slow, {0}),
      shear_wave_quantity(p),
      length_quantity(p),
      rupture_times(event.front.line),
  };
  return join({before, kind, after});
}

Quantities quantities_of(const Parameters& p, const std::vector<Event>& events) {
  List list = {event_quantities(p, {}, 0), {}};
  for (std::size_t n = 0; n < events.size(); ++n) {
    list.elements.push_back(event_quantities(p, events[n], static_cast<std::int64_t>(n)));
  }
  return {{"events", "", "", list}};
}

}  // namespace

constinit const Command events_command = {
    "events RECORD",
    "record",
    "rupture events in a record",
    "Splits the block ruptures of a record into events, numbered from 0.",
    {add_format_options, add_quiet_time_option, add_criteria_options},
    [](const Parsed& parsed) {
      const RecordCommand command = record_of(parsed);
      const Record& record = command.record;
      const auto events = find_events(record.parameters, record.ruptures, {record.time, record.F_T},
                                      quiet_time(command), criteria(command));
      return print(quantities_of(record.parameters, events), "", parsed.values);
    },
    [] { return quantities_of(Parameters{}, std::vector<Event>{}); }};

constinit const Command front_command = {
    "front RECORD",
    "record",
    "rupture line, speed and type of the front in a record",
    "Rupture line, speed and type of one event's front: first rupture of each block,\n"
    "v_c from the end points of a moving stencil. Of several events one has to be\n"
    "chosen, but on a prepared interface the one that the trigger started is meant.",
    {add_format_options, add_event_options, add_criteria_options},
    [](const Parsed& parsed) {
      const RecordCommand command = record_of(parsed);
      const ChosenEvent event = choose_event(command);
      const Front front = front_of(command, event);
      const Parameters& p = command.record.parameters;
      return print(quantities_of(front, p), front_text(front, shear_wave_speed(p), event),
                   parsed.values);
    },
    [] { return quantities_of(Front{}, Parameters{}); }};

constinit const Command classify_command = {
    "classify RECORD",
    "record",
    "the front's type alone: none, arrested, slow or fast",
    "Prints what one event's front is: none (nothing ruptured), arrested, slow, fast or\n"
    "fast-slow-fast, and nothing else.",
    {add_json_option, add_event_options, add_criteria_options},
    [](const Parsed& parsed) {
      const RecordCommand command = record_of(parsed);
      const Front front = front_of(command, choose_event(command));
      return print(classification_of(front), kind_name(front) + "\n", parsed.values);
    },
    [] { return classification_of({}); }};

}  // namespace rupture::tools
