#include <algorithm>
#include <limits>

#include "checkpoint/content/context.hpp"
#include "checkpoint/content/state_content.hpp"

namespace rupture {
namespace {

constexpr const char* kId = "/run/id";
constexpr const char* kRecordEvery = "/run/record_every";
constexpr const char* kFieldsEvery = "/run/fields_every";
constexpr const char* kEveryInEvents = "/run/record_every_in_events";
constexpr const char* kFirstStep = "/run/first_step";
constexpr const char* kLastBreak = "/run/last_break";
constexpr const char* kRuptures = "/run/ruptures";
constexpr const char* kLeadingEdge = "/run/leading_edge_ruptured";
constexpr const char* kEvent = "/run/event";
constexpr const char* kLastRupture = "/run/last_rupture";
constexpr const char* kSpanned = "/run/spanned";
constexpr const char* kQuietTime = "/run/quiet_time";
constexpr const char* kQuietSteps = "/run/quiet_steps";
constexpr const char* kArrivedBelow = "/run/arrived_below";
constexpr const char* kUntilSpanned = "/run/until_spanned";
constexpr const char* kUntilRuptureOf = "/run/until_rupture_of";

constexpr double kNoRupture = -1.0;
constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();

std::int64_t read_between(const Content& content, const char* path, std::int64_t least,
                          std::int64_t most) {
  const auto value = read_scalar<std::int64_t>(content, path);
  if (value >= least && value <= most) return value;
  fail("{} = {}; expected {} to {}", path, value, least, most);
}

Dataset make_truth(bool value) {
  return make_scalar<std::uint8_t>(value ? 1 : 0, "1");
}

bool read_truth(const Content& content, const char* path) {
  const auto value = read_scalar<std::uint8_t>(content, path);
  if (value > 1) fail("{} = {}; expected 0 or 1", path, value);
  return value == 1;
}

/// Nothing in files of earlier builds, which do not know it.
Content event_content(const LatestEvent& event) {
  if (event.first.empty()) return {};
  std::vector<double> times;
  for (const auto& t : event.first) times.push_back(t.value_or(kNoRupture));
  return {{kEvent, make_array<double>(times, {times.size()}, "s")},
          {kLastRupture, make_scalar(event.last_rupture, "s")}};
}

/// Runs until quiet also end when an event has spanned, and do not say so.
void write_early_end(const EarlyEnd& early, Content& content) {
  if (early.quiet_steps) content[kQuietSteps] = make_scalar(*early.quiet_steps, "1");
  if (early.arrived_below) content[kArrivedBelow] = make_scalar(*early.arrived_below, "1");
  if (early.spanned && !early.quiet_steps) content[kUntilSpanned] = make_truth(true);
  if (early.rupture_of) content[kUntilRuptureOf] = make_scalar(*early.rupture_of, "1");
  if (early.quiet_time) content[kQuietTime] = make_scalar(*early.quiet_time, "s");
}

std::optional<double> read_if_there(const Content& content, const char* path) {
  if (!content.contains(path)) return std::nullopt;
  return read_scalar<double>(content, path);
}

EarlyEnd read_early_end(const Content& content, const Parameters& p) {
  EarlyEnd early;
  if (content.contains(kQuietSteps))
    early.quiet_steps = read_between(content, kQuietSteps, 0, kMost);
  early.arrived_below = read_if_there(content, kArrivedBelow);
  early.quiet_time = read_if_there(content, kQuietTime);
  early.spanned = early.quiet_steps.has_value() ||
                  (content.contains(kUntilSpanned) && read_truth(content, kUntilSpanned));
  if (content.contains(kUntilRuptureOf))
    early.rupture_of = read_between(content, kUntilRuptureOf, 0, p.Nx - 1);
  return early;
}

}  // namespace

Content run_content(const RunSoFar& run) {
  Content content;
  content[kFirstStep] = make_scalar(run.first_step, "1");
  content[kLastBreak] = make_scalar(run.last_break, "1");
  content[kRuptures] = make_scalar(run.ruptures, "1");
  content[kLeadingEdge] = make_truth(run.leading_edge_ruptured);
  content.merge(event_content(run.event));
  if (!run.event.first.empty()) content[kSpanned] = make_truth(run.spanned);
  write_early_end(run.early, content);
  if (!run.id.empty()) content[kId] = make_text(run.id);
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
  if (content.contains(kId)) run.id = read_text(content, kId);
  run.early = read_early_end(content, p);
  return run;
}

LatestEvent read_event(const Content& content, const Parameters& p) {
  LatestEvent event;
  if (!content.contains(kEvent)) return event;
  event.last_rupture = read_scalar<double>(content, kLastRupture);
  for (const double t : read_array<double>(content, kEvent, {static_cast<std::uint64_t>(p.Nx)})) {
    if (t != kNoRupture && !(t >= 0.0 && t <= event.last_rupture)) {
      fail("{} holds {}; expected 0 to {} = {}, or {} for no rupture", kEvent, t, kLastRupture,
           event.last_rupture, kNoRupture);
    }
    event.first.push_back(t == kNoRupture ? std::nullopt : std::optional(t));
  }
  return event;
}

Content recorded_run_content(const RecordedRun& run, const LatestEvent& before) {
  Content content = event_content(before);
  if (run.id.empty()) return content;
  content[kId] = make_text(run.id);
  content[kRecordEvery] = make_scalar(run.every, "s");
  if (run.fields_every) content[kFieldsEvery] = make_scalar(*run.fields_every, "s");
  if (run.every_in_events) content[kEveryInEvents] = make_scalar(*run.every_in_events, "s");
  if (run.quiet_time) content[kQuietTime] = make_scalar(*run.quiet_time, "s");
  return content;
}

RecordedRun read_recorded_run(const Content& content) {
  if (!content.contains(kId)) return {};
  return {read_text(content, kId), read_scalar<double>(content, kRecordEvery),
          read_if_there(content, kFieldsEvery), read_if_there(content, kEveryInEvents),
          read_if_there(content, kQuietTime)};
}

}  // namespace rupture
