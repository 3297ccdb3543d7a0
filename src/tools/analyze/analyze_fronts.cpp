// analyze events, front, classify: the events in a record, and the front of one of them.
#include "analyze/analyze.hpp"
#include "analyze/front_report.hpp"
#include "cli/text.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::tools {
namespace {

/// The type, and what is reported with it.
Quantities kind_quantities(const Front& front, const EventEnd& end) {
  const Quantities kind = {
      type_quantity(front),
      {"reached_edge", "", "whether the block at the leading edge ruptured",
       if_known(front.reached_edge || end.is_over, front.reached_edge)},
      {"fast_slow_fast", "",
       "whether it spans and is below c_s/10 over three stencils or more, with medians of at least "
       "c_s/10 before and after; null if the event is not over and has not spanned, or if all "
       "speeds before are those of the event before the window",
       if_known(front.fast_slow_fast != Answer::unknown, front.fast_slow_fast == Answer::yes)},
      {"backward_stencils", "1", "stencils beyond the loading zone where the front runs backwards",
       static_cast<std::int64_t>(front.backward_stencils)},
      {"ahead", "1", "blocks beyond the loading zone that ruptured before the front was there",
       static_cast<std::int64_t>(front.ahead)},
  };
  return join({kind, hidden_quantities(front, end)});
}

/// In JSON alone.
Quantities speeds_of(const Front& front) {
  return {
      {"speed", "m/s", "median of v_c beyond the loading zone, where the front runs forwards",
       front.speed},
      stretch_quantity("in_words", front.in_words),
  };
}

Quantities classification_of(const Front& front, const EventEnd& end) {
  const Quantity arrest = {"x_arrest", "m", "furthest ruptured block of an arrested front",
                           front.x_arrest};
  return join({kind_quantities(front, end),
               {arrest},
               speeds_of(front),
               {criteria_quantity(front.criteria)}});
}

Quantities times_of(const Front& front) {
  return {
      {"t_rupture", "s", "first rupture of each block", front.line.t_rupture},
      {"t_front", "s", "time at which the front is at each block", front.t_front},
  };
}

Quantity times_before(const Front& front) {
  return {"t_before", "s", "first rupture of each block in the event, before the window begins",
          front.line.before};
}

/// With which speeds and positions are compared.
Quantities scales_of(const Parameters& p) {
  return {
      {"c_s", "m/s", "speed of shear waves", shear_wave_speed(p)},
      {"L", "m", "length of the interface", p.L},
  };
}

Quantities quantities_of(const Front& front, const EventEnd& end, const Parameters& p) {
  const TextColumn times = {17, "{:.7f}"}, speeds = {12, "{:.4g}"};
  Quantities line = times_of(front);
  for (Quantity& row : line) row = in_csv(row, times);
  line.insert(line.begin(), positions(front.line.x));
  line.push_back({"v_c", "m/s", "front speed at each block", front.v_c, Csv::yes, speeds});
  line.push_back(times_before(front));
  return join(
      {line, classification_of(front, end), {stretch_quantity("slow", front.slow)}, scales_of(p)});
}

Quantities event_quantities(const Parameters& p, const Event& event, double quiet,
                            std::int64_t number) {
  const TextColumn times = {13, "{:.7f}"};
  const EventEnd end = {event.silence, quiet, event.front.line.is_over};
  const auto when_over = [&](double value) {
    return end.is_over ? std::optional(value) : std::nullopt;
  };
  const auto F_T_after = when_over(event.F_T_after),
             drop = when_over(event.F_T_before - event.F_T_after);
  const bool has_spanned = spans(event.front.type);
  const std::string slow = "   " + kind_text(event.front, shear_wave_speed(p));
  Quantities kind = kind_quantities(event.front, end);
  for (Quantity& row : kind) row = in_csv(row);
  const Quantities before = {
      {"number", "1", "number for --event, from 0", number, Csv::yes, TextColumn{6}},
      {"t_start", "s", "first block rupture of the event in the record", event.t_start, Csv::yes,
       times},
      {"t_end", "s", "last block rupture of the event", when_over(event.t_end), Csv::yes, times},
      {"x_first", "m", "block that ruptured first", event.x_first, Csv::yes},
      {"x_last", "m", "furthest block that ruptured",
       if_known(end.is_over || event.front.reached_edge, std::optional(event.x_last)), Csv::yes,
       TextColumn{15, "{:.4f}", "reaches x [m]"}},
      {"spanning", "",
       "whether more than half of the blocks beyond the loading zone ruptured, including the "
       "leading edge, which was not the first",
       if_known(end.is_over || has_spanned, has_spanned), Csv::yes},
      text_only(kind_name(event.front), {16, "{}", "type"}),
  };
  const Quantities after = {
      in_csv(stretch_quantity("slow", event.front.slow)),
      {"F_T_before", "N", "driving force at the first rupture", event.F_T_before, Csv::yes},
      {"F_T_after", "N", "lowest driving force until the event is over", F_T_after, Csv::yes},
      text_only(drop, {18, "{:.1f}", "drop of F_T [N]"}),
      text_only(slow, {0}),
  };
  return join({before,
               kind,
               after,
               speeds_of(event.front),
               scales_of(p),
               times_of(event.front),
               {times_before(event.front)}});
}

Quantities quantities_of(const Parameters& p, const std::vector<Event>& events,
                         const FrontCriteria& criteria, double quiet) {
  List list = {event_quantities(p, {}, quiet, 0), {}};
  for (std::size_t n = 0; n < events.size(); ++n) {
    list.elements.push_back(event_quantities(p, events[n], quiet, static_cast<std::int64_t>(n)));
  }
  return {{"events", "", "", list}, criteria_quantity(criteria)};
}

// --- one record, measured in several ways

void add_also_option(po::options_description& options) {
  options.add_options()(
      "also", text("CRITERIA"),
      "measure and print again with other criteria, such as \"--stencil 3\"; separate several with "
      "a semicolon. The record is read once; each JSON object is on its own line");
}

/// The options that were given, with these criteria in their place.
po::variables_map with_criteria(const Parsed& parsed, const std::string& words) {
  const auto split = po::split_unix("--also " + words, " \t", "'\"", /*escape=*/"");
  std::vector<const char*> argv;
  for (const std::string& word : split) argv.push_back(word.c_str());
  const std::string tool = "analyze " + parsed.arguments.front();
  const Command taking = {tool, "", "", "", {add_criteria_options}, nullptr};
  const auto criteria = parse(taking, static_cast<int>(argv.size()), argv.data());
  po::variables_map values = parsed.values;
  for (const auto& [name, value] : criteria.values) {
    if (value.defaulted()) continue;
    values.erase(name);
    values.emplace(name, value);
  }
  return values;
}

/// The options as given, and with each of the --also.
std::vector<po::variables_map> ways_of(const Parsed& parsed) {
  std::vector<po::variables_map> ways = {parsed.values};
  if (parsed.values.count("also") == 0) return ways;
  for (const auto& words : split(parsed.values["also"].as<std::string>(), ';')) {
    if (words.find_first_not_of(" \t") == std::string::npos) continue;
    ways.push_back(with_criteria(parsed, words));
  }
  if (ways.size() == 1) throw UsageError("--also is empty: give options, as in '--stencil 5'");
  return ways;
}

/// Prints nothing unless all can be measured.
int print_each(const Parsed& parsed, Report (*measure)(const RecordCommand&)) {
  const auto ways = ways_of(parsed);
  Parsed as_recorded = parsed;
  as_recorded.values.erase("ruptured-below");
  const RecordCommand read = record_of(as_recorded);
  RecordCommand command = read;
  std::vector<Report> reports;
  for (const po::variables_map& way : ways) {
    command.values = way;
    command.record.ruptures = ruptures_below(read.record, fraction(way, "ruptured-below"));
    reports.push_back(measure(command));
  }
  for (const Report& report : reports) print(report, parsed.values);
  return kDone;
}

Report report_of_events(const RecordCommand& command) {
  const Record& record = command.record;
  const FrontCriteria how = criteria(command);
  const double quiet = quiet_time(command);
  const auto events =
      find_events(record.parameters, record.ruptures, {record.time, record.F_T}, quiet, how);
  const Quantities rows = quantities_of(record.parameters, events, how, quiet);
  if (!events.empty()) return {rows, events_text(record.parameters, events, quiet)};
  return {rows, fmt::format("no events: nothing ruptured from t = {:.7g} s to {:.7g} s\n",
                            record.time.front(), record.time.back())};
}

Report report_of_front(const RecordCommand& command) {
  const ChosenEvent event = choose_event(command);
  const Front front = front_of(command, event);
  const Parameters& p = command.record.parameters;
  return {quantities_of(front, event.end, p), front_text(front, p, event)};
}

Report report_of_type(const RecordCommand& command) {
  const ChosenEvent event = choose_event(command);
  const Front front = front_of(command, event);
  return {classification_of(front, event.end), kind_name(front) + "\n"};
}

}  // namespace

