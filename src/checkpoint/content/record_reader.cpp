#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "checkpoint/content/context.hpp"
#include "checkpoint/content/record_layout.hpp"
#include "checkpoint/content/state_content.hpp"
#include "rupture/checkpoint/parameters_content.hpp"

namespace rupture {
namespace {

namespace layout = record_layout;

// Rows that a dataset has; 0 if it is missing or no array, which reading it will complain about.
std::uint64_t rows_in(const Content& content, const std::string& path) {
  const auto found = content.find(path);
  return found == content.end() || found->second.shape.empty() ? 0 : found->second.shape[0];
}

// Whether the record holds a part that it may lack; one is there or not as a whole.
bool has(const Content& content, const std::string& group) {
  return std::ranges::any_of(content,
                             [&](const auto& entry) { return entry.first.starts_with(group); });
}

// Copies the rows of a table whose step is at most `last`; those of the group that are held, too.
void copy_rows(const Content& from, const std::string& group, const auto& table, std::int64_t last,
               Content& to, const std::string& held = "") {
  if (!has(from, held + group)) return;
  const std::string steps = held + group + "step";
  const auto step = read_array<std::int64_t>(from, steps, {rows_in(from, steps)});
  const auto length =
      static_cast<std::uint64_t>(std::upper_bound(step.begin(), step.end(), last) - step.begin());
  layout::for_each(table, [&](const auto& row) {
    Dataset& dataset = to[held + row.path] = from.at(held + row.path);
    if (step.empty()) return;
    dataset.bytes.resize(dataset.bytes.size() / step.size() * length);
    dataset.shape[0] = length;
  });
}

template <class T>
void read(const Content& content, const char* path, std::uint64_t rows, std::int64_t,
          std::vector<T>& values) {
  values = read_array<T>(content, path, {rows});
}

template <class Array>
void read(const Content& content, const char* path, std::uint64_t rows, std::int64_t Nx,
          Array& values) {
  const Shape shape = {rows, static_cast<std::uint64_t>(Nx)};
  const auto elements = read_array<typename Array::Scalar>(content, path, shape);
  values = Array::Map(elements.data(), static_cast<Eigen::Index>(rows), Nx);
}

std::vector<Rupture> read_ruptures(const Content& content, const std::string& group,
                                   const auto& table, std::int64_t Nx) {
  std::vector<Rupture> ruptures(rows_in(content, group + "time"));
  layout::for_each(table, [&](const auto& row) {
    using T = std::remove_reference_t<decltype(ruptures[0].*row.member)>;
    const auto values = read_array<T>(content, row.path, {ruptures.size()});
    for (std::size_t i = 0; i < ruptures.size(); ++i) ruptures[i].*row.member = values[i];
  });
  for (std::size_t i = 0; i < ruptures.size(); ++i) {
    if (const std::int64_t block = ruptures[i].block; block < 0 || block >= Nx) {
      fail("{}block holds {} at index {}; expected a block from 0 to {}", group, block, i, Nx - 1);
    }
  }
  return ruptures;
}

void read_crossings(const Content& content, Record& record) {
  if (!has(content, layout::kCrossingsGroup)) return;
  const char* const levels = layout::kCrossingLevels;
  record.crossing_levels = read_array<double>(content, levels, {rows_in(content, levels)});
  record.crossings =
      read_ruptures(content, layout::kCrossingsGroup, layout::kCrossings, record.parameters.Nx);
}

// Their values stay where they are: they are for other programs.
void read_fields(const Content& content, Record& record) {
  if (!has(content, layout::kFieldsGroup)) return;
  const std::string steps = layout::kFieldsGroup + std::string("step");
  const std::uint64_t n = rows_in(content, steps);
  const FieldSample empty;
  layout::for_each(layout::kFields, [&](const auto& row) {
    const auto& entry = empty.*row.member;
    expect(content, row.path, layout::type_of(entry),
           layout::shape_of(entry, n, record.parameters));
  });
  record.field_step = read_array<std::int64_t>(content, steps, {n});
}

void refuse_foreign(const Content& content, const Record& record) {
  std::map<std::string, std::string> units;
  for (const auto& [path, dataset] : recorded_run_content(record.run, record.before))
    units[path] = dataset.unit;
  layout::for_each_dataset([&](const auto& row) { units[row.path] = row.unit; });
  for (const auto& [path, dataset] : content) {
    if (path.starts_with("/parameters/") || path.starts_with("/provenance/")) continue;
    const auto known = units.find(path);
    if (known == units.end()) {
      fail(
          "{} is not part of a record: use a newer rupture, or remove it if another "
          "program added it",
          path);
    }
    if (dataset.unit == known->second) continue;
    fail("{} has the unit '{}'; expected '{}'", path, dataset.unit, known->second);
  }
}

void check_ascending(const char* group, const std::vector<std::int64_t>& step) {
  const auto misplaced = std::adjacent_find(step.begin(), step.end(), std::greater_equal());
  if (misplaced == step.end()) return;
  fail("{}step holds {} and then {}; expected ascending steps", group, misplaced[0], misplaced[1]);
}

// Restarts may have moved the origins of time and driving point, so that only what was gained since
// the first sample follows from the steps. Rounding is far below the gain of one step.
void check_pace(const Content& content, const std::string& group, const std::string& name,
                double per_step, const Record& record) {
  const std::uint64_t n = record.step.empty() ? 0 : rows_in(content, group + name);
  if (n == 0) return;
  const auto value = read_array<double>(content, group + name, {n});
  const auto step = read_array<std::int64_t>(content, group + "step", {n});
  const double first = (name == "time" ? record.time : record.x_drive)[0];
  for (std::size_t i = 0; i < n; ++i) {
    const double steps = static_cast<double>(step[i]) - static_cast<double>(record.step[0]);
    const double expected = first + steps * per_step;
    const double rounding = 1e-15 * std::max(std::abs(first), std::abs(expected));
    if (std::abs(value[i] - expected) <= 1e-3 * std::abs(per_step) + rounding) continue;
    fail("{}{} holds {} at step {}; by the parameters it is {} there", group, name, value[i],
         step[i], expected);
  }
}

// A run notes ruptures from its first sample on by step, level and block.
void check_order(const char* group, const std::vector<Rupture>& ruptures, const Record& record) {
  const auto place = [](const Rupture& r) { return std::tuple(r.step, r.pinned_below, r.block); };
  auto last = std::tuple(record.step.empty() ? 0 : record.step[0], 0.0, std::int64_t{-1});
  for (const Rupture& rupture : ruptures) {
    if (last >= place(rupture)) {
      fail(
          "{}step holds {} after {}, for block {}; expected ascending steps, "
          "not before the first sample, and ascending blocks in each",
          group, rupture.step, std::get<0>(last), rupture.block);
    }
    last = place(rupture);
  }
}

// A block that is above a fraction in one sample and below it in the next has fallen in between.
void check_falls(const Record& record, const char* group, const std::vector<Rupture>& ruptures,
                 double fraction) {
  const double limit = pinned_limit(record.parameters, fraction);
  // Earlier builds could count a block at the limit as below it.
  const double above = fraction * static_cast<double>(springs_per_block(record.parameters));
  Eigen::ArrayX<Eigen::Index> fell = Eigen::ArrayX<Eigen::Index>::Zero(record.parameters.Nx);
  auto next = ruptures.begin();
  for (Eigen::Index n = 0; n < record.pinned.rows(); ++n) {
    const std::int64_t step = record.step[static_cast<std::size_t>(n)];
    for (; next != ruptures.end() && next->step <= step; ++next) {
      if (next->pinned_below == fraction) fell(next->block) = n;
    }
    for (Eigen::Index i = 0; n > 0 && i < fell.size(); ++i) {
      const bool falls = record.pinned(n - 1, i) >= above && record.pinned(n, i) < limit;
      if (!falls || fell(i) == n) continue;
      fail("{} lacks block {}, whose pinned fraction falls below {} by step {}", group, i, fraction,
           step);
    }
  }
}

void check_levels(const Record& record) {
  const auto& levels = record.crossing_levels;
  const auto strange = [](double f) { return f <= 0.0 || f > 1.0 || f == kRupturedFraction; };
  if (std::ranges::any_of(levels, strange) ||
      std::ranges::adjacent_find(levels, std::greater_equal()) != levels.end()) {
    fail("{} holds {}; expected ascending fractions up to 1, without {}", layout::kCrossingLevels,
         fmt::join(levels, ", "), kRupturedFraction);
  }
  for (const Rupture& crossing : record.crossings) {
    if (std::binary_search(levels.begin(), levels.end(), crossing.pinned_below)) continue;
    fail("/crossings/pinned_below holds {}; expected one of the levels {}", crossing.pinned_below,
         fmt::join(levels, ", "));
  }
}

// Datasets must agree with each other and with the parameters.
void check_consistent(const Content& content, const Record& record) {
  const Parameters& p = record.parameters;
  const auto most = springs_per_block(p);
  if (record.pinned.size() > 0 && record.pinned.maxCoeff() > most) {
    fail("/series/pinned holds {}; expected {} at most", record.pinned.maxCoeff(), most);
  }
  check_ascending(layout::kSeriesGroup, record.step);
  check_ascending(layout::kFieldsGroup, record.field_step);
  check_order(layout::kRupturesGroup, record.ruptures, record);
  check_order(layout::kCrossingsGroup, record.crossings, record);
  for (const auto* group : {layout::kSeriesGroup, layout::kRupturesGroup, layout::kCrossingsGroup,
                            layout::kFieldsGroup}) {
    check_pace(content, group, "time", p.dt, record);
  }
  check_pace(content, layout::kSeriesGroup, "x_drive", p.V * p.dt, record);
  check_falls(record, layout::kRupturesGroup, record.ruptures, kRupturedFraction);
  check_levels(record);
  for (const double level : record.crossing_levels) {
    check_falls(record, layout::kCrossingsGroup, record.crossings, level);
  }
}

}  // namespace

Record record_from(const ContentFile& file) {
  const Content& content = file.content;
  if (file.kind == FileKind::open_record && has(content, kHeld)) {
    return record_from({file.kind, "", with_spanning_events(content)});
  }
  Record record;
  record.run = read_recorded_run(content);
  record.parameters = read_parameters(content);
  record.before = read_event(content, record.parameters);
  refuse_foreign(content, record);
  expect_as_written(content, record_positions(record.parameters, content));
  record.provenance = read_provenance(content);
  const std::uint64_t samples = rows_in(content, "/series/time");
  layout::for_each(layout::kSeries, [&](const auto& row) {
    read(content, row.path, samples, record.parameters.Nx, record.*row.in_record);
  });
  record.ruptures =
      read_ruptures(content, layout::kRupturesGroup, layout::kRuptures, record.parameters.Nx);
  read_crossings(content, record);
  read_fields(content, record);
  check_consistent(content, record);
  return record;
}

Content rows_until(const Content& record, std::int64_t step) {
  Content rows;
  copy_rows(record, layout::kSeriesGroup, layout::kSeries, step, rows);
  copy_rows(record, layout::kRupturesGroup, layout::kRuptures, step, rows);
  copy_rows(record, layout::kFieldsGroup, layout::kFields, step, rows);
  copy_rows(record, layout::kCrossingsGroup, layout::kCrossings, step, rows);
  copy_rows(record, layout::kSeriesGroup, layout::kSeries, step, rows, kHeld);
  return rows;
}

Content finished_content(const RecordFile& part, const std::vector<ProvenanceEntry>& provenance) {
  Content whole = provenance_content(provenance), content = with_spanning_events(part.content);
  whole.merge(rows_until(content, part.record.step.back()));
  whole.merge(std::move(content));  // what has no rows
  return whole;
}

namespace {

/// The latest event before the first sample, of blocks below this fraction.
LatestEvent event_before(const Record& record, double fraction) {
  LatestEvent event = record.before;
  const Parameters& p = record.parameters;
  if (record.time.empty() || fraction == kRupturedFraction) return event;
  const double now = record.time[0], limit = pinned_limit(p, fraction);
  const bool is_under_way = event.is_under_way(now, pause_between_events(p));
  for (std::size_t i = 0; i < event.first.size(); ++i) {
    const auto block = static_cast<Eigen::Index>(i);
    const double pinned = record.pinned(0, block);
    auto& t = event.first[i];
    const bool is_recent = t && now - *t < 0.5 * p.t_R[block];
    if (is_recent && pinned >= limit) t.reset();
    const bool has_ruptured = t || pinned < pinned_limit(p, kRupturedFraction);
    if (is_under_way && !has_ruptured && pinned < limit) t = now;
  }
  return event;
}

/// As ruptures in order of time, and the last one, by a block that had ruptured.
std::vector<Rupture> ruptures_of(const LatestEvent& event) {
  std::vector<Rupture> ruptures;
  for (std::size_t i = 0; i < event.first.size(); ++i) {
    if (event.first[i]) ruptures.push_back({0, *event.first[i], static_cast<std::int64_t>(i)});
  }
  std::ranges::stable_sort(ruptures, {}, &Rupture::time);
  if (!ruptures.empty()) ruptures.push_back({0, event.last_rupture, ruptures.front().block});
  return ruptures;
}

/// Those in the record.
std::vector<Rupture> recorded_below(const Record& record, double fraction) {
  if (fraction == kRupturedFraction) return record.ruptures;
  const auto& levels = record.crossing_levels;
  if (std::find(levels.begin(), levels.end(), fraction) == levels.end()) {
    std::vector<double> held = levels;
    held.push_back(kRupturedFraction);
    fail(
        "the record has no crossings of a pinned fraction of {}, only of {}: record it with "
        "--crossings {}",
        fraction, fmt::join(held, ", "), fraction);
  }
  std::vector<Rupture> ruptures;
  for (const Rupture& crossing : record.crossings) {
    if (crossing.pinned_below == fraction) ruptures.push_back(crossing);
  }
  return ruptures;
}

}  // namespace

std::vector<Rupture> ruptures_below(const Record& record, double fraction) {
  std::vector<Rupture> ruptures = ruptures_of(event_before(record, fraction));
  const auto recorded = recorded_below(record, fraction);
  ruptures.insert(ruptures.end(), recorded.begin(), recorded.end());
  return ruptures;
}

}  // namespace rupture
