#include "rupture/analysis/front.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "rupture/analysis/statistics.hpp"
#include "rupture/model/derived.hpp"

namespace rupture {
namespace {

/// When the front is at each block if it starts at block `from`.
FirstRuptures times_from(const FirstRuptures& t_rupture, std::size_t from) {
  FirstRuptures times(t_rupture.size());
  double latest = *t_rupture[from];
  const auto reach = [&](std::size_t i) {
    if (t_rupture[i]) times[i] = latest = std::max(latest, *t_rupture[i]);
  };
  for (std::size_t i = from; i < times.size(); ++i) reach(i);
  latest = *t_rupture[from];
  for (std::size_t i = from; i-- > 0;) reach(i);
  return times;
}

/// Blocks from `first` on that ruptured before the front was there.
std::size_t count_ahead(const FirstRuptures& t_rupture, const FirstRuptures& times,
                        std::size_t first) {
  std::size_t ahead = 0;
  for (std::size_t i = first; i < times.size(); ++i) ahead += t_rupture[i] < times[i] ? 1 : 0;
  return ahead;
}

/// The speeds of the stencils that run forwards.
std::vector<double> speeds(const Front& front, std::size_t from, std::size_t to) {
  std::vector<double> values;
  for (std::size_t i = from; i < to; ++i) {
    if (front.v_c[i].value_or(0.0) > 0.0) values.push_back(*front.v_c[i]);
  }
  return values;
}

/// Whether the stencil around block i is beyond the loading zone, with v_c in an open interval
/// [m/s].
bool is_between(double from, double to, const Front& front, std::size_t i) {
  const auto& v = front.v_c[i];
  return front.line.x[i] > front.criteria.skip_below_x && v && *v > from && *v < to;
}

/// Centres of slow stencils, in order.
using Stretch = std::vector<std::size_t>;

/// Whether a stretch up to block `last` goes on to the slow stencil at block i: none between them
/// has a speed, and the front is at one block after the other.
bool goes_on(const Front& front, std::size_t last, std::size_t i) {
  std::size_t before = last;
  for (std::size_t next = last + 1; next <= i; ++next) {
    if (next < i && front.v_c[next]) return false;
    if (!front.t_front[next]) continue;
    if (*front.t_front[next] < *front.t_front[before]) return false;
    before = next;
  }
  return true;
}

std::vector<Stretch> slow_stretches(const Front& front, double limit) {
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < front.v_c.size(); ++i) {
    if (!is_between(0.0, limit, front, i)) continue;
    if (stretches.empty() || !goes_on(front, stretches.back().back(), i)) stretches.push_back({});
    stretches.back().push_back(i);
  }
  return stretches;
}

/// The first block that is not in the loading zone.
std::size_t first_beyond(const Front& front) {
  const auto& x = front.line.x;
  return static_cast<std::size_t>(std::ranges::upper_bound(x, front.criteria.skip_below_x) -
                                  x.begin());
}

SlowStretch describe(const Front& front, const Stretch& stretch) {
  const std::size_t h = front.criteria.half_stencil();
  const std::size_t first = stretch.front(), last = stretch.back();
  std::vector<double> v_c;
  for (const std::size_t i : stretch) v_c.push_back(*front.v_c[i]);
  SlowStretch slow;
  slow.x_from = front.line.x[first];
  slow.x_to = front.line.x[last];
  slow.t_from = *front.t_front[first];
  slow.t_to = *front.t_front[last];
  slow.speed = *median(v_c);
  slow.stencils = stretch.size();
  slow.slowest = std::ranges::min(v_c);
  slow.fast_before = median(speeds(front, first_beyond(front), first - h));
  slow.fast_after = median(speeds(front, last + h + 1, front.v_c.size()));
  return slow;
}

/// The slow stretch that lasted longest.
std::optional<SlowStretch> longest(const Front& front, double limit) {
  std::optional<SlowStretch> longest;
  for (const Stretch& stretch : slow_stretches(front, limit)) {
    const auto slow = describe(front, stretch);
    if (!longest || slow.t_to - slow.t_from > longest->t_to - longest->t_from) longest = slow;
  }
  return longest;
}

/// Stencils beyond the loading zone with v_c in an open interval [m/s].
std::size_t stencils_between(double from, double to, const Front& front) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < front.v_c.size(); ++i) {
    if (is_between(from, to, front, i)) ++found;
  }
  return found;
}

