#include "run_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "rupture/model/error.hpp"

namespace rupture {
namespace {

constexpr const char* kId = "/run/id";
constexpr const char* kFirstStep = "/run/first_step";
constexpr const char* kLastBreak = "/run/last_break";
constexpr const char* kRuptures = "/run/ruptures";
constexpr const char* kLeadingEdge = "/run/leading_edge_ruptured";
constexpr const char* kEvent = "/run/event";
constexpr const char* kLastRupture = "/run/last_rupture";
constexpr const char* kSpanned = "/run/spanned";

constexpr double kNoRupture = -1.0;

std::int64_t read_between(const Content& content, const char* path, std::int64_t least,
                          std::int64_t most) {
  const auto value = read_scalar<std::int64_t>(content, path);
  if (value >= least && value <= most) return value;
  throw Failure(fmt::format("{} = {}; expected {} to {}", path, value, least, most));
}

Dataset make_truth(bool value) {
  return make_scalar<std::uint8_t>(value ? 1 : 0, "1");
}

bool read_truth(const Content& content, const char* path) {
  const auto value = read_scalar<std::uint8_t>(content, path);
  if (value > 1) throw Failure(fmt::format("{} = {}; expected 0 or 1", path, value));
  return value == 1;
}

void add_event(const RunSoFar& run, Content& content) {
  std::vector<double> times;
  for (const auto& t : run.event) times.push_back(t.value_or(kNoRupture));
  content[kEvent] = make_array<double>(times, {times.size()}, "s");
  content[kLastRupture] = make_scalar(run.last_rupture, "s");
  content[kSpanned] = make_truth(run.spanned);
}

void read_event(const Content& content, const Parameters& p, RunSoFar& run) {
  run.last_rupture = read_scalar<double>(content, kLastRupture);
  run.spanned = read_truth(content, kSpanned);
  for (const double t : read_array<double>(content, kEvent, {static_cast<std::uint64_t>(p.Nx)})) {
    if (t != kNoRupture && !(t >= 0.0 && t <= run.last_rupture)) {
      throw Failure(fmt::format("{} holds {}; expected 0 to {} = {}, or {} for no rupture", kEvent,
                                t, kLastRupture, run.last_rupture, kNoRupture));
    }
    run.event.push_back(t == kNoRupture ? std::nullopt : std::optional(t));
  }
}

}  // namespace

Content run_content(const RunSoFar& run, const std::string& id) {
  Content content;
  content[kFirstStep] = make_scalar(run.first_step, "1");
  content[kLastBreak] = make_scalar(run.last_break, "1");
  content[kRuptures] = make_scalar(run.ruptures, "1");
  content[kLeadingEdge] = make_truth(run.leading_edge_ruptured);
  if (!run.event.empty()) add_event(run, content);
  if (!id.empty()) content[kId] = make_text(id);
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
  run.ruptures = read_between(content, kRuptures, 0, std::numeric_limits<std::int64_t>::max());
  run.leading_edge_ruptured = read_truth(content, kLeadingEdge);
  if (content.contains(kEvent)) read_event(content, p, run);  // builds before it had none
  return run;
}

std::string read_run_id(const Content& content) {
  return content.contains(kId) ? read_text(content, kId) : std::string();
}

}  // namespace rupture
