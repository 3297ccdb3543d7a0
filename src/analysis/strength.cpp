#include "rupture/analysis/strength.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace rupture {
namespace {

double uniform_strength(double a) {
  return a <= 0.5 ? 1.0 - a : 1.0 / (4.0 * a);
}

/// The bell of half-width 1 and its first and second integrals, for z in [-1, 1]; what the header
/// calls Q and R serves the tail at y = 1 - |z| from its end.
struct Bell {
  explicit Bell(double z) {
    const double y = 1.0 - std::abs(z);
    const double y3 = y * y * y;
    const double Q = y3 * y * (1.25 - 0.75 * y);
    const double R = y3 * y * y * (0.25 - 0.125 * y);
    phi = y3 * (5.0 - 3.75 * y);
    F = z > 0.0 ? 1.0 - Q : Q;
    H = z > 0.0 ? z + R : R;
  }
  double phi, F, H;
};

double bell_strength(double a) {
  double low = -1.0, high = 1.0;  // phi > a F at low, phi < a F at high
  for (;;) {
    const double z = 0.5 * (low + high);
    if (z <= low || z >= high) break;
    const Bell bell(z);
    (bell.phi > a * bell.F ? low : high) = z;
  }
  const Bell bell(high);
  return std::max(bell.F - a * bell.H, 0.0);  // rounding only: it may be 1e-60
}

/// Sum of min(f + stretch, f_slip) over slipping junctions, for stretches that only grow.
class SlippingJunctions {
 public:
  SlippingJunctions(std::vector<double> forces, double f_slip)
      : forces_(std::move(forces)),
        f_slip_(f_slip),
        lagging_(std::accumulate(forces_.begin(), forces_.end(), 0.0)) {
    std::sort(forces_.begin(), forces_.end());
  }
  double friction(double stretch) {
    while (!forces_.empty() && forces_.back() + stretch >= f_slip_) {
      lagging_ -= forces_.back();
      forces_.pop_back();
      ++trailing_;
    }
    return trailing_ * f_slip_ + lagging_ + static_cast<double>(forces_.size()) * stretch;
  }

 private:
  std::vector<double> forces_;  // of those below f_slip, ascending
  double f_slip_;               // [N]
  double lagging_;              // sum of forces_ [N]
  double trailing_ = 0.0;       // junctions at f_slip
};

JunctionForces junction_forces(const Junctions& junctions, Eigen::Index i,
                               const BlockForces& block) {
  JunctionForces result{{}, {}, block.f_thres, block.f_slip};
  for (std::size_t j = 0; j < block.forces.size(); ++j) {
    const bool slips = is_slipping(junctions.repin_time(i, static_cast<Eigen::Index>(j)));
    (slips ? result.slipping : result.pinned).push_back(block.forces[j]);
  }
  return result;
}

}  // namespace

double effective_strength(PhiShape shape, double sigma_bar) {
  const double a = sigma_bar / unit_sigma(shape);
  return shape == PhiShape::uniform ? uniform_strength(a) : bell_strength(a);
}

double largest_friction(const JunctionForces& forces) {
  auto pinned = forces.pinned;
  const double sum = std::accumulate(pinned.begin(), pinned.end(), 0.0) +
                     std::accumulate(forces.slipping.begin(), forces.slipping.end(), 0.0);
  if (!std::isfinite(sum)) return sum;  // after an alarm; such numbers have no order
  // rounding can put a junction that is about to break beyond f_thres
  for (double& f : pinned) f = std::min(f, forces.f_thres);
  std::sort(pinned.begin(), pinned.end(), std::greater<>());
  SlippingJunctions slipping(forces.slipping, forces.f_slip);
  double unbroken = std::accumulate(pinned.begin(), pinned.end(), 0.0);
  double largest = static_cast<double>(pinned.size() + forces.slipping.size()) * forces.f_slip;
  for (std::size_t broken = 0; broken < pinned.size(); ++broken) {
    const double stretch = forces.f_thres - pinned[broken];
    const double friction = static_cast<double>(broken) * forces.f_slip + unbroken +
                            static_cast<double>(pinned.size() - broken) * stretch +
                            slipping.friction(stretch);
    largest = std::max(largest, friction);
    unbroken -= pinned[broken];
  }
  return largest;
}

std::vector<BlockStrength> block_strengths(const Parameters& p, const State& state) {
  const auto normal = normal_forces(p, state);
  const auto forces = block_forces(p, state);
  std::vector<BlockStrength> blocks;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const auto junctions =
        junction_forces(state.junctions, static_cast<Eigen::Index>(i), forces[i]);
    BlockStrength block = {forces[i].x, normal[i], largest_friction(junctions), forces[i].slipping};
    const auto column = static_cast<std::int64_t>(i);
    const double mu_d = p.mu_d[column];
    const double tau_slip = mu_d * block.p, range = (p.mu_s[column] - mu_d) * block.p;
    if (range > 0.0) {
      block.sigma_bar = forces[i].sigma_bar();
      block.tau_bar_0 = (forces[i].tau() - tau_slip) / range;
      block.mu_bar_eff = (block.tau_max - tau_slip) / range;
    }
    blocks.push_back(block);
  }
  return blocks;
}

}  // namespace rupture
