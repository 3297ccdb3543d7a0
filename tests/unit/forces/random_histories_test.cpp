// The interface laws over long random histories, against a plain account of every junction.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "hand_made_interface.hpp"
#include "rupture/model/random.hpp"

namespace rupture::testing {

constexpr int kHistory = 20000;  // steps

/// A block that wanders about 0.2 m, the reach of its junctions, under a normal force that comes
/// and goes; time advances by a fiftieth of the mean slipping time.
class Wandering {
 public:
  void step() {
    u = 0.98 * u + 0.06 * noise_();
    t += 0.04e-3;
    f_N = std::max(0.0, 0.9 * f_N + 0.1 + 0.3 * noise_());
  }
  double u = 0, t = 0, f_N = 1;

 private:
  Noise noise_{1.0};
};

/// The laws with N_s junctions once more, in forces instead of stretches, from the time of the
/// break instead of the time left, and with no short cuts.
struct PlainJunction {
  double attachment = 0.0, broken_at = -1.0, t_R = 0.0, left = 0.0;
  std::uint32_t draws = 0;

  double update(const Parameters& p, std::uint32_t j, double u, double f_N, double t) {
    const double k = std::sqrt(p.kappa[0] * f_N), f = k * (u - attachment);
    const bool decays = p.law == Law::decaying, by_distance = p.law == Law::distance;
    if (f_N == 0.0) attachment = u;
    if (broken_at >= 0.0) {
      const double t_s = std::min(t - broken_at, t_R), before = attachment;
      const double mu = decays ? p.mu_d[0] - (p.mu_d[0] - p.mu_new[0]) * t_s / t_R : p.mu_d[0];
      if (f_N > 0.0 && std::abs(f) > mu * f_N) attachment = u - std::copysign(mu * f_N / k, f);
      left -= std::abs(attachment - before);
      if (by_distance ? left > 0.0 : t < broken_at + t_R) return k * (u - attachment);
      broken_at = -1.0;
      if (!decays && p.f_new[0] == NewForce::zero) attachment = u;
    } else if (f_N > 0.0 && std::abs(f) > p.mu_s[0] * f_N) {
      attachment = u - std::copysign(p.mu_d[0] * f_N / k, f);
      broken_at = t;
      left = by_distance ? folded_gaussian(p.d_R[0], p.delta_d_R[0], p.seed, 0, j, draws) : 0.0;
      t_R = slipping_time(p, 0, j, draws++);
    }
    return k * (u - attachment);
  }
};

struct Case {
  Law law;
  std::int64_t N_s;
  NewForce f_new = NewForce::zero;
};

class PlainHistory : public ::testing::TestWithParam<Case> {
 protected:
  static Parameters parameters(const Case& chosen) {
    Parameters p = hand_made(chosen.N_s);
    p.law = chosen.law;
    p.f_new = chosen.f_new;
    p.delta_t_R = 0.6e-3;
    p.d_R = 0.1;
    p.delta_d_R = 0.03;
    return p;
  }
  const Parameters p_ = parameters(GetParam());
  Interface block_{p_};
  Wandering path_;
};

TEST_P(PlainHistory, agrees_with_a_plain_account_of_every_junction) {
  std::vector<PlainJunction> plain(static_cast<std::size_t>(p_.N_s));
  // N_s cancelling attachment points of up to 1 m, each known to 1e-16 m; where the force decays,
  // the time left is known to 1e-16 s of up to 1 s, 1e-13 of t_R
  const double rounding = 1e-13 * static_cast<double>(p_.law == Law::decaying ? 100 : p_.N_s);
  for (int n = 0; n < kHistory; ++n) {
    path_.step();
    block_.press(path_.f_N);
    block_.move(path_.u, path_.t);
    double expected = 0.0;
    std::int32_t pinned = 0;
    for (std::uint32_t j = 0; j < plain.size(); ++j) {
      expected += plain[j].update(p_, j, path_.u, path_.f_N, path_.t);
      pinned += plain[j].broken_at < 0.0 ? 1 : 0;
    }
    ASSERT_NEAR(block_.friction(), expected, rounding) << "step " << n;
    ASSERT_EQ(block_.pinned(), pinned) << "step " << n;
  }
}

// 1, 7, 8, 9 and 100 junctions: sums run in eight lanes, and rows need not be full
const auto kPlain = ::testing::Values(
    Case{Law::reference, 1}, Case{Law::reference, 7}, Case{Law::reference, 8, NewForce::f_slip},
    Case{Law::reference, 9}, Case{Law::reference, 100}, Case{Law::reference, 100, NewForce::f_slip},
    Case{Law::decaying, 1}, Case{Law::decaying, 9}, Case{Law::decaying, 100},
    Case{Law::distance, 1}, Case{Law::distance, 9});

std::string name_of(const ::testing::TestParamInfo<Case>& history) {
  return law_name(history.param.law) + "_" + std::to_string(history.param.N_s) +
         (history.param.f_new == NewForce::zero ? "" : "_f_slip");
}

INSTANTIATE_TEST_SUITE_P(Law, PlainHistory, kPlain, name_of);

TEST(DecayingHistory, without_decay_is_the_reference_law_with_slow_slip_off_to_the_bit) {
  Parameters decaying = hand_made(9), reference = decaying;
  decaying.law = Law::decaying;
  decaying.mu_new = decaying.mu_d[0];
  reference.f_new = NewForce::f_slip;
  decaying.delta_t_R = reference.delta_t_R = 0.6e-3;
  Interface one(decaying), other(reference);
  Wandering path;
  for (int n = 0; n < kHistory; ++n) {
    path.step();
    for (Interface* block : {&one, &other}) {
      block->press(path.f_N);
      block->move(path.u, path.t);
    }
    ASSERT_EQ(one.friction(), other.friction()) << "step " << n;
    ASSERT_EQ(one.pinned(), other.pinned()) << "step " << n;
  }
}

}  // namespace rupture::testing
