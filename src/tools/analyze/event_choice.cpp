#include "analyze/event_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "analyze/front_report.hpp"
#include "cli/option_values.hpp"
#include "rupture/analysis/front.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/normal_contact.hpp"
#include "rupture/model/rupture.hpp"

namespace rupture::tools {
namespace {

using Bursts = std::vector<std::span<const Rupture>>;

bool is_within(const RecordCommand& command, const Rupture& rupture) {
  return rupture.time >= command.from && rupture.time <= command.to;
}

/// Numbers of the events with ruptures in the window.
std::vector<std::size_t> numbers_in_window(const RecordCommand& command, const Bursts& bursts) {
  std::vector<std::size_t> numbers;
  for (std::size_t n = 0; n < bursts.size(); ++n) {
    const auto counts = [&](const Rupture& rupture) { return is_within(command, rupture); };
    if (std::any_of(bursts[n].begin(), bursts[n].end(), counts)) numbers.push_back(n);
  }
  return numbers;
}

/// "0 at 0.183 s, 1 at 0.241 s, 2 at 0.307 s, ..., 28 at 1.19 s".
std::string list_of(const Bursts& bursts, const std::vector<std::size_t>& numbers) {
  constexpr std::size_t kNamed = 3;
  const auto name = [&](std::size_t number) {
    return fmt::format("{} at {:.4g} s", number, bursts[number].front().time);
  };
  const std::size_t named = std::min(kNamed, numbers.size() - 1);
  std::vector<std::string> names;
  for (std::size_t n = 0; n < named; ++n) names.push_back(name(numbers[n]));
  if (named + 1 < numbers.size()) names.emplace_back("...");
  names.push_back(name(numbers.back()));
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Whether the first event is the one that the trigger of a prepared interface started.
bool begins_with_trigger(const Record& record) {
  return NormalContact(record.parameters).has_constant_p() && record.time.front() == 0.0;
}

ChosenEvent event_in_window(const RecordCommand& command, const Bursts& bursts) {
  const auto numbers = numbers_in_window(command, bursts);
  ChosenEvent event = {{}, command.from, command.to, 0, numbers.size()};
  if (numbers.empty()) return event;
  const bool is_trigger = numbers.front() == 0 && begins_with_trigger(command.record);
  if (numbers.size() > 1 && !is_trigger) {
    throw Failure(
        fmt::format("the record has {} events ({}): choose one with --event N or --event "
                    "first-spanning, or with --from and --to",
                    numbers.size(), list_of(bursts, numbers)));
  }
  event.number = numbers.front();
  event.ruptures = bursts[event.number];
  return event;
}

ChosenEvent event_number(const Bursts& bursts, std::size_t number) {
  const auto burst = bursts[number];
  return {burst, burst.front().time, burst.back().time, number, 1};
}

ChosenEvent first_spanning(const RecordCommand& command, const Bursts& bursts) {
  for (std::size_t n = 0; n < bursts.size(); ++n) {
    const ChosenEvent event = event_number(bursts, n);
    if (spans(front_of(command, event).type)) return event;
  }
  throw Failure(fmt::format(
      "none of the {} events in this record spans the interface: give --event N (analyze events "
      "lists them)",
      bursts.size()));
}

std::size_t number_of(const std::string& text) {
  std::size_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error == std::errc() && rest == end) return number;
  throw UsageError(fmt::format(
      "--event needs an event number (see analyze events) or first-spanning (got {})", text));
}

ChosenEvent named_event(const RecordCommand& command, const Bursts& bursts,
                        const std::string& name) {
  if (name == "first-spanning") return first_spanning(command, bursts);
  const std::size_t number = number_of(name);
  if (number < bursts.size()) return event_number(bursts, number);
  const std::string known =
      bursts.empty() ? "nothing ruptured in this record"
                     : fmt::format("this record has events 0 to {} (analyze events lists them)",
                                   bursts.size() - 1);
  throw UsageError(fmt::format("there is no event {}: {}", name, known));
}

}  // namespace

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

double quiet_time(const RecordCommand& command) {
  return optional_non_negative(command.values, "quiet-time")
      .value_or(pause_between_events(command.record.parameters));
}

ChosenEvent choose_event(const RecordCommand& command) {
  const auto& values = command.values;
  const Bursts bursts = split_at_pauses(command.record.ruptures, quiet_time(command));
  if (values.count("event") == 0) return event_in_window(command, bursts);
  return named_event(command, bursts, values["event"].as<std::string>());
}

}  // namespace rupture::tools
