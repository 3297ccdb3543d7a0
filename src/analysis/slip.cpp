#include "rupture/analysis/slip.hpp"

#include <algorithm>

#include "rupture/model/derived.hpp"

namespace rupture {
namespace {

constexpr double kFitFrom = 0.2, kFitTo = 0.8;  // of the slow slip

/// First sample at or after t; the number of samples if there is none.
std::size_t index_at(std::span<const double> time, double t) {
  const auto found = std::lower_bound(time.begin(), time.end(), t);
  return static_cast<std::size_t>(found - time.begin());
}

double speed_after(const SlipHistory& h, std::size_t n) {
  return (h.u_x[n + 1] - h.u_x[n]) / (h.time[n + 1] - h.time[n]);
}

/// First sample from `from` on at which the displacement has reached u.
std::size_t first_reaching(const SlipHistory& h, std::size_t from, double u) {
  std::size_t n = from;
  while (n + 1 < h.u_x.size() && h.u_x[n] < u) ++n;
  return n;
}

/// First sample after t_rupture at which a block that has moved forwards stops.
std::optional<std::size_t> arrest(const SlipHistory& h, double t_rupture) {
  bool moved = false;
  for (std::size_t n = index_at(h.time, t_rupture); n + 1 < h.time.size(); ++n) {
    const bool moves = speed_after(h, n) > 0.0;
    if (moved && !moves) return n;
    moved = moves;
  }
  return std::nullopt;
}

/// First and last sample of the part of the slip from sample `first` to the end that is fitted.
struct FittedPart {
  std::size_t from, to;
};

FittedPart fitted_part(const SlipHistory& h, std::size_t first) {
  const double start = h.u_x[first], slip = h.u_x.back() - start;
  return {first_reaching(h, first, start + kFitFrom * slip),
          first_reaching(h, first, start + kFitTo * slip)};
}

std::optional<LineFit> fit(const SlipHistory& h, const FittedPart& part) {
  const std::size_t count = part.to - part.from + 1;
  return fit_line(h.time.subspan(part.from, count), h.u_x.subspan(part.from, count));
}

}  // namespace

std::optional<SlipMeasure> measure_slip(const SlipHistory& h, double t_rupture, double fast_above) {
  const auto stop = arrest(h, t_rupture);
  if (!stop) return std::nullopt;
  SlipMeasure m{};
  const double u_arrest = h.u_x[*stop];
  m.t_arrest = h.time[*stop];
  m.fast_slip = u_arrest - h.u_x.front();
  std::size_t last = *stop;
  while (last + 1 < h.time.size() && speed_after(h, last) <= fast_above) ++last;
  m.t_end = h.time[last];
  m.slow_slip = h.u_x[last] - u_arrest;
  const SlipHistory until = {h.time.first(last + 1), h.u_x.first(last + 1)};
  const FittedPart part = fitted_part(until, *stop);
  m.t_from = h.time[part.from];
  m.t_to = h.time[part.to];
  m.slow = fit(until, part);
  return m;
}

std::optional<SlowSlipTime> slow_slip_time(const Parameters& p, const Front& front,
                                           std::size_t block, const SlowSlipCriteria& criteria) {
  const auto& t_rupture = front.line.t_rupture[block];
  if (!front.slow || !t_rupture) return std::nullopt;
  const double t_R = mean_slipping_time(p, static_cast<std::int64_t>(block));
  SlowSlipTime time{};
  time.from = std::max(*t_rupture, front.slow->t_from) + p.H / shear_wave_speed(p);
  time.to = std::min(front.slow->t_to, time.from + criteria.longest * t_R);
  if (time.to - time.from < criteria.shortest * t_R) return std::nullopt;
  return time;
}

std::vector<std::size_t> slow_blocks(const Front& front) {
  std::vector<std::size_t> blocks;
  if (!front.slow) return blocks;
  const auto& x = front.line.x;
  const std::size_t h = front.criteria.half_stencil();
  for (std::size_t i = h; i + h < x.size(); ++i) {
    if (x[i - h] >= front.slow->x_from && x[i + h] <= front.slow->x_to) blocks.push_back(i);
  }
  return blocks;
}

std::optional<LineFit> fit_slow_slip(const SlipHistory& h, const SlowSlipTime& time) {
  const std::size_t from = index_at(h.time, time.from), end = index_at(h.time, time.to);
  if (end < from + 3) return std::nullopt;
  const SlipHistory part = {h.time.subspan(from, end - from), h.u_x.subspan(from, end - from)};
  return fit(part, fitted_part(part, 0));
}

}  // namespace rupture
