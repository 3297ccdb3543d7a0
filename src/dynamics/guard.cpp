#include "rupture/dynamics/guard.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "rupture/model/derived.hpp"
#include "statics.hpp"

namespace rupture {
namespace {

using Maybe = std::optional<Finding>;

/// Part of the stored energy below which the energy account is not judged: at rest all its terms
/// are rounding.
constexpr double kRest = 1e-6;

Maybe time_step(const Simulation& simulation) {
  const Parameters& p = simulation.parameters();
  const auto most = std::max_element(simulation.p().begin(), simulation.p().end());
  const double limit = stable_time_step(p, *most);
  if (p.dt <= limit) return std::nullopt;
  return Finding{
      Check::time_step, Severity::alarm,
      fmt::format("numerics.dt = {:g} s is unstable at t = {:.7g} s: block {} carries p = {:.4g} "
                  "N, which makes its junctions so stiff that the limit is {:.4g} s; start again "
                  "with a smaller numerics.dt or change the parameters by less",
                  p.dt, simulation.time(), most - simulation.p().begin(), *most, limit)};
}

Maybe lattice(const Simulation& simulation) {
  const auto passed = passed_block(simulation.parameters(), simulation.state());
  if (!passed) return std::nullopt;
  return Finding{Check::lattice, Severity::alarm,
                 fmt::format("block ({}, {}) has passed its neighbour at t = {:.7g} s, which is "
                             "impossible in a solid: lower slider.F_N or raise slider.E",
                             passed->i, passed->j, simulation.time())};
}

Maybe contact(const Simulation& simulation) {
  const Parameters& p = simulation.parameters();
  const Field& u_z = simulation.state().u_z;
  std::int64_t without = 0, first = 0;
  for (std::int64_t i = p.Nx - 1; i >= 0; --i) {
    if (NormalContact(p, i).compression(u_z(i, 0), u_z(i, p.Nz - 1)) > 0.0) continue;
    ++without;
    first = i;
  }
  if (without == 0) return std::nullopt;
  const auto support = parameter_text(p, find_parameter("slider.support"));
  if (without == p.Nx) {
    return Finding{Check::contact, Severity::alarm,
                   fmt::format("no block touches the {} at t = {:.7g} s: nothing carries the load "
                               "of {:g} N; change the parameters by less",
                               support, simulation.time(), p.F_N)};
  }
  return Finding{
      Check::contact, Severity::warning,
      fmt::format("blocks that do not touch the {} at t = {:.7g} s: {} of {}, the first is "
                  "block {}",
                  support, simulation.time(), without, p.Nx, first)};
}

/// Junctions that bear more than they can, and the first of them.
struct Overload {
  std::int64_t count = 0;
  std::int64_t block = 0;
  double f = 0, limit = 0;  // [N]
};

Overload overload(const Simulation& simulation) {
  const Parameters& p = simulation.parameters();
  const Junctions& junctions = simulation.state().junctions;
  Overload result;
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    const double normal = simulation.p()[static_cast<std::size_t>(i)];
    const double u = simulation.state().u_x(i, 0), w = friction_stretch(p, i, normal);
    const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * std::abs(u);
    if (!(w > 0.0)) continue;
    for (Eigen::Index j = 0; j < junctions.attachment.cols(); ++j) {
      const double mu = is_slipping(junctions.repin_time(i, j)) ? p.mu_d[i] : p.mu_s[i];
      const double stretch = std::abs(u - junctions.attachment(i, j));
      if (stretch <= mu * w * (1.0 + 1e-9) + rounding) continue;
      if (result.count++ > 0) continue;
      const double k_ij = junction_stiffness(p, i, normal);
      result.block = i;
      result.f = k_ij * stretch;
      result.limit = k_ij * mu * w;
    }
  }
  return result;
}

/// A step leaves no such junction; a changed or foreign checkpoint may have them.
Maybe strength(const Simulation& simulation, std::int64_t first_step) {
  const Overload found = overload(simulation);
  if (found.count == 0) return std::nullopt;
  const bool at_start = simulation.state().step == first_step;
  return Finding{Check::strength, at_start ? Severity::warning : Severity::alarm,
                 fmt::format("junctions above their strength at t = {:.7g} s: {}, the first in "
                             "block {} with {:.4g} N, where {:.4g} N is the limit; {}",
                             simulation.time(), found.count, found.block, found.f, found.limit,
                             at_start ? "they break or slip in the first step"
                                      : "this is a bug, please report it with the command")};
}

/// The error of the account is relative to what it accounts for: what flowed, or was in motion.
Maybe energy(const Simulation& simulation, const AccountEntry& from, const AccountEntry& to) {
  if (to.step == from.step) return std::nullopt;
  const Energies &before = from.energies, &after = to.energies;
  const double in_motion =
      std::max({before.kinetic, after.kinetic, kRest * (after.total() - after.load)});
  const double error = energy_balance(before, after, to.work - from.work).relative_error(in_motion);
  const double limit = energy_tolerance(to.step - from.step);
  if (error <= limit) return std::nullopt;
  const Parameters& p = simulation.parameters();
  const State& state = simulation.state();
  const RowMajorArray<double> squares = state.v_x.blocks().square() + state.v_z.blocks().square();
  Place place = {0, 0};  // of the fastest block
  squares.maxCoeff(&place.j, &place.i);
  return Finding{
      Check::energy, Severity::alarm,
      fmt::format("the energy account from t = {:.7g} s to {:.7g} s is off by {:.3g} %, where "
                  "{:.2g} % is the limit: numerics.dt = {:g} s is too long for this motion (the "
                  "fastest block, ({}, {}), moves at {:.2g} m/s); start again with a smaller "
                  "numerics.dt or change the parameters by less",
                  time_at(p, state.clock, from.step), simulation.time(), 100.0 * error,
                  100.0 * limit, p.dt, place.i, place.j,
                  std::hypot(state.v_x(place.i, place.j), state.v_z(place.i, place.j)))};
}

}  // namespace

std::vector<Finding> Guard::look(const Simulation& simulation) {
  const AccountEntry now(simulation);
  std::vector<Finding> found;
  for (const Maybe& finding : {time_step(simulation), lattice(simulation), contact(simulation),
                               strength(simulation, start_.step), energy(simulation, last_, now),
                               energy(simulation, start_, now)}) {
    if (!finding) continue;
    const bool is_new = reported_.insert({finding->check, finding->severity}).second;
    if (is_new) found.push_back(*finding);
  }
  last_ = now;
  return found;
}

}  // namespace rupture
