#include "rupture/analysis/front.hpp"

#include <algorithm>

#include "rupture/analysis/statistics.hpp"
#include "rupture/model/derived.hpp"

namespace rupture {
namespace {

constexpr std::size_t kHalfStencil = 2;  // blocks on either side of a five-block stencil

std::vector<double> speeds(const std::vector<std::optional<double>>& v_c, std::size_t from,
                           std::size_t to) {
  std::vector<double> values;
  for (std::size_t i = from; i < to; ++i) {
    if (v_c[i]) values.push_back(*v_c[i]);
  }
  return values;
}

/// Blocks first..last (inclusive) of one run of slow stencils.
struct Stretch {
  std::size_t first, last;
};

/// Maximal runs of slow stencils whose blocks rupture one after the other.
std::vector<Stretch> slow_stretches(const Front& front, double limit, double skip_below_x) {
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < front.v_c.size(); ++i) {
    const auto& v = front.v_c[i];
    if (front.line.x[i] <= skip_below_x || !v || *v <= 0.0 || *v >= limit) continue;
    const bool next = !stretches.empty() && stretches.back().last + 1 == i;
    if (next && *front.line.t_rupture[i] >= *front.line.t_rupture[i - 1]) {
      stretches.back().last = i;
    } else {
      stretches.push_back({i, i});
    }
  }
  return stretches;
}

double duration(const RuptureLine& line, const Stretch& stretch) {
  return *line.t_rupture[stretch.last] - *line.t_rupture[stretch.first];
}

SlowStretch describe(const Front& front, const Stretch& stretch, double skip_below_x) {
  const auto loading_zone = static_cast<std::size_t>(
      std::upper_bound(front.line.x.begin(), front.line.x.end(), skip_below_x) -
      front.line.x.begin());
  SlowStretch slow;
  slow.x_from = front.line.x[stretch.first];
  slow.x_to = front.line.x[stretch.last];
  slow.t_from = *front.line.t_rupture[stretch.first];
  slow.t_to = *front.line.t_rupture[stretch.last];
  slow.speed = *median(speeds(front.v_c, stretch.first, stretch.last + 1));
  // a stencil that straddles a transition measures neither the slow nor the fast speed
  slow.fast_before = median(speeds(front.v_c, loading_zone, stretch.first - kHalfStencil));
  slow.fast_after = median(speeds(front.v_c, stretch.last + 1 + kHalfStencil, front.v_c.size()));
  return slow;
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

std::vector<std::optional<double>> front_speed(const RuptureLine& line) {
  std::vector<std::optional<double>> v_c(line.x.size());
  for (std::size_t i = kHalfStencil; i + kHalfStencil < line.x.size(); ++i) {
    const auto& before = line.t_rupture[i - kHalfStencil];
    const auto& after = line.t_rupture[i + kHalfStencil];
    if (!line.t_rupture[i] || !before || !after || *before == *after) continue;
    v_c[i] = (line.x[i + kHalfStencil] - line.x[i - kHalfStencil]) / (*after - *before);
  }
  return v_c;
}

std::string_view front_type_name(FrontType type) {
  switch (type) {
    case FrontType::slow:
      return "slow";
    case FrontType::fast:
      return "fast";
    case FrontType::arrested:
      return "arrested";
    case FrontType::none:
      break;
  }
  return "none";
}

bool spans(FrontType type) {
  return type == FrontType::slow || type == FrontType::fast;
}

Front measure_front(const Parameters& p, RuptureLine line, const FrontCriteria& criteria) {
  Front front;
  front.line = std::move(line);
  front.v_c = front_speed(front.line);
  for (std::size_t i = 0; i < front.line.x.size(); ++i) {
    if (front.line.t_rupture[i]) front.x_arrest = front.line.x[i];
  }
  if (front.x_arrest) front.type = FrontType::arrested;
  const auto stretches =
      slow_stretches(front, criteria.slow_below * shear_wave_speed(p), criteria.skip_below_x);
  const auto longest =
      std::max_element(stretches.begin(), stretches.end(), [&](const Stretch& a, const Stretch& b) {
        return duration(front.line, a) < duration(front.line, b);
      });
  if (longest != stretches.end()) front.slow = describe(front, *longest, criteria.skip_below_x);
  if (front.line.t_rupture.back()) {
    front.x_arrest.reset();
    front.type = front.slow ? FrontType::slow : FrontType::fast;
  }
  return front;
}

}  // namespace rupture
