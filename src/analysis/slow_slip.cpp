#include "rupture/analysis/slow_slip.hpp"

#include <cstdint>
#include <deque>
#include <limits>
#include <queue>
#include <vector>

#include "rupture/model/derived.hpp"
#include "rupture/model/random.hpp"

namespace rupture {
namespace {

/// One block whose junctions are pinned one after another. Forces in units of f_slip, lengths of
/// f_slip / k_ij, so that a junction carries slip - attachment.
class RelaxingBlock {
 public:
  RelaxingBlock(const Parameters& p, std::uint32_t replica, Rebreaking rebreaking)
      : parameters_(p), replica_(replica), draws_(static_cast<std::size_t>(p.N_s), 0U) {
    if (rebreaking == Rebreaking::on && p.mu_d > 0.0) f_thres_ = p.mu_s / p.mu_d;
    if (p.f_new == NewForce::f_slip) f_new_ = 1.0;
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

double slow_slip_estimate(const Parameters& parameters, double p) {
  if (p <= 0.0 || parameters.f_new == NewForce::f_slip) return 0.0;
  const double k_i = static_cast<double>(parameters.N_s) * junction_stiffness(parameters, p);
  return kSlowSlipCoefficient * parameters.mu_d * p / (k_i * mean_slipping_time(parameters));
}

std::optional<Relaxation> relax(const Parameters& p, std::uint32_t replica, Rebreaking rebreaking) {
  const double t_R = mean_slipping_time(p);
  RelaxingBlock block(p, replica, rebreaking);
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