constinit const Command events_command = {
    "analyze events RECORD",
    "record",
    "rupture events in a record",
    "Splits the block ruptures of a record into events, numbered from 0.",
    {add_format_options, add_quiet_time_option, add_criteria_options, add_also_option},
    [](const Parsed& parsed) { return print_each(parsed, report_of_events); },
    [] { return quantities_of(Parameters{}, std::vector<Event>{}, {}, 0.0); }};

constinit const Command front_command = {
    "analyze front RECORD",
    "record",
    "rupture line, speed and type of the front in a record",
    "Rupture line, speed and type of one event's front: the first rupture of each block, when\n"
    "the contiguous ruptured region reaches it, and v_c from the end points of a moving stencil.\n"
    "If the record has several events, choose one; on a prepared interface the default is the\n"
    "event that the trigger started.",
    {add_format_options, add_event_options, add_criteria_options, add_also_option},
    [](const Parsed& parsed) { return print_each(parsed, report_of_front); },
    [] { return quantities_of(Front{}, {}, Parameters{}); }};

constinit const Command classify_command = {
    "analyze classify RECORD",
    "record",
    "only the type of the front: none, arrested, slow, fast or fast-slow-fast",
    "Prints only the type of one event's front: none (nothing ruptured), arrested, slow, fast or\n"
    "fast-slow-fast.",
    {add_json_option, add_event_options, add_criteria_options, add_also_option},
    [](const Parsed& parsed) { return print_each(parsed, report_of_type); },
    [] { return classification_of({}, {}); }};

}  // namespace rupture::tools
