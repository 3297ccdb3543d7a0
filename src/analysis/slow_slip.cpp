#include "rupture/analysis/slow_slip.hpp"

#include <deque>
#include <functional>
#include <limits>
#include <queue>

#include "rupture/forces/interface_law.hpp"
#include "rupture/model/derived.hpp"
#include "rupture/model/random.hpp"

namespace rupture {
namespace {

/// Stretch f_N / k_ij at p, so that a junction carries mu f_N when stretched by mu times this [m].
double unit_stretch(const SteadySliding& block) {
  const double f_N = block.p / static_cast<double>(block.parameters.N_s);
  return f_N / junction_stiffness(block.parameters, 0, block.p);
}

/// f_new / f_N
double mu_new(const Parameters& p) {
  return p.f_new[0] == NewForce::f_slip ? p.mu_d[0] : 0.0;
}

/// T_p [s]
double pinned_time(const SteadySliding& block, double v) {
  return (block.parameters.mu_s[0] - mu_new(block.parameters)) * unit_stretch(block) / v;
}

/// Blocks with the same normal force and position but slipping times of their own.
class Replicas {
 public:
  Replicas(const SteadySliding& block, int n)
      : parameters_(with_blocks(block.parameters, n)),
        junctions_(spread(parameters_, unit_stretch(block))),
        law_(make_law(parameters_, junctions_)),
        u_(static_cast<std::size_t>(n)),
        p_(u_.size(), block.p),
        k_ij_(u_.size(), junction_stiffness(block.parameters, 0, block.p)),
        w_(u_.size(), unit_stretch(block)),
        tau_(u_.size()) {}

  /// Friction force on each block after a move to u at time t [N].
  const std::vector<double>& friction_at(double u, double t) {
    u_.assign(u_.size(), u);
    const ContactView contact{p_.data(), k_ij_.data(), w_.data()};
    law_->update(u_.data(), nullptr, contact, t);
    law_->friction(u_.data(), contact, tau_.data());
    return tau_;
  }

 private:
  static Parameters with_blocks(Parameters p, int n) {
    p.Nx = n;
    p.law = Law::reference;
    return p;
  }
  /// All attached at once, slow junctions would break at once for many cycles: they start evenly
  /// spread over the pinned phase.
  static Junctions spread(const Parameters& p, double w) {
    Junctions junctions = State(p).junctions;
    for (Eigen::Index j = 0; j < p.N_s; ++j) {
      const double part = (static_cast<double>(j) + 0.5) / static_cast<double>(p.N_s);
      junctions.attachment.col(j) = -(mu_new(p) + (p.mu_s[0] - mu_new(p)) * part) * w;
    }
    return junctions;
  }

  const Parameters parameters_;
  Junctions junctions_;
  const std::unique_ptr<InterfaceLaw> law_;
  std::vector<double> u_, p_, k_ij_, w_, tau_;
};

/// One block whose junctions are pinned one after another. Forces in units of f_slip, lengths of
/// f_slip / k_ij, so that a junction carries slip - attachment.
class RelaxingBlock {
 public:
  RelaxingBlock(const Parameters& p, std::uint32_t replica)
      : parameters_(p), replica_(replica), draws_(static_cast<std::size_t>(p.N_s), 0U) {
    if (p.mu_d[0] > 0.0) f_thres_ = p.mu_s[0] / p.mu_d[0];
    if (p.f_new[0] == NewForce::f_slip) f_new_ = 1.0;
    for (std::uint32_t j = 0; j < draws_.size(); ++j) start_slipping(j);
  }

  bool slips() const { return !slipping_.empty(); }
  double next_time() const { return slipping_.top().time; }
  double time() const { return time_; }
  double slip() const { return slip_; }
  bool all_returned() const { return returned_ == draws_.size(); }

  /// The next junction is pinned, and the block moves until its force is back.
  void pin_next() {
    const Slipping next = slipping_.top();
    slipping_.pop();
    time_ = next.time;
    if (draws_[next.junction] == 1U) ++returned_;
    pinned_.push_back({slip_ - f_new_, next.junction});
    sum_ += pinned_.back().attachment;
    // the oldest is stretched most; the last one bears f_slip, less than it can
    while (pinned_.size() > 1 && balanced() > pinned_.front().attachment + f_thres_) break_oldest();
    slip_ = balanced();
  }

