// What several junctions or blocks do under the interface laws, and what a change of parameters or
// of the law does to them. Each branch of a law is in law_histories_test.cpp.
#include <gtest/gtest.h>

#include "hand_made_interface.hpp"
#include "rupture/model/random.hpp"

namespace rupture::testing {

constexpr double kSlipForce = 0.17, kSlippingTime = 2e-3;  // mu_d f_N [N], t_R [s]
constexpr double kBrokenAt = 0.21, kDistance = 0.3;        // [m]

Parameters with_law(Law law, std::int64_t N_s) {
  Parameters p = hand_made(N_s);
  p.law = law;
  if (law == Law::decaying) p.mu_d = 0.2;
  p.mu_new = 0.12;
  p.d_R = kDistance;
  p.delta_d_R = 0.0;
  return p;
}

TEST(SeveralBlocks, draw_and_rub_independently) {
  Parameters p = hand_made(2);
  p.Nx = 3;
  p.delta_t_R = 0.6e-3;
  Junctions junctions = State(p).junctions;
  const auto law = make_law(p, junctions);
  std::vector<double> u = {0.1, 0.21, 0.21}, p_i = {2.0, 2.0, 0.0}, k_ij = {2.0, 2.0, 0.0},
                      w = {0.5, 0.5, 0.0}, v(3), tau(3);
  const ContactView contact = {p_i.data(), k_ij.data(), w.data()};
  EXPECT_EQ(law->update(u.data(), v.data(), contact, 0.0).broken, 2);
  law->friction(u.data(), contact, tau.data());
  EXPECT_NEAR(tau[0], 2 * 0.2, kRounding);
  EXPECT_NEAR(tau[1], 2 * kSlipForce, kRounding);
  EXPECT_EQ(tau[2], 0.0);
  EXPECT_EQ(law->pinned(), (std::vector<std::int32_t>{2, 0, 2}));
  for (std::uint32_t j = 0; j < 2; ++j) {
    EXPECT_EQ(junctions.repin_time(1, j), slipping_time(p, 1, j, 0));
  }
}

TEST(DecayingLaw, stays_between_mu_d_and_mu_new_when_t_R_has_changed) {
  Parameters p = with_law(Law::decaying, 1);
  Interface block(p);
  block.move(kBrokenAt, 0.0);
  for (const double t_R : {1e-3, 8e-3}) {  // instead of 2 ms, of which 1 ms is left
    p.t_R = t_R;
    Junctions junctions = block.junctions();
    const auto law = make_law(p, junctions);
    double u = 0.5, v = 0.0, p_i = 1.0, k_ij = 2.0, w = 0.5, tau = 0.0;
    law->update(&u, &v, {&p_i, &k_ij, &w}, 1e-3 - 1e-6);
    law->friction(&u, {&p_i, &k_ij, &w}, &tau);
    EXPECT_NEAR(tau, t_R == 1e-3 ? 0.2 : 0.12 + 0.08 * 1.001 / 8.0, kRounding);
  }
}

/// Two junctions have broken, and the first of them is pinned again.
TEST(ChangeOfLaw, lets_slipping_junctions_begin_anew) {
  const Parameters by_time = hand_made(2), by_distance = with_law(Law::distance, 2);
  Interface block(by_time);
  block.move(kBrokenAt, 0.0);
  Junctions junctions = block.junctions();
  junctions.repin_time(0, 0) = Junctions::never;

  change_law(by_time, by_distance, 1.0, junctions);
  EXPECT_EQ(junctions.slip_left(0, 0), 0.0);
  EXPECT_EQ(junctions.repin_time(0, 0), Junctions::never);
  EXPECT_EQ(junctions.slip_left(0, 1), kDistance);
  EXPECT_EQ(junctions.repin_time(0, 1), Junctions::unknown);
  EXPECT_EQ(junctions.draws(0, 1), 2U);

  change_law(by_distance, by_time, 1.5, junctions);
  EXPECT_EQ(junctions.slip_left.size(), 0);
  EXPECT_EQ(junctions.repin_time(0, 0), Junctions::never);
  EXPECT_EQ(junctions.repin_time(0, 1), 1.5 + kSlippingTime);
  EXPECT_TRUE((junctions.attachment == block.junctions().attachment).all());
}

TEST(ChangeOfLaw, leaves_the_junctions_as_they_are_where_both_laws_know_the_time) {
  const Parameters before = hand_made(1), after = with_law(Law::decaying, 1);
  Interface block(before);
  block.move(kBrokenAt, 0.0);
  Junctions junctions = block.junctions();
  change_law(before, after, 1e-3, junctions);
  EXPECT_EQ(junctions.repin_time(0, 0), kSlippingTime);
  EXPECT_EQ(junctions.draws(0, 0), 1U);
}

}  // namespace rupture::testing
