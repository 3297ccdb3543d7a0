#include "rupture/analysis/slip.hpp"

namespace rupture {
namespace {

constexpr double kFitFrom = 0.2, kFitTo = 0.8;  // of the slow slip

/// First sample at or after t; the number of samples if there is none.
std::size_t index_at(std::span<const double> time, double t) {
  std::size_t n = 0;
  while (n < time.size() && time[n] < t) ++n;
  return n;
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

std::optional<std::size_t> arrest(const SlipHistory& h, double t_rupture, double fast_within) {
  std::size_t fastest = index_at(h.time, t_rupture);
  for (std::size_t n = fastest; n + 1 < h.time.size() && h.time[n] <= t_rupture + fast_within;
       ++n) {
    if (speed_after(h, n) > speed_after(h, fastest)) fastest = n;
  }
  for (std::size_t n = fastest; n + 1 < h.time.size(); ++n) {
    if (speed_after(h, n) <= 0.0) return n;
  }
  return std::nullopt;
}

}  // namespace

std::optional<SlipMeasure> measure_slip(const SlipHistory& h, double t_rupture,
                                        double fast_within) {
  const auto stop = arrest(h, t_rupture, fast_within);
  if (!stop) return std::nullopt;
  SlipMeasure m{};
  const double u_arrest = h.u_x[*stop];
  m.t_arrest = h.time[*stop];
  m.fast_slip = u_arrest - h.u_x.front();
  m.slow_slip = h.u_x.back() - u_arrest;
  const std::size_t from = first_reaching(h, *stop, u_arrest + kFitFrom * m.slow_slip);
  const std::size_t to = first_reaching(h, *stop, u_arrest + kFitTo * m.slow_slip);
  m.t_from = h.time[from];
  m.t_to = h.time[to];
  m.slow = fit_line(h.time.subspan(from, to - from + 1), h.u_x.subspan(from, to - from + 1));
  return m;
}

}  // namespace rupture