 private:
  struct Slipping {
    double time;
    std::uint32_t junction;
    bool operator>(const Slipping& other) const { return time > other.time; }
  };
  struct Pinned {
    double attachment;
    std::uint32_t junction;
  };

  /// Slip at which the pinned junctions carry 1 on average. Breaking the oldest increases it.
  double balanced() const { return 1.0 + sum_ / static_cast<double>(pinned_.size()); }
  void break_oldest() {
    const Pinned oldest = pinned_.front();
    pinned_.pop_front();
    sum_ -= oldest.attachment;
    start_slipping(oldest.junction);
  }
  void start_slipping(std::uint32_t j) {
    slipping_.push({time_ + slipping_time(parameters_, replica_, j, draws_[j]++), j});
  }

  const Parameters& parameters_;
  std::uint32_t replica_;
  std::vector<std::uint32_t> draws_;  // slipping times drawn, per junction
  double f_thres_ = std::numeric_limits<double>::infinity(), f_new_ = 0.0;
  std::priority_queue<Slipping, std::vector<Slipping>, std::greater<>> slipping_;
  std::deque<Pinned> pinned_;  // in the order of pinning, which is that of their attachments
  double time_ = 0.0, slip_ = 0.0, sum_ = 0.0;
  std::size_t returned_ = 0;
};

constexpr double kLongest = 100.0;  // [<t_R>]

}  // namespace

double renewal_friction(const SteadySliding& block, double v) {
  const Parameters& p = block.parameters;
  const double T_p = pinned_time(block, v), t_R = mean_slipping_time(p, 0);
  return (T_p * (p.mu_s[0] + mu_new(p)) / 2.0 + t_R * p.mu_d[0]) / (T_p + t_R);
}

Mean measured_friction(const SteadySliding& block, double v, const SteadyRun& run) {
  Replicas replicas(block, run.replicas);
  const std::int64_t first = std::int64_t{run.running_in} * run.steps_per_cycle;
  const std::int64_t steps = std::int64_t{run.measured} * run.steps_per_cycle;
  const double dt =
      (pinned_time(block, v) + mean_slipping_time(block.parameters, 0)) / run.steps_per_cycle;
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

double slow_slip_estimate(const Parameters& parameters, std::int64_t i, double p) {
  if (p <= 0.0 || parameters.f_new[i] == NewForce::f_slip) return 0.0;
  const double k_i = static_cast<double>(parameters.N_s) * junction_stiffness(parameters, i, p);
  return kSlowSlipCoefficient * parameters.mu_d[i] * p / (k_i * mean_slipping_time(parameters, i));
}

std::optional<Relaxation> relax(const Parameters& p, std::uint32_t replica) {
  const double t_R = mean_slipping_time(p, 0);
  RelaxingBlock block(p, replica);
  Relaxation result{};
  while (block.slips()) {
    if (block.next_time() > kLongest * t_R) return std::nullopt;
    const bool before = !block.all_returned();
    block.pin_next();
    result.course.time.push_back(block.time() / t_R);
    result.course.slip.push_back(block.slip());
    if (block.time() <= 2.0 * t_R) result.slip_after_two = block.slip();
    if (before && block.all_returned()) {
      result.duration = block.time() / t_R;
      result.slip_at_return = block.slip();
    }
  }
  result.net_slip = block.slip();
  result.quiet_time = block.time() / t_R;
  return result;
}

std::optional<RelaxationEnsemble> relax_ensemble(const Parameters& p, int n) {
  std::vector<double> net_slip, slip_after_two, slip_at_return, duration, quiet_time;
  for (int replica = 0; replica < n; ++replica) {
    const auto one = relax(p, static_cast<std::uint32_t>(replica));
    if (!one) return std::nullopt;
    net_slip.push_back(one->net_slip);
    slip_after_two.push_back(one->slip_after_two);
    slip_at_return.push_back(one->slip_at_return);
    duration.push_back(one->duration);
    quiet_time.push_back(one->quiet_time);
  }
  return RelaxationEnsemble{mean_of(net_slip).value(), mean_of(slip_after_two).value(),
                            mean_of(slip_at_return).value(), mean_of(duration).value(),
                            mean_of(quiet_time).value()};
}

}  // namespace rupture
