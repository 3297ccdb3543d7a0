// The other interface laws over long random histories: they keep nothing but the junctions, and the
// decaying law contains the reference law.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "hand_made_interface.hpp"
#include "rupture/model/random.hpp"

namespace rupture {
namespace {

using testing::hand_made;
using testing::Interface;
using testing::kHistory;
using testing::Wandering;

Parameters with_law(Law law, std::int64_t N_s) {
  Parameters p = hand_made(N_s);
  p.law = law;
  p.delta_t_R = 0.6e-3;
  p.dt = 0.04e-3;  // of Wandering
  p.v_slow = 5.0;  // 0.4 m in t_R
  p.d_R = 0.1;
  p.delta_d_R = 0.03;
  return p;
}

struct LawHistory {
  Law law;
  std::int64_t N_s;
};

class OtherLaws : public ::testing::TestWithParam<LawHistory> {};

TEST_P(OtherLaws, keep_nothing_but_the_junctions) {
  const Parameters p = with_law(GetParam().law, GetParam().N_s);
  Interface block(p);
  Wandering path;
  std::int64_t broken = 0, repinned = 0;
  for (int n = 0; n < kHistory; ++n) {
    path.step();
    block.press(path.f_N);
    Junctions before = block.junctions();
    const auto fresh = make_law(p, before);
    double v = path.u - block.u(), p_i = 0, k_ij = block.k_ij(), w = block.w(), tau = 0;
    const ContactView contact = {&p_i, &k_ij, &w};
    const auto changes = block.move(path.u, path.t);
    const auto again = fresh->update(&path.u, &v, contact, path.t);
    fresh->friction(&path.u, contact, &tau);
    ASSERT_EQ(changes.broken, again.broken);
    ASSERT_EQ(changes.repinned, again.repinned);
    ASSERT_EQ(block.friction(), tau) << "to the last bit, at step " << n;
    ASSERT_EQ(block.pinned(), fresh->pinned()[0]);
    ASSERT_TRUE((block.junctions().attachment == before.attachment).all());
    ASSERT_TRUE((block.junctions().repin_time == before.repin_time).all());
    ASSERT_TRUE((block.junctions().draws == before.draws).all());
    ASSERT_TRUE((block.junctions().slow_until == before.slow_until).all());
    ASSERT_TRUE((block.junctions().slip_left == before.slip_left).all());
    broken += changes.broken;
    repinned += changes.repinned;
  }
  EXPECT_GT(broken, kHistory / 1000) << "the history was too quiet";
  EXPECT_GT(repinned, kHistory / 1000);
}

INSTANTIATE_TEST_SUITE_P(
    Law, OtherLaws,
    ::testing::Values(LawHistory{Law::decaying, 1}, LawHistory{Law::decaying, 9},
                      LawHistory{Law::decaying, 100}, LawHistory{Law::simplified, 1},
                      LawHistory{Law::simplified, 100}, LawHistory{Law::distance, 1},
                      LawHistory{Law::distance, 9}),
    [](const auto& history) {
      return testing::law_name(history.param.law) + "_" + std::to_string(history.param.N_s);
    });

/// The decaying law once more, in forces, from the time of the break instead of the time left.
struct PlainDecay {
  double attachment = 0.0, broken_at = -1.0, t_R = 0.0;
  std::uint32_t draws = 0;

  double update(const Parameters& p, std::uint32_t j, double u, double f_N, double t) {
    const double k = std::sqrt(p.kappa * f_N);
    const double f = k * (u - attachment);
    if (f_N == 0.0) attachment = u;
    if (broken_at >= 0.0) {
      const double t_s = std::min(t - broken_at, t_R);
      const double f_slip = (p.mu_d - (p.mu_d - p.mu_new) * t_s / t_R) * f_N;
      if (f_N > 0.0 && std::abs(f) > f_slip) attachment = u - std::copysign(f_slip / k, f);
      if (t >= broken_at + t_R) broken_at = -1.0;
    } else if (f_N > 0.0 && std::abs(f) > p.mu_s * f_N) {
      attachment = u - std::copysign(p.mu_d * f_N / k, f);
      broken_at = t;
      t_R = slipping_time(p, 0, j, draws++);
    }
    return k * (u - attachment);
  }
};

TEST(DecayingHistory, agrees_with_a_plain_account_of_every_junction) {
  const Parameters p = with_law(Law::decaying, 9);
  Interface block(p);
  Wandering path;
  std::vector<PlainDecay> plain(9);
  for (int n = 0; n < kHistory; ++n) {
    path.step();
    block.press(path.f_N);
    block.move(path.u, path.t);
    double expected = 0.0;
    std::int32_t pinned = 0;
    for (std::uint32_t j = 0; j < 9; ++j) {
      expected += plain[j].update(p, j, path.u, path.f_N, path.t);
      pinned += plain[j].broken_at < 0.0 ? 1 : 0;
    }
    // the time left is known to 1e-16 s of up to 1 s, 1e-13 of t_R
    ASSERT_NEAR(block.friction(), expected, 1e-11) << "step " << n;
    ASSERT_EQ(block.pinned(), pinned) << "step " << n;
  }
}

TEST(DecayingHistory, without_decay_is_the_reference_law_with_slow_slip_off_to_the_bit) {
  Parameters decaying = with_law(Law::decaying, 9), reference = with_law(Law::reference, 9);
  decaying.mu_new = decaying.mu_d;
  reference.f_new = NewForce::f_slip;
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

}  // namespace
}  // namespace rupture
