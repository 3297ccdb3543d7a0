// analyze events: the events in a record.
#include <fmt/core.h>

#include "analyze/analyze.hpp"
#include "analyze/common_quantities.hpp"
#include "analyze/front_report.hpp"
#include "analyze/record_command.hpp"
#include "rupture/analysis/front.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::tools {
namespace {

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

Quantities events_quantities() {
  return quantities_of(Parameters{}, std::vector<Event>{});
}

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
                                  quiet_time(command), criteria(command));
  print(quantities_of(p, events), "", command.parsed.values);
  return kDone;
}

}  // namespace rupture::tools