/// Whether a front that spans is fast, slow, and fast again.
Answer is_fast_slow_fast(const Front& front, double limit) {
  const auto& slow = front.in_words;
  if (!slow || slow->stencils < kStencilsInWords) return Answer::no;
  if (slow->fast_after.value_or(0.0) < limit) return Answer::no;
  if (!slow->fast_before && front.line.ruptured_before() > 0) return Answer::unknown;
  return slow->fast_before.value_or(0.0) >= limit ? Answer::yes : Answer::no;
}

/// The first rupture of each block at times in [from, to] [s].
FirstRuptures first_ruptures(const Parameters& p, std::span<const Rupture> ruptures, double from,
                             double to) {
  FirstRuptures first(static_cast<std::size_t>(p.Nx));
  for (const Rupture& rupture : ruptures) {
    auto& t = first[static_cast<std::size_t>(rupture.block)];
    if (rupture.time < from || rupture.time > to) continue;
    if (!t || rupture.time < *t) t = rupture.time;
  }
  return first;
}

/// The first rupture of each block in the event, before the window or in it.
FirstRuptures whole_event(const RuptureLine& line) {
  FirstRuptures first = line.t_rupture;
  for (std::size_t i = 0; i < line.before.size(); ++i) {
    if (line.before[i]) first[i] = line.before[i];
  }
  return first;
}

bool is_empty(const FirstRuptures& first) {
  return std::ranges::none_of(first, [](const auto& t) { return t.has_value(); });
}

/// The furthest block that ruptured [m].
std::optional<double> furthest(const std::vector<double>& x, const FirstRuptures& first) {
  for (std::size_t i = x.size(); i-- > 0;) {
    if (first[i]) return x[i];
  }
  return std::nullopt;
}

/// Leaves only what is in the window: times after those of the latest block that had ruptured
/// before it.
void forget_before(const FirstRuptures& before, FirstRuptures& times) {
  const auto latest = before.empty() ? std::nullopt : std::ranges::max(before);
  for (auto& t : times) {
    if (t <= latest) t.reset();
  }
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

/// An event with ruptures in the window.
Event describe(const Parameters& p, std::span<const Rupture> ruptures, const LoadingCurve& loading,
               double quiet, const FrontCriteria& criteria) {
  const double from = just_after(loading.time.front());
  const Rupture& first = *std::ranges::lower_bound(ruptures, from, {}, &Rupture::time);
  RuptureLine line = rupture_line(p, ruptures, from, ruptures.back().time);
  Event event;
  event.t_start = first.time;
  event.t_end = ruptures.back().time;
  event.silence = loading.time.back() - event.t_end;
  line.is_over = is_over(event.silence, quiet);
  event.x_first = block_position(p, first.block);
  event.x_last = *furthest(line.x, whole_event(line));
  event.front = measure_front(p, std::move(line), criteria);
  event.F_T_before = force_at(loading, event.t_start);
  event.F_T_after = smallest_force(loading, event.t_start, event.t_end + quiet);
  return event;
}

}  // namespace

std::size_t RuptureLine::ruptured_before() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(before, [](const auto& t) { return t.has_value(); }));
}

RuptureLine rupture_line(const Parameters& p, std::span<const Rupture> ruptures, double from,
                         double to) {
  RuptureLine line = {block_positions(p), first_ruptures(p, ruptures, from, to)};
  line.before = first_ruptures(p, ruptures, 0.0, std::nextafter(from, 0.0));
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    if (line.before[i]) line.t_rupture[i].reset();
  }
  return line;
}

