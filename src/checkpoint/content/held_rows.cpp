// The samples that a growing record holds apart, put in their places.
#include "checkpoint/content/record_layout.hpp"

namespace rupture {
namespace {

namespace layout = record_layout;

struct RowOfPart {
  bool is_held;
  std::size_t row;
};
using Places = std::map<std::int64_t, RowOfPart>;  // of rows, by step

// The series, of which `held` has so many samples.
void put_between(Content& record, const Content& held, std::size_t held_samples,
                 const Places& places) {
  layout::for_each(layout::kSeries, [&](const auto& column) {
    Dataset& others = record.at(column.path);
    Shape shape = others.shape;
    shape[0] = held_samples;
    const Dataset& more = expect(held, kHeld + std::string(column.path), others.type, shape);
    const std::size_t size = more.bytes.size() / held_samples;  // of a row
    std::vector<std::byte> bytes;
    bytes.reserve(places.size() * size);
    for (const auto& [step, place] : places) {
      const auto& from = place.is_held ? more.bytes : others.bytes;
      const auto values = std::span(from).subspan(place.row * size, size);
      bytes.insert(bytes.end(), values.begin(), values.end());
    }
    others.bytes = std::move(bytes);
    others.shape[0] = places.size();
  });
}

}  // namespace

Content with_spanning_events(Content record) {
  Content held;
  for (auto at = record.lower_bound(kHeld); at != record.end() && at->first.starts_with(kHeld);) {
    held.insert(record.extract(at++));
  }
  const auto held_step = held.find(kHeldSteps);
  if (held_step == held.end() || held_step->second.bytes.empty()) return record;
  const auto steps = read_array<std::int64_t>(held, kHeldSteps, held_step->second.shape);

  const Record others = record_from({FileKind::open_record, "", record});
  RunSoFar run = run_from(others.parameters, 0, others.before);
  run.early.quiet_time = others.run.quiet_time;
  const auto events = which_span(others.parameters, std::move(run), others.ruptures);
  Places places;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (is_in_spanning_event(events, steps[i])) places[steps[i]] = {true, i};
  }
  for (std::size_t i = 0; i < others.step.size(); ++i) places[others.step[i]] = {false, i};
  put_between(record, held, steps.size(), places);
  return record;
}

}  // namespace rupture
