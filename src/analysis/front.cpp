#include "rupture/analysis/front.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "rupture/analysis/statistics.hpp"
#include "rupture/model/derived.hpp"

namespace rupture {
namespace {

/// How many stencils of what the paper calls slow make a stretch.
constexpr std::size_t kStencilsInWords = 3;

/// Those of the stencils that run forwards.
std::vector<double> speeds(const std::vector<std::optional<double>>& v_c, std::size_t from,
                           std::size_t to) {
  std::vector<double> values;
  for (std::size_t i = from; i < to; ++i) {
    if (v_c[i] && *v_c[i] > 0.0) values.push_back(*v_c[i]);
  }
  return values;
}

/// Blocks first..last (inclusive), centres of stencils.
struct Stretch {
  std::size_t first, last;
};

/// Whether the stencil around block i measures a front that moves on, beyond the loading zone.
bool moves_on(const Front& front, std::size_t i) {
  const auto& v = front.v_c[i];
  return front.line.x[i] > front.criteria.skip_below_x && v && *v > 0.0;
}

/// Whether block i + 1 ruptured after block i; both did.
bool in_order(const Front& front, std::size_t i) {
  return *front.line.t_rupture[i + 1] >= *front.line.t_rupture[i];
}

/// Maximal runs of slow stencils whose blocks rupture one after the other.
std::vector<Stretch> slow_stretches(const Front& front, double limit) {
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < front.v_c.size(); ++i) {
    if (!moves_on(front, i) || *front.v_c[i] >= limit) continue;
    const bool next = !stretches.empty() && stretches.back().last + 1 == i;
    if (next && in_order(front, i - 1)) {
      stretches.back().last = i;
    } else {
      stretches.push_back({i, i});
    }
  }
  return stretches;
}

/// The stretch with up to n more blocks on either side.
Stretch widened(const Front& front, Stretch stretch, std::size_t n) {
  const Stretch limits = {stretch.first - n, stretch.last + n};
  while (stretch.first > limits.first && moves_on(front, stretch.first - 1) &&
         in_order(front, stretch.first - 1)) {
    --stretch.first;
  }
  while (stretch.last < limits.last && moves_on(front, stretch.last + 1) &&
         in_order(front, stretch.last)) {
    ++stretch.last;
  }
  return stretch;
}

/// The centres that belong to the slow stretch around a run of slow stencils; none if it is shorter
/// than a stencil and those that touch its surroundings do not count.
std::optional<Stretch> counted(const Front& front, const Stretch& run, StencilsAtEnds ends) {
  const std::size_t h = front.criteria.half_stencil();
  if (ends == StencilsAtEnds::slow) return widened(front, run, h);
  if (run.last - run.first < 2 * h) return std::nullopt;
  return Stretch{run.first + h, run.last - h};
}

/// The centres between which no stencil belongs to the fast sides.
Stretch not_fast(const Stretch& run, std::size_t h, StencilsAtEnds ends) {
  if (ends == StencilsAtEnds::fast) return {run.first + h, run.last - h};
  return {run.first - h, run.last + h};
}

/// The first block that is not in the loading zone.
std::size_t first_beyond(const Front& front) {
  const auto& x = front.line.x;
  return static_cast<std::size_t>(std::ranges::upper_bound(x, front.criteria.skip_below_x) -
                                  x.begin());
}

std::optional<SlowStretch> describe(const Front& front, const Stretch& run, StencilsAtEnds ends) {
  const auto stretch = counted(front, run, ends);
  if (!stretch) return std::nullopt;
  const auto& x = front.line.x;
  const Stretch between = not_fast(run, front.criteria.half_stencil(), ends);
  const auto v_c = speeds(front.v_c, stretch->first, stretch->last + 1);
  SlowStretch slow;
  slow.x_from = x[stretch->first];
  slow.x_to = x[stretch->last];
  slow.t_from = *front.line.t_rupture[stretch->first];
  slow.t_to = *front.line.t_rupture[stretch->last];
  slow.t_last_stencil = *front.line.t_rupture[run.last];
  slow.speed = *median(v_c);
  slow.stencils = run.last - run.first + 1;
  slow.slowest = std::ranges::min(v_c);
  slow.fast_before = median(speeds(front.v_c, first_beyond(front), between.first));
  slow.fast_after = median(speeds(front.v_c, between.last + 1, front.v_c.size()));
  return slow;
}

/// The slow stretch that lasted longest; none if no block belongs to any.
std::optional<SlowStretch> longest(const Front& front, double limit, StencilsAtEnds ends) {
  std::optional<SlowStretch> longest;
  for (const Stretch& run : slow_stretches(front, limit)) {
    const auto slow = describe(front, run, ends);
    if (slow && (!longest || slow->duration() > longest->duration())) longest = slow;
  }
  return longest;
}

/// Stencils beyond the loading zone with v_c in an open interval [m/s].
std::size_t stencils_between(double from, double to, const Front& front) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < front.v_c.size(); ++i) {
    const auto& v = front.v_c[i];
    if (front.line.x[i] > front.criteria.skip_below_x && v && *v > from && *v < to) ++found;
  }
  return found;
}

/// Of a front that spans.
bool is_fast_slow_fast(const Front& front, double limit) {
  const auto& slow = front.in_words;
  return slow && slow->stencils >= kStencilsInWords && slow->fast_before.value_or(0.0) >= limit &&
         slow->fast_after.value_or(0.0) >= limit;
}

