#include "rupture/dynamics/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rupture/forces/interface_law.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/error.hpp"
#include "rupture/model/normal_contact.hpp"
#include "statics.hpp"

namespace rupture {
namespace {

void check_strength(const Parameters& p, const State& state) {
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    const auto friction = interface_forces(p, {}, state, i);
    if (std::abs(friction.tau) <= p.mu_s[i] * friction.p) continue;
    throw Failure(
        "the junctions of block {} cannot bear the normal load: |f|/f_thres = {:.3g} at F_N = {:g} "
        "N; raise junctions.mu_s or slider.foundation, or lower slider.F_N",
        i, std::abs(friction.tau) / (p.mu_s[i] * friction.p), p.F_N);
  }
}

bool in_trigger_region(const Parameters& p, const Prestress& prestress, Eigen::Index i) {
  return block_position(p, i) < prestress.x_trigger;
}

bool is_depinned(const Parameters& p, const Prestress& prestress, Eigen::Index i) {
  return prestress.trigger == Trigger::depinned && in_trigger_region(p, prestress, i);
}

/// f_thres - f_slip of block i [N].
double strength_range(const Parameters& p, Eigen::Index i) {
  return (p.mu_s[i] - p.mu_d[i]) * column_load(p, i) / static_cast<double>(p.N_s);
}

void check_parameters(const Parameters& p) {
  validate(p);
  if (!has_constant_p(p)) {
    throw UsageError("a prepared interface needs slider.support = ceiling");
  }
  if (!(p.K > 0.0)) {
    throw UsageError(
        "driving.K = 0 cannot balance the prestress: give the driving spring a modulus above 0");
  }
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    if (p.mu_d[i] < p.mu_s[i]) continue;
    throw UsageError(
        "junctions.mu_d = junctions.mu_s = {:g} leaves no range for the prestress: lower mu_d",
        p.mu_d[i]);
  }
}

void check_region(const Parameters& p, const Prestress& prestress) {
  const double last = block_position(p, p.Nx - 1);
  if (prestress.x_trigger >= 0.0 && prestress.x_trigger <= last) return;
  throw UsageError(
      "--x-trigger must be from 0 to {:g} m, so that a block lies beyond it (got {:g} m)", last,
      prestress.x_trigger);
}

void check_tau_bar(const Parameters& p, const char* name, const AlongX<double>& tau_bar) {
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    const double least = -(p.mu_s[i] + p.mu_d[i]) / (p.mu_s[i] - p.mu_d[i]);  // tau_0 = -mu_s p
    if (tau_bar[i] >= least && tau_bar[i] <= 1.0) continue;
    throw UsageError(
        "--{} {:g} would put junctions beyond f_thres: the largest possible value is 1, the "
        "smallest {:.4g}",
        name, tau_bar[i], least);
  }
}

/// The sigma-bar at which the outermost junction of block i reaches f_thres, if it stays pinned.
double largest_sigma_bar(const Parameters& p, const Prestress& prestress, Eigen::Index i,
                         double tau_i) {
  const double outermost = unit_quantiles(prestress.shape, springs_per_block(p)).back();
  if (outermost == 0.0) return 0.0;  // one junction per block has no width
  const auto N_s = static_cast<double>(p.N_s);
  const double room = p.mu_s[i] * column_load(p, i) / N_s - std::abs(tau_i) / N_s;
  return std::max(room, 0.0) / outermost * unit_sigma(prestress.shape) / strength_range(p, i);
}

void check_sigma_bar(const Parameters& p, const Prestress& prestress,
                     const std::vector<double>& tau) {
  const auto& sigma_bar = prestress.sigma_bar;
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    if (!(sigma_bar[i] >= 0.0)) {
      throw UsageError("--sigma-bar must be 0 or more (got {:g})", sigma_bar[i]);
    }
    const double of_block = largest_sigma_bar(p, prestress, i, tau[static_cast<std::size_t>(i)]);
    if (is_depinned(p, prestress, i) || !(sigma_bar[i] > of_block)) continue;
    const double largest = sigma_bar.varies() ? of_block : largest_sigma_bar(p, prestress);
    throw UsageError(
        "--sigma-bar {:g} would put junctions beyond f_thres: the largest possible value is "
        "{:.4f}{}",
        sigma_bar[i], std::floor(largest * 1e4) * 1e-4,
        springs_per_block(p) == 1 ? ", as each block has only one spring" : "");
  }
}

/// Junctions without load carry nothing, and may be attached anywhere.
double stretch(double f_ij, double k_ij) {
  return k_ij > 0.0 ? f_ij / k_ij : 0.0;
}