FirstRuptures front_times(const FirstRuptures& t_rupture) {
  FirstRuptures best(t_rupture.size());
  std::size_t fewest = t_rupture.size();
  for (std::size_t from = 0; from < t_rupture.size(); ++from) {
    if (!t_rupture[from]) continue;
    FirstRuptures times = times_from(t_rupture, from);
    const std::size_t ahead = count_ahead(t_rupture, times, 0);
    if (ahead >= fewest) continue;
    fewest = ahead;
    best = std::move(times);
  }
  return best;
}

std::vector<std::optional<double>> front_speed(const std::vector<double>& x,
                                               const FirstRuptures& times,
                                               const FrontCriteria& criteria) {
  const std::size_t h = criteria.half_stencil();
  std::vector<std::optional<double>> v_c(x.size());
  for (std::size_t i = h; i + h < x.size(); ++i) {
    const auto &before = times[i - h], &after = times[i + h];
    if (!times[i] || !before || !after || *before == *after) continue;
    v_c[i] = (x[i + h] - x[i - h]) / (*after - *before);
  }
  return v_c;
}

std::optional<double> SlowStretch::duration() const {
  if (stencils < kStencilsInWords) return std::nullopt;
  return t_to - t_from;
}

std::optional<double> SlowStretch::mean_speed() const {
  if (!duration() || *duration() == 0.0) return std::nullopt;
  return (x_to - x_from) / *duration();
}

std::string_view front_type_name(FrontType type) {
  constexpr std::array<std::string_view, 5> names = {"none", "arrested", "slow", "fast",
                                                     "unfinished"};
  return names.at(static_cast<std::size_t>(type));
}

bool spans(FrontType type) {
  return type == FrontType::slow || type == FrontType::fast;
}

Front measure_front(const Parameters& p, RuptureLine line, const FrontCriteria& criteria) {
  Front front;
  front.criteria = criteria;
  front.line = std::move(line);
  const FirstRuptures ruptured = whole_event(front.line);
  front.t_front = criteria.line == Line::raw ? ruptured : front_times(ruptured);
  front.ahead = count_ahead(ruptured, front.t_front, first_beyond(front));
  forget_before(front.line.before, front.t_front);
  front.v_c = front_speed(front.line.x, front.t_front, criteria);
  front.x_arrest = furthest(front.line.x, ruptured);
  front.reached_edge = ruptured.back().has_value();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  front.backward_stencils = stencils_between(-kInfinity, 0.0, front);
  front.speed = median(speeds(front, first_beyond(front), front.v_c.size()));
  const double c_s = shear_wave_speed(p), limit = criteria.slow_below * c_s;
  front.slow = longest(front, limit);
  front.in_words = longest(front, kSlowInWords * c_s);
  const bool has_spanned = spans(p, ruptured, criteria.skip_below_x);
  if (has_spanned || !front.line.is_over) front.x_arrest.reset();
  if (!has_spanned && !front.line.is_over) {
    front.type = FrontType::unfinished;
    front.fast_slow_fast = Answer::unknown;
  }
  if (front.x_arrest) front.type = FrontType::arrested;
  if (!has_spanned) return front;
  if (is_empty(front.line.t_rupture)) return front;
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

double just_after(double time) {
  return std::nextafter(time, std::numeric_limits<double>::infinity());
}

std::vector<Event> find_events(const Parameters& p, std::span<const Rupture> ruptures,
                               const LoadingCurve& loading, double quiet,
                               const FrontCriteria& criteria) {
  std::vector<Event> events;
  for (const auto part : split_at_pauses(ruptures, quiet)) {
    if (part.back().time <= loading.time.front()) continue;
    events.push_back(describe(p, part, loading, quiet, criteria));
  }
  return events;
}

}  // namespace rupture
