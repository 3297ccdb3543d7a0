#include "analyze/chosen_event.hpp"

#include <algorithm>
#include <charconv>

#include "run/rebuild.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/normal_contact.hpp"

namespace rupture::tools {
namespace {

/// A window beside the record is a mistake; one that reaches beyond it is not.
void check_overlap(const RecordCommand& command) {
  const double first = command.record.time.front(), last = command.record.time.back();
  const auto refuse = [&](const char* option, double t) {
    throw UsageError("{} {:g} is outside the record, which goes from {:.7g} s to {:.7g} s", option,
                     t, first, last);
  };
  if (command.from > last) refuse("--from", command.from);
  if (command.to < first) refuse("--to", command.to);
  if (command.to < command.from)
    throw UsageError("the time window is empty: --to is before --from");
}

using Bursts = std::vector<std::span<const Rupture>>;

/// Numbers of the events with ruptures in the window.
std::vector<std::size_t> numbers_in_window(const RecordCommand& command, const Bursts& bursts) {
  const auto counts = [&](const Rupture& rupture) {
    return rupture.time >= first_moment(command) && rupture.time <= command.to;
  };
  std::vector<std::size_t> numbers;
  for (std::size_t n = 0; n < bursts.size(); ++n) {
    if (std::any_of(bursts[n].begin(), bursts[n].end(), counts)) numbers.push_back(n);
  }
  return numbers;
}

/// "0 at 0.183 s, 1 at 0.241 s, 2 at 0.307 s, ..., 28 at 1.19 s".
std::string list_of(const Bursts& bursts, const std::vector<std::size_t>& numbers) {
  constexpr std::size_t kNamed = 3;  // and the last
  std::vector<std::string> names;
  names.reserve(numbers.size());
  for (const std::size_t number : numbers) {
    names.push_back(fmt::format("{} at {:.4g} s", number, bursts[number].front().time));
  }
  if (names.size() > kNamed + 1) {
    names[kNamed] = "...";
    names.erase(names.begin() + kNamed + 1, names.end() - 1);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

/// An event in a window, with what the record knows of it from before.
ChosenEvent part_in_window(const RecordCommand& command, std::span<const Rupture> burst,
                           double from, double to) {
  const double quiet = quiet_time(command), record_end = command.record.time.back();
  const auto later = std::ranges::upper_bound(burst, to, {}, &Rupture::time);
  const bool goes_on = later != burst.end();  // beyond the window
  const double silence = (goes_on ? to : record_end) - std::prev(later)->time;
  const bool is_whole = command.values.count("from") + command.values.count("to") == 0;
  return {burst,
          from,
          to,
          1,
          {silence, quiet, !goes_on && is_over(silence, quiet), is_whole ? "record" : "window"}};
}

/// The event that is under way when a window begins in which nothing ruptures, if there is one.
ChosenEvent silent_event(const RecordCommand& command) {
  const double from = first_moment(command), quiet = quiet_time(command);
  ChosenEvent event = {{}, command.from, command.to};
  event.end.quiet_time = quiet;
  for (const auto burst : split_at_pauses(command.record.ruptures, quiet)) {
    const auto next = std::ranges::lower_bound(burst, from, {}, &Rupture::time);
    if (next == burst.begin() || from - std::prev(next)->time > quiet) continue;
    event = part_in_window(command, burst, from, command.to);
  }
  event.in_window = 0;
  return event;
}

ChosenEvent event_in_window(const RecordCommand& command, const Bursts& bursts) {
  const auto numbers = numbers_in_window(command, bursts);
  if (numbers.empty()) return silent_event(command);
  const Record& record =
      command.record;  // whether it begins with the trigger of a prepared interface
  const bool is_trigger =
      numbers.front() == 0 && record.time.front() == 0.0 && has_constant_p(record.parameters);
  if (numbers.size() > 1 && !is_trigger) {
    throw Failure(
        "the record has {} events ({}): choose one with --event N or --event "
        "first-spanning, or with --from and --to",
        numbers.size(), list_of(bursts, numbers));
  }
  ChosenEvent event =
      part_in_window(command, bursts[numbers.front()], first_moment(command), command.to);
  event.in_window = numbers.size();
  return event;
}

ChosenEvent whole_event(const RecordCommand& command, const Bursts& bursts, std::size_t number) {
  const auto burst = bursts[number];
  const double from = std::max(burst.front().time, first_moment(command));
  return part_in_window(command, burst, from, burst.back().time);
}

ChosenEvent first_spanning(const RecordCommand& command, const Bursts& bursts) {
  for (std::size_t n = 0; n < bursts.size(); ++n) {
    const ChosenEvent event = whole_event(command, bursts, n);
    if (spans(front_of(command, event).type)) return event;
  }
  throw Failure(
      "no event in the record spans the interface: give --event N (rupture analyze events RECORD "
      "lists them)");
}

/// Where nothing ruptured, the first event is that nothing.
ChosenEvent event_number(const RecordCommand& command, const Bursts& bursts,
                         const std::string& text) {
  std::size_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end) {
    throw UsageError(
        "--event must be an event number (rupture analyze events RECORD lists them) or "
        "first-spanning (got {})",
        text);
  }
  if (number < bursts.size()) return whole_event(command, bursts, number);
  if (bursts.empty() && number == 0) return event_in_window(command, bursts);
  if (bursts.empty()) throw UsageError("there is no event {}: nothing ruptured", text);
  if (bursts.size() == 1) {
    throw UsageError("there is no event {}: the record has 1 event, number 0", text);
  }
  throw UsageError("there is no event {}: the record has {} events, numbers 0 to {}", text,
                   bursts.size(), bursts.size() - 1);
}

/// Only a stencil that was asked for has to fit: a short interface has no speeds by default.
std::size_t stencil(const po::variables_map& values, const Parameters& p) {
  const int blocks = values["stencil"].as<int>();
  if (blocks < 3 || blocks % 2 == 0) {
    throw UsageError("--stencil must be an odd number of blocks, 3 or more (got {})", blocks);
  }
  if (blocks > p.Nx && !values["stencil"].defaulted()) {
    throw UsageError("--stencil {} is longer than the interface, which has {} blocks", blocks,
                     p.Nx);
  }
  return static_cast<std::size_t>(blocks);
}

/// Where the trigger region ends, if `prepare` made the interface: its --x-trigger [m].
std::optional<double> x_trigger(const std::vector<ProvenanceEntry>& chain) {
  for (const ProvenanceEntry& step : chain) {
    const auto command = read_rebuild(step.rebuild);
    const auto* const option = command ? command->find("x-trigger") : nullptr;
    if (step.tool != "prepare" || option == nullptr) continue;
    double x = 0.0;
    const char* const end = option->value.data() + option->value.size();
    if (std::from_chars(option->value.data(), end, x).ptr == end) return x;
  }
  return std::nullopt;
}

double skip_below_x(const RecordCommand& command, std::size_t half_stencil) {
  const Parameters& p = command.record.parameters;
  const auto x = optional_non_negative(command.values, "skip-below-x");
  if (x && *x > p.L) {
    throw UsageError("--skip-below-x {:g} is beyond the interface, which ends at {:g} m", *x, p.L);
  }
  if (x) return *x;
  const auto end = x_trigger(command.record.provenance);
  if (!end) return kLoadingZone;
  const auto x_of = block_positions(p);
  const auto first = std::ranges::lower_bound(x_of, *end) - x_of.begin();
  return block_position(p, first + static_cast<std::int64_t>(half_stencil));
}

constexpr std::array<std::string_view, 2> kLines = {"contiguous", "raw"};

}  // namespace

void add_window_options(po::options_description& options) {
  auto add = options.add_options();
  add("from", seconds(), "start of the time window");
  add("to", seconds(), "end of the time window");
}

RecordCommand record_of(const Parsed& parsed) {
  const auto& values = parsed.values;
  if (values.count("event") > 0 && values.count("from") + values.count("to") > 0) {
    throw UsageError("--event cannot be combined with --from or --to: give one of them");
  }
  RecordCommand command = {values, read_record(single_input(values, "record", "a record"))};
  if (command.record.time.empty()) throw Failure("the record holds no samples yet");
  command.from = optional_non_negative(values, "from").value_or(command.record.time.front());
  command.to = optional_non_negative(values, "to").value_or(command.record.time.back());
  if (values.count("ruptured-below") > 0) {
    command.record.ruptures = ruptures_below(command.record, fraction(values, "ruptured-below"));
  }
  check_overlap(command);
  return command;
}

void add_quiet_time_option(po::options_description& options) {
  options.add_options()("quiet-time", seconds(),
                        "time without ruptures that separates events; default 5 t_R");
}

void add_event_options(po::options_description& options) {
  options.add_options()(
      "event", text("number|first-spanning"),
      "number of the event in analyze events, from 0, or the first event that spans the interface");
  add_window_options(options);
  add_quiet_time_option(options);
}

double first_moment(const RecordCommand& command) {
  return std::max(command.from, just_after(command.record.time.front()));
}

double quiet_time(const RecordCommand& command) {
  return optional_non_negative(command.values, "quiet-time")
      .value_or(pause_between_events(command.record.parameters));
}

ChosenEvent choose_event(const RecordCommand& command) {
  const auto& values = command.values;
  Bursts bursts = split_at_pauses(command.record.ruptures, quiet_time(command));
  if (!bursts.empty() && bursts.front().back().time <= command.record.time.front()) {
    bursts.erase(bursts.begin());
  }
  if (values.count("event") == 0) return event_in_window(command, bursts);
  const auto& name = values["event"].as<std::string>();
  return name == "first-spanning" ? first_spanning(command, bursts)
                                  : event_number(command, bursts, name);
}

void add_criteria_options(po::options_description& options) {
  auto add = options.add_options();
  add("slow-below", number("R")->default_value(0.05, "0.05"),
      "the front is slow where |v_c| < R c_s");
  add("skip-below-x", number("X", "m"),
      "end of the loading zone, in which blocks and speeds do not count; default 0.02, and on an "
      "interface from prepare the centre of the first stencil beyond its trigger region");
  add("stencil", integer("N")->default_value(5),
      "odd number of blocks of the stencil whose end points give v_c");
  add("line", one_of("contiguous|raw")->default_value("contiguous"),
      "whether the front is at a block when the contiguous ruptured region reaches it, or when it "
      "ruptures, even if alone");
  add("ruptured-below", number("F")->default_value(kRupturedFraction, "0.3"),
      "pinned fraction below which a block counts as ruptured: 0.3, or one of the record's "
      "--crossings");
}

FrontCriteria criteria(const RecordCommand& command) {
  const po::variables_map& values = command.values;
  const std::size_t blocks = stencil(values, command.record.parameters);
  const auto line = std::ranges::find(kLines, values["line"].as<std::string>());
  return {.slow_below = non_negative(values, "slow-below"),
          .skip_below_x = skip_below_x(command, blocks / 2),
          .stencil = blocks,
          .line = static_cast<Line>(line - kLines.begin()),
          .ruptured_below = fraction(values, "ruptured-below")};
}

Quantity criteria_quantity(const FrontCriteria& criteria) {
  const Quantities rows = {
      {"slow_below", "1", "a front is slow where |v_c|/c_s is below this", criteria.slow_below},
      {"skip_below_x", "m", "blocks and speeds up to here do not count", criteria.skip_below_x},
      {"stencil", "1", "blocks of the stencil that gives v_c",
       static_cast<std::int64_t>(criteria.stencil)},
      {"line", "", "whether the front is contiguous, or the raw line of ruptures",
       std::string(kLines.at(static_cast<std::size_t>(criteria.line)))},
      {"ruptured_below", "1", "pinned fraction below which a block counts as ruptured",
       criteria.ruptured_below},
  };
  return {"criteria", "", "", Group{rows}};
}

Front front_of(const RecordCommand& command, const ChosenEvent& event) {
  const Parameters& p = command.record.parameters;
  RuptureLine line = rupture_line(p, event.ruptures, event.from, event.to);
  line.is_over = event.end.is_over;
  return measure_front(p, std::move(line), criteria(command));
}

}  // namespace rupture::tools
