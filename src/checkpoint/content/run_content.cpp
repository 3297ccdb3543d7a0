#include <algorithm>
#include <limits>

#include "checkpoint/content/context.hpp"
#include "checkpoint/content/layout.hpp"
#include "checkpoint/content/state_content.hpp"

namespace rupture {
namespace {

constexpr Row<std::string> kId = {"/run/id", "1"};
constexpr Row<std::string> kAlarm = {kAlarmPath, "1"};
constexpr Row<double> kRecordEvery = {"/run/record_every", "s"};
constexpr Row<double> kFieldsEvery = {"/run/fields_every", "s"};
constexpr Row<double> kEveryInEvents = {"/run/record_every_in_events", "s"};
constexpr Row<double> kEveryInSpanning = {"/run/record_every_in_spanning_events", "s"};
constexpr Row<std::int64_t> kFirstStep = {"/run/first_step", "1"};
constexpr Row<std::int64_t> kLastBreak = {"/run/last_break", "1"};
constexpr Row<std::int64_t> kRuptures = {"/run/ruptures", "1"};
constexpr Row<std::uint8_t> kLeadingEdge = {"/run/leading_edge_ruptured", "1"};
constexpr Row<double> kEvent = {"/run/event", "s", "[Nx]"};
constexpr Row<double> kLastRupture = {"/run/last_rupture", "s"};
constexpr Row<std::uint8_t> kSpanned = {"/run/spanned", "1"};
constexpr Row<double> kQuietTime = {"/run/quiet_time", "s"};
constexpr Row<std::int64_t> kQuietSteps = {"/run/quiet_steps", "1"};
constexpr Row<double> kArrivedBelow = {"/run/arrived_below", "1"};
constexpr Row<std::uint8_t> kUntilSpanned = {"/run/until_spanned", "1"};
constexpr Row<std::int64_t> kUntilRuptureOf = {"/run/until_rupture_of", "1"};
constexpr Row<std::string> kCondition = {"/run/condition", "1"};
constexpr Row<double> kConditionEvery = {"/run/condition_every", "s"};

constexpr double kNoRupture = -1.0;
constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();

std::int64_t read_between(const Content& content, const Row<std::int64_t>& row, std::int64_t least,
                          std::int64_t most) {
  const std::int64_t value = value_of(content, row);
  if (value >= least && value <= most) return value;
  fail("{} = {}; expected {} to {}", row.path, value, least, most);
}

bool has(const Content& content, const auto& row) {
  return content.contains(row.path);
}

void put_truth(Content& content, const Row<std::uint8_t>& row, bool value) {
  put<std::uint8_t>(content, row, value ? 1 : 0);
}

bool read_truth(const Content& content, const Row<std::uint8_t>& row) {
  const std::uint8_t value = value_of(content, row);
  if (value > 1) fail("{} = {}; expected 0 or 1", row.path, value);
  return value == 1;
}

/// Nothing in files of earlier builds, which do not know it.
Content event_content(const LatestEvent& event) {
  if (event.first.empty()) return {};
  std::vector<double> times;
  for (const auto& t : event.first) times.push_back(t.value_or(kNoRupture));
  Content content = {{kEvent.path, make_array<double>(times, {times.size()}, kEvent.unit)}};
  put(content, kLastRupture, event.last_rupture);
  return content;
}

/// Runs until quiet also end when an event has spanned, and do not say so.
void write_early_end(const EarlyEnd& early, Content& content) {
  if (early.quiet_steps) put(content, kQuietSteps, *early.quiet_steps);
  if (early.arrived_below) put(content, kArrivedBelow, *early.arrived_below);
  if (early.spanned && !early.quiet_steps) put_truth(content, kUntilSpanned, true);
  if (early.rupture_of) put(content, kUntilRuptureOf, *early.rupture_of);
  if (early.quiet_time) put(content, kQuietTime, *early.quiet_time);
  if (early.condition.empty()) return;
  content[kCondition.path] = make_text(early.condition);
  put(content, kConditionEvery, early.condition_every);
}

std::optional<double> read_if_there(const Content& content, const Row<double>& row) {
  if (!has(content, row)) return std::nullopt;
  return value_of(content, row);
}

EarlyEnd read_early_end(const Content& content, const Parameters& p) {
  EarlyEnd early;
  if (has(content, kQuietSteps)) early.quiet_steps = read_between(content, kQuietSteps, 0, kMost);
  early.arrived_below = read_if_there(content, kArrivedBelow);
  early.quiet_time = read_if_there(content, kQuietTime);
  early.spanned = early.quiet_steps.has_value() ||
                  (has(content, kUntilSpanned) && read_truth(content, kUntilSpanned));
  if (has(content, kUntilRuptureOf))
    early.rupture_of = read_between(content, kUntilRuptureOf, 0, p.Nx - 1);
  if (has(content, kCondition)) {
    early.condition = read_text(content, kCondition.path);
    early.condition_every = value_of(content, kConditionEvery);
  }
  return early;
}

}  // namespace

Content run_content(const RunSoFar& run) {
  Content content;
  put(content, kFirstStep, run.first_step);
  put(content, kLastBreak, run.last_break);
  put(content, kRuptures, run.ruptures);
  put_truth(content, kLeadingEdge, run.leading_edge_ruptured);
  content.merge(event_content(run.event));
  if (!run.event.first.empty()) put_truth(content, kSpanned, run.spanned);
  write_early_end(run.early, content);
  if (!run.id.empty()) content[kId.path] = make_text(run.id);
  return content;
}

std::optional<RunSoFar> read_run(const Content& content, const Parameters& p, std::int64_t step) {
  const bool present = std::any_of(content.begin(), content.end(), [](const auto& entry) {
    return entry.first.starts_with("/run/");
  });
  if (!present) return std::nullopt;
  RunSoFar run;
  run.first_step = read_between(content, kFirstStep, 0, step);
  run.last_break = read_between(content, kLastBreak, run.first_step, step);
  run.ruptures = read_between(content, kRuptures, 0, kMost);
  run.leading_edge_ruptured = read_truth(content, kLeadingEdge);
  run.event = read_event(content, p);
  if (!run.event.first.empty()) run.spanned = read_truth(content, kSpanned);
  if (has(content, kId)) run.id = read_text(content, kId.path);
  run.early = read_early_end(content, p);
  return run;
}

LatestEvent read_event(const Content& content, const Parameters& p) {
  LatestEvent event;
  if (!has(content, kEvent)) return event;
  event.last_rupture = value_of(content, kLastRupture);
  for (const double t :
       read_array<double>(content, kEvent.path, {static_cast<std::uint64_t>(p.Nx)})) {
    if (t != kNoRupture && !(t >= 0.0 && t <= event.last_rupture)) {
      fail("{} holds {}; expected 0 to {} = {}, or {} for no rupture", kEvent.path, t,
           kLastRupture.path, event.last_rupture, kNoRupture);
    }
    event.first.push_back(t == kNoRupture ? std::nullopt : std::optional(t));
  }
  return event;
}

Content recorded_run_content(const RecordedRun& run, const LatestEvent& before) {
  Content content = event_content(before);
  if (run.id.empty()) return content;
  content[kId.path] = make_text(run.id);
  put(content, kRecordEvery, run.every);
  if (run.fields_every) put(content, kFieldsEvery, *run.fields_every);
  if (run.every_in_events) put(content, kEveryInEvents, *run.every_in_events);
  if (run.quiet_time) put(content, kQuietTime, *run.quiet_time);
  if (const auto& every = run.every_in_spanning_events) put(content, kEveryInSpanning, *every);
  return content;
}

RecordedRun read_recorded_run(const Content& content) {
  if (!has(content, kId)) return {};
  return {read_text(content, kId.path),         value_of(content, kRecordEvery),
          read_if_there(content, kFieldsEvery), read_if_there(content, kEveryInEvents),
          read_if_there(content, kQuietTime),   read_if_there(content, kEveryInSpanning)};
}

DatasetInfos run_datasets(FileKind kind) {
  if (kind != FileKind::checkpoint) {
    return {kId,          kEvent,         kLastRupture, kRecordEvery,
            kFieldsEvery, kEveryInEvents, kQuietTime,   kEveryInSpanning};
  }
  return {kAlarm,         kId,           kFirstStep,    kLastBreak,      kRuptures,
          kLeadingEdge,   kSpanned,      kEvent,        kLastRupture,    kQuietTime,
          kQuietSteps,    kArrivedBelow, kUntilSpanned, kUntilRuptureOf, kCondition,
          kConditionEvery};
}

}  // namespace rupture