/// Attaches the junctions of block i where their forces add up to tau_i and follow phi. The single
/// spring of the simplified law is stretched like each of the N_s junctions that it stands for.
void attach(const Parameters& p, const Prestress& prestress, double tau_i, Eigen::Index i,
            State& state) {
  const double k_ij = junction_stiffness(p, i, column_load(p, i));
  const double half_width =
      prestress.sigma_bar[i] * strength_range(p, i) / unit_sigma(prestress.shape);
  const auto quantiles = unit_quantiles(prestress.shape, springs_per_block(p));
  const double mean = tau_i / static_cast<double>(p.N_s);
  for (Eigen::Index j = 0; j < state.junctions.attachment.cols(); ++j) {
    const double f = mean + half_width * quantiles[static_cast<std::size_t>(j)];
    state.junctions.attachment(i, j) = state.u_x(i, 0) - stretch(f, k_ij);
  }
}

/// Depins all junctions of block i, which carried tau_i together. The block is no longer at rest.
void depin(const Parameters& p, double tau_i, Eigen::Index i, InterfaceLaw& law, State& state) {
  const double normal = column_load(p, i), u_x = state.u_x(i, 0);
  const double w = friction_stretch(p, i, normal);
  const double k_ij = junction_stiffness(p, i, normal);
  const Eigen::Index springs = state.junctions.attachment.cols();
  double friction = 0.0;
  for (Eigen::Index j = 0; j < springs; ++j) {
    state.junctions.attachment(i, j) = u_x - stretch(tau_i / static_cast<double>(p.N_s), k_ij);
    law.break_spring(i, j, u_x, w, 0.0);
    friction += k_ij * (u_x - state.junctions.attachment(i, j));
  }
  const double junctions_in_each = static_cast<double>(p.N_s) / static_cast<double>(springs);
  state.f_x(i, 0) = tau_i - junctions_in_each * friction;
}

/// Adds the junctions to a slider that rests under `tau`.
void add_interface(const Parameters& p, const Prestress& prestress, const std::vector<double>& tau,
                   State& state) {
  const auto law = make_law(p, state.junctions);
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    const double tau_i = tau[static_cast<std::size_t>(i)];
    if (is_depinned(p, prestress, i)) {
      depin(p, tau_i, i, *law, state);
    } else {
      attach(p, prestress, tau_i, i, state);
    }
  }
}

}  // namespace

State normal_load_equilibrium(const Parameters& p) {
  validate(p);
  auto state = solve_statics(p, {});
  if (!state) {
    throw Failure(
        "found no equilibrium under F_N = {:g} N: the load is too large for slider.E = "
        "{:g} Pa, or the slider tips over",
        p.F_N, p.E);
  }
  check_strength(p, *state);
  state->drive = {state->step, state->u_x(0, driving_row(p))};
  return *std::move(state);
}

std::vector<double> prescribed_friction(const Parameters& p, const Prestress& prestress) {
  std::vector<double> tau;
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    const double tau_bar =
        in_trigger_region(p, prestress, i) ? prestress.tau_bar_trigger : prestress.tau_bar[i];
    tau.push_back(column_load(p, i) * (p.mu_d[i] + tau_bar * (p.mu_s[i] - p.mu_d[i])));
  }
  return tau;
}

double largest_sigma_bar(const Parameters& p, const Prestress& prestress) {
  const auto tau = prescribed_friction(p, prestress);
  double largest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < p.Nx; ++i) {
    if (is_depinned(p, prestress, i)) continue;
    largest =
        std::min(largest, largest_sigma_bar(p, prestress, i, tau[static_cast<std::size_t>(i)]));
  }
  return largest;
}

State prepared_state(const Parameters& p, const Prestress& prestress) {
  check_parameters(p);
  check_region(p, prestress);
  check_tau_bar(p, "tau-bar", prestress.tau_bar);
  check_tau_bar(p, "tau-bar-trigger", prestress.tau_bar_trigger);
  const auto tau = prescribed_friction(p, prestress);
  check_sigma_bar(p, prestress, tau);
  auto state = solve_statics(p, {tau, p.K});
  // As p is constant, the static equations have solutions in which the slider has turned until the
  // ceiling touches a corner, and blocks rose or sank by the spacing between them.
  if (!state || state->u_z.blocks().abs().maxCoeff() >= block_spacing(p)) {
    throw Failure(
        "found no equilibrium under this prestress: slider.F_N = {:g} N is too large "
        "for slider.E = {:g} Pa, or the slider tips over",
        p.F_N, p.E);
  }
  add_interface(p, prestress, tau, *state);
  return *std::move(state);
}

}  // namespace rupture
