#include "rupture/analysis/steady_sliding.hpp"

#include <cmath>

#include "rupture/forces/reference_law.hpp"
#include "rupture/model/derived.hpp"

namespace rupture {
namespace {

/// Stretch f_N / k_ij at p, so that a junction carries mu f_N when stretched by mu times this [m].
double unit_stretch(const SteadySliding& block) {
  const double f_N = block.p / static_cast<double>(block.parameters.N_s);
  return f_N / junction_stiffness(block.parameters, block.p);
}

/// f_new / f_N
double mu_new(const Parameters& p) {
  return p.f_new == NewForce::f_slip ? p.mu_d : 0.0;
}

/// T_p [s]
double pinned_time(const SteadySliding& block, double v) {
  return (block.parameters.mu_s - mu_new(block.parameters)) * unit_stretch(block) / v;
}

/// Blocks with the same normal force and position but slipping times of their own.
class Replicas {
 public:
  Replicas(const SteadySliding& block, int n)
      : parameters_(with_blocks(block.parameters, n)),
        junctions_(spread(parameters_, unit_stretch(block))),
        law_(parameters_, junctions_),
        u_(static_cast<std::size_t>(n)),
        p_(u_.size(), block.p),
        k_ij_(u_.size(), junction_stiffness(block.parameters, block.p)),
        w_(u_.size(), unit_stretch(block)),
        tau_(u_.size()) {}

  /// Friction force on each block after a move to u at time t [N].
  const std::vector<double>& friction_at(double u, double t) {
    u_.assign(u_.size(), u);
    const ContactView contact{p_.data(), k_ij_.data(), w_.data()};
    law_.update(u_.data(), nullptr, contact, t);
    law_.friction(u_.data(), contact, tau_.data());
    return tau_;
  }

 private:
  static Parameters with_blocks(Parameters p, int n) {
    p.Nx = n;
    return p;
  }
  /// All attached at once, slow junctions would break at once for many cycles: they start evenly
  /// spread over the pinned phase.
  static Junctions spread(const Parameters& p, double w) {
    Junctions junctions = State(p).junctions;
    for (Eigen::Index j = 0; j < p.N_s; ++j) {
      const double part = (static_cast<double>(j) + 0.5) / static_cast<double>(p.N_s);
      junctions.attachment.col(j) = -(mu_new(p) + (p.mu_s - mu_new(p)) * part) * w;
    }
    return junctions;
  }

  const Parameters parameters_;
  Junctions junctions_;
  ReferenceLaw law_;
  std::vector<double> u_, p_, k_ij_, w_, tau_;
};

}  // namespace

double renewal_friction(const SteadySliding& block, double v) {
  const Parameters& p = block.parameters;
  const double T_p = pinned_time(block, v), t_R = mean_slipping_time(p);
  return (T_p * (p.mu_s + mu_new(p)) / 2.0 + t_R * p.mu_d) / (T_p + t_R);
}

Mean measured_friction(const SteadySliding& block, double v, const SteadyRun& run) {
  Replicas replicas(block, run.replicas);
  const std::int64_t first = std::int64_t{run.running_in} * run.steps_per_cycle;
  const std::int64_t steps = std::int64_t{run.measured} * run.steps_per_cycle;
  const double dt =
      (pinned_time(block, v) + mean_slipping_time(block.parameters)) / run.steps_per_cycle;
  std::vector<double> mu(static_cast<std::size_t>(run.replicas), 0.0);
  for (std::int64_t n = 1; n <= first + steps; ++n) {
    const double t = static_cast<double>(n) * dt;
    const auto& tau = replicas.friction_at(v * t, t);
    if (n <= first) continue;
    for (std::size_t i = 0; i < mu.size(); ++i) {
      mu[i] += tau[i] / block.p / static_cast<double>(steps);
    }
  }
  return mean_of(mu).value();
}

std::vector<double> speeds_between(double v_from, double v_to, int points) {
  std::vector<double> speeds;
  for (int n = 0; n < points; ++n) {
    const double part = points > 1 ? static_cast<double>(n) / (points - 1) : 0.0;
    speeds.push_back(v_from * std::pow(v_to / v_from, part));
  }
  return speeds;
}

}  // namespace rupture