/// Driving force at the last sample not after t; the first sample if all are later.
double force_at(const LoadingCurve& loading, double t) {
  const auto after = std::upper_bound(loading.time.begin(), loading.time.end(), t);
  const auto index = std::max<std::ptrdiff_t>(after - loading.time.begin() - 1, 0);
  return loading.F_T[static_cast<std::size_t>(index)];
}

double smallest_force(const LoadingCurve& loading, double from, double to) {
  double smallest = force_at(loading, from);
  for (std::size_t n = 0; n < loading.time.size(); ++n) {
    if (loading.time[n] >= from && loading.time[n] <= to) {
      smallest = std::min(smallest, loading.F_T[n]);
    }
  }
  return smallest;
}

Event describe(const Parameters& p, std::span<const Rupture> ruptures, const LoadingCurve& loading,
               double quiet, const FrontCriteria& criteria) {
  const auto furthest = std::ranges::max_element(ruptures, {}, &Rupture::block);
  Event event;
  event.t_start = ruptures.front().time;
  event.t_end = ruptures.back().time;
  event.x_first = block_position(p, ruptures.front().block);
  event.x_last = block_position(p, furthest->block);
  event.front = measure_front(p, rupture_line(p, ruptures, event.t_start, event.t_end), criteria);
  event.F_T_before = force_at(loading, event.t_start);
  event.F_T_after = smallest_force(loading, event.t_start, event.t_end + quiet);
  return event;
}

}  // namespace

RuptureLine rupture_line(const Parameters& p, std::span<const Rupture> ruptures, double from,
                         double to) {
  RuptureLine line{block_positions(p), {}};
  line.t_rupture.resize(static_cast<std::size_t>(p.Nx));
  for (const Rupture& rupture : ruptures) {
    auto& t = line.t_rupture[static_cast<std::size_t>(rupture.block)];
    if (rupture.time < from || rupture.time > to) continue;
    if (!t || rupture.time < *t) t = rupture.time;
  }
  return line;
}

std::vector<std::optional<double>> front_speed(const RuptureLine& line,
                                               const FrontCriteria& criteria) {
  const std::size_t h = criteria.half_stencil();
  std::vector<std::optional<double>> v_c(line.x.size());
  for (std::size_t i = h; i + h < line.x.size(); ++i) {
    const auto& before = line.t_rupture[i - h];
    const auto& after = line.t_rupture[i + h];
    if (!line.t_rupture[i] || !before || !after || *before == *after) continue;
    v_c[i] = (line.x[i + h] - line.x[i - h]) / (*after - *before);
  }
  return v_c;
}

std::optional<double> SlowStretch::mean() const {
  if (duration() == 0.0) return std::nullopt;
  return (x_to - x_from) / duration();
}

std::string_view front_type_name(FrontType type) {
  constexpr std::array<std::string_view, 4> names = {"none", "arrested", "slow", "fast"};
  return names.at(static_cast<std::size_t>(type));
}

bool spans(FrontType type) {
  return type == FrontType::slow || type == FrontType::fast;
}

Front measure_front(const Parameters& p, RuptureLine line, const FrontCriteria& criteria) {
  Front front;
  front.criteria = criteria;
  front.line = std::move(line);
  front.v_c = front_speed(front.line, criteria);
  for (std::size_t i = 0; i < front.line.x.size(); ++i) {
    if (front.line.t_rupture[i]) front.x_arrest = front.line.x[i];
  }
  front.reached_edge = front.line.t_rupture.back().has_value();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  front.backward_stencils = stencils_between(-kInfinity, 0.0, front);
  front.speed = median(speeds(front.v_c, first_beyond(front), front.v_c.size()));
  const double c_s = shear_wave_speed(p), limit = criteria.slow_below * c_s;
  front.slow = longest(front, limit, criteria.stencils_at_ends);
  front.in_words = longest(front, kSlowInWords * c_s, StencilsAtEnds::slow);
  if (front.x_arrest) front.type = FrontType::arrested;
  if (!spans(p, front.line.t_rupture, criteria.skip_below_x)) return front;
  front.x_arrest.reset();
  const bool is_slow = stencils_between(-limit, limit, front) > 0;
  front.type = is_slow ? FrontType::slow : FrontType::fast;
  front.fast_slow_fast = is_fast_slow_fast(front, kSlowInWords * c_s);
  return front;
}

std::vector<std::span<const Rupture>> split_at_pauses(std::span<const Rupture> ruptures,
                                                      double quiet) {
  std::vector<std::span<const Rupture>> parts;
  std::size_t first = 0;
  for (std::size_t n = 1; n <= ruptures.size(); ++n) {
    if (n < ruptures.size() && ruptures[n].time - ruptures[n - 1].time <= quiet) continue;
    parts.push_back(ruptures.subspan(first, n - first));
    first = n;
  }
  return parts;
}

std::vector<Event> find_events(const Parameters& p, std::span<const Rupture> ruptures,
                               const LoadingCurve& loading, double quiet,
                               const FrontCriteria& criteria) {
  std::vector<Event> events;
  for (const auto part : split_at_pauses(ruptures, quiet)) {
    events.push_back(describe(p, part, loading, quiet, criteria));
  }
  return events;
}

}  // namespace rupture
