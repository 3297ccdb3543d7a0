// The reference law over long random histories: against a plain account of every junction, and
// against itself with nothing remembered but the junctions.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "hand_made_interface.hpp"
#include "rupture/forces/reference_law.hpp"
#include "rupture/model/random.hpp"

namespace rupture {
namespace {

using testing::hand_made;
using testing::Interface;
using testing::kHistory;
using testing::Wandering;

/// The law once more, in forces instead of stretches and with no short cuts.
struct PlainJunction {
  double attachment = 0.0, repin_time = Junctions::never;
  std::uint32_t draws = 0;

  double update(const Parameters& p, std::uint32_t j, double u, double f_N, double t) {
    const double k = std::sqrt(p.kappa * f_N);
    const double f = k * (u - attachment);
    const bool slipping = repin_time < Junctions::never;
    if (f_N == 0.0) attachment = u;
    if (slipping && f_N > 0.0 && std::abs(f) > p.mu_d * f_N) {
      attachment = u - std::copysign(p.mu_d * f_N / k, f);
    }
    if (slipping && t >= repin_time) {
      repin_time = Junctions::never;
      if (p.f_new == NewForce::zero) attachment = u;
    } else if (!slipping && f_N > 0.0 && std::abs(f) > p.mu_s * f_N) {
      attachment = u - std::copysign(p.mu_d * f_N / k, f);
      repin_time = t + slipping_time(p, 0, j, draws++);
    }
    return k * (u - attachment);
  }
};

struct NewForceHistory {
  std::int64_t N_s;
  NewForce f_new;
};

class RandomHistory : public ::testing::TestWithParam<NewForceHistory> {
 protected:
  RandomHistory() : p_(hand_made(GetParam().N_s)) {
    p_.f_new = GetParam().f_new;
    p_.delta_t_R = 0.6e-3;
    block_.emplace(p_);
  }
  Parameters p_;
  std::optional<Interface> block_;
  Wandering path_;
};

TEST_P(RandomHistory, agrees_with_a_plain_account_of_every_junction) {
  std::vector<PlainJunction> plain(static_cast<std::size_t>(p_.N_s));
  std::int64_t broken = 0, repinned = 0, without_contact = 0;
  for (int n = 0; n < kHistory; ++n) {
    path_.step();
    block_->press(path_.f_N);
    const auto changes = block_->move(path_.u, path_.t);
    broken += changes.broken;
    repinned += changes.repinned;
    without_contact += path_.f_N == 0.0 ? 1 : 0;
    double expected = 0.0;
    std::int32_t pinned = 0;
    for (std::uint32_t j = 0; j < plain.size(); ++j) {
      expected += plain[j].update(p_, j, path_.u, path_.f_N, path_.t);
      pinned += plain[j].repin_time < Junctions::never ? 0 : 1;
    }
    // 1e-13: N_s cancelling attachment points of up to 1 m, each known to 1e-16 m
    ASSERT_NEAR(block_->friction(), expected, 1e-13 * static_cast<double>(p_.N_s)) << "step " << n;
    ASSERT_EQ(block_->pinned(), pinned) << "step " << n;
  }
  EXPECT_GT(broken, kHistory / 1000 * p_.N_s) << "the history was too quiet";
  EXPECT_GT(without_contact, kHistory / 1000);
  EXPECT_LE(broken - repinned, p_.N_s);
}

TEST_P(RandomHistory, leaves_no_trace_in_the_law_but_the_junctions) {
  for (int n = 0; n < kHistory / 10; ++n) {
    path_.step();
    block_->press(path_.f_N);
    Junctions before = block_->junctions();
    ReferenceLaw fresh(p_, before);
    const auto changes = block_->move(path_.u, path_.t);
    double p_i = 0, k_ij = block_->k_ij(), w = block_->w(), v = 0, tau = 0;
    const ContactView contact = {&p_i, &k_ij, &w};
    const auto again = fresh.update(&path_.u, &v, contact, path_.t);
    fresh.friction(&path_.u, contact, &tau);
    ASSERT_EQ(changes.broken, again.broken);
    ASSERT_EQ(changes.repinned, again.repinned);
    ASSERT_EQ(block_->friction(), tau) << "to the last bit, at step " << n;
    ASSERT_EQ(block_->pinned(), fresh.pinned()[0]);
    ASSERT_TRUE((block_->junctions().attachment == before.attachment).all());
    ASSERT_TRUE((block_->junctions().repin_time == before.repin_time).all());
    ASSERT_TRUE((block_->junctions().draws == before.draws).all());
  }
}

// 1, 7, 8, 9 and 100 junctions: sums run in eight lanes, and rows need not be full
INSTANTIATE_TEST_SUITE_P(
    Law, RandomHistory,
    ::testing::Values(NewForceHistory{1, NewForce::zero}, NewForceHistory{7, NewForce::zero},
                      NewForceHistory{8, NewForce::f_slip}, NewForceHistory{9, NewForce::zero},
                      NewForceHistory{100, NewForce::zero}, NewForceHistory{100, NewForce::f_slip}),
    [](const auto& history) {
      return std::to_string(history.param.N_s) +
             (history.param.f_new == NewForce::zero ? "_zero" : "_f_slip");
    });

}  // namespace
}  // namespace rupture
