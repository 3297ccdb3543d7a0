// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

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

std::int64_t read_between(const Content& content, const char* path, std::int64_t least,
                          std::int64_t most) {
  const auto value = read_scalar<std::int64_t>(content, path);
  if (value >= least && value <= most) return value;
  throw Failure(fmt::format("{} = {}; expected {} to {}", path, value, least, most));
}

}  // namespace

Content run_content(const RunSoFar& run, const std::string& id) {
  Content content;
  content[kFirstStep] = make_scalar(run.first_step, "1");
  content[kLastBreak] = make_scalar(run.last_break, "1");
  content[kRuptures] = make_scalar(run.ruptures, "1");
  content[kLeadingEdge] = make_scalar<std::uint8_t>(run.leading_edge_ruptured ? 1 : 0, "1");
  if (!id.empty()) content[kId] = make_text(id);
  return content;
}

std::optional<RunSoFar> read_run(const Content& content, std::int64_t step) {
  const bool present = std::any_of(content.begin(), content.end(), [](const auto& entry) {
    return entry.first.starts_with("/run/");
  });
  if (!present) return std::nullopt;
  RunSoFar run;
  run.first_step = read_between(content, kFirstStep, 0, step);
  run.last_break = read_between(content, kLastBreak, run.first_step, step);
  run.ruptures = read_between(content, kRuptures, 0, std::numeric_limits<std::int64_t>::max());
  const auto edge = read_scalar<std::uint8_t>(content, kLeadingEdge);
  if (edge > 1) throw Failure(fmt::format("{} = {}; expected 0 or 1", kLeadingEdge, edge));
  run.leading_edge_ruptured = edge == 1;
  return run;
}

std::string read_run_id(const Content& content) {
  return content.contains(kId) ? read_text(content, kId) : std::string();
}

}  // namespace rupture
