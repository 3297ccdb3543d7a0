// One simulation: the order of a step, the forces it reports, ruptures, and blow-up.
#include "rupture/dynamics/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <new>

#include "dynamics/helpers.hpp"
#include "rupture/analysis/phi.hpp"
#include "rupture/dynamics/equilibrium.hpp"
#include "rupture/forces/interface_law.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

constexpr std::int64_t kThroughTheRupture = 2500;  // steps

class StepUnder : public ::testing::TestWithParam<Law> {};

INSTANTIATE_TEST_SUITE_P(Law, StepUnder, ::testing::ValuesIn(kAllLaws),
                         [](const auto& law) { return law_name(law.param); });

/// Compares every step of the next 2,500 with the same step in plain terms. In these, at least nine
/// blocks must rupture; of a prepared slider six, as three have already.
void expect_stated_order(const Parameters& p) {
  const bool is_prepared = p.support == Support::ceiling;
  Simulation simulation(
      p, is_prepared ? prepared_state(p, quick_prestress()) : normal_load_equilibrium(p));
  for (int n = 0; n < kThroughTheRupture; ++n) {
    State plain = simulation.state();
    Bulk bulk(p);
    const auto law = make_law(p, plain.junctions);
    plain_step(p, p.dt, bulk, plain, [&](State& now) { add_outer_forces(p, *law, now); });
    simulation.advance();
    const State& s = simulation.state();
    ASSERT_EQ(s.step, plain.step);
    // only the order of sums may differ: 1e-14 of the load on a block, of 1e-5 m and of 1 m/s
    ASSERT_LT((s.f_x.blocks() - plain.f_x.blocks()).abs().maxCoeff(), 1e-10) << "step " << n;
    ASSERT_LT((s.f_z.blocks() - plain.f_z.blocks()).abs().maxCoeff(), 1e-10) << "step " << n;
    ASSERT_LT((s.v_x.blocks() - plain.v_x.blocks()).abs().maxCoeff(), 1e-12) << "step " << n;
    ASSERT_LT((s.u_x.blocks() - plain.u_x.blocks()).abs().maxCoeff(), 1e-18) << "step " << n;
    ASSERT_TRUE((s.junctions.draws == plain.junctions.draws).all()) << "step " << n;
    ASSERT_TRUE((s.junctions.repin_time == plain.junctions.repin_time).all()) << "step " << n;
    ASSERT_TRUE((s.junctions.slow_until == plain.junctions.slow_until).all()) << "step " << n;
    ASSERT_LT((s.junctions.attachment - plain.junctions.attachment).abs().maxCoeff(), 1e-18);
  }
  EXPECT_GE(simulation.ruptures().size(), is_prepared ? 6U : 9U);
}

TEST_P(StepUnder, follows_the_stated_order) {
  Parameters p = quick_slider(GetParam());
  expect_stated_order(p);
  p.k_ij_from = StiffnessFrom::initial;
  expect_stated_order(p);
}

TEST(Step, follows_the_stated_order_on_every_support) {
  expect_stated_order(prepared_slider());
  for (Parameters damped : {quick_slider(), prepared_slider()}) {
    damped.foundation_damping = 0.5;
    expect_stated_order(damped);
    set_parameter(damped, "slider.load", "1.2 from 0 to 10mm");
    set_parameter(damped, "junctions.kappa", "30e9 from 5mm to 12.5mm");
    set_parameter(damped, "junctions.mu_s", "0.42 from 5mm to 10mm");
    expect_stated_order(damped);
  }
}

TEST(Simulation, notes_each_rupture_and_crossing_of_another_pinned_fraction_at_its_step) {
  const Parameters p = prepared_slider();
  Prestress prestress = quick_prestress();
  prestress.sigma_bar = 0.2;  // so that the junctions of a block break one after the other
  const State start = prepared_state(p, prestress);
  Simulation simulation(p, start, 1, {0.2, 0.55}), plain(p, start);
  const auto fractions = [&] {
    std::vector<double> pinned;
    for (Eigen::Index i = 0; i < p.Nx; ++i) {
      pinned.push_back(pinned_fraction(simulation.state().junctions, i));
    }
    return pinned;
  };
  std::vector<Rupture> expected;
  std::int64_t last_break = 0;
  bool edge_ruptured = false;
  for (int n = 0; n < kThroughTheRupture; ++n) {
    const std::vector<double> before = fractions();
    const auto draws = simulation.state().junctions.draws.sum();
    simulation.advance();
    plain.advance();
    const std::vector<double> after = fractions();
    if (simulation.state().junctions.draws.sum() > draws) last_break = simulation.state().step;
    for (const double level : {kRupturedFraction, 0.2, 0.55}) {
      for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] < level || after[i] >= level) continue;
        expected.push_back(
            {simulation.state().step, simulation.time(), static_cast<std::int64_t>(i), level});
        edge_ruptured = edge_ruptured || (level == kRupturedFraction && i + 1 == before.size());
      }
    }
    ASSERT_EQ(simulation.run().leading_edge_ruptured, edge_ruptured);
    ASSERT_EQ(simulation.run().last_break, last_break);
  }
  EXPECT_EQ(simulation.ruptures(), expected);
  EXPECT_EQ(simulation.run(), plain.run());
  EXPECT_TRUE(edge_ruptured);
  for (const double level : {kRupturedFraction, 0.2, 0.55}) {
    EXPECT_GE(std::count_if(expected.begin(), expected.end(),
                            [&](const Rupture& r) { return r.pinned_below == level; }),
              6);
  }
}

TEST(Simulation, forgets_ruptures_from_before_it_began) {
  const Parameters p = quick_slider();
  Simulation first(p, normal_load_equilibrium(p));
  while (first.ruptures().size() < 9) first.advance();
  const Simulation second(p, first.state());
  EXPECT_TRUE(second.ruptures().empty());
  EXPECT_FALSE(second.run().leading_edge_ruptured);
  EXPECT_EQ(second.run().last_break, first.state().step);
}

TEST(Helpers, finish_their_bands_before_this_thread_leaves_without_memory) {
  std::atomic<int> finished = 0;
  Helpers helpers(3);
  const BandWork work = [&](int band) {
    if (band > 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ++finished;
  };
  EXPECT_THROW(helpers.share(work, [] { throw std::bad_alloc(); }), std::bad_alloc);
  EXPECT_EQ(finished, 3);
}

TEST(Simulation, goes_on_under_other_parameters_by_one_call_only) {
  const Parameters p = quick_slider();
  Simulation first(p, normal_load_equilibrium(p));
  first.advance(100);
  Parameters stopped = p;
  stopped.V = 0.0;
  EXPECT_EQ(message_of<UsageError>([&] { Simulation(stopped, first.state()); }),
            "driving.V = 0, but the state was made with 0.1: give the state to continued() to "
            "change it");
  EXPECT_EQ(Simulation(stopped, continued(first.state(), stopped)).F_T(), first.F_T());
}

std::string blow_up(double velocity, Eigen::Index i, Eigen::Index j) {
  const Parameters p = quick_slider();
  State state = normal_load_equilibrium(p);
  state.v_x(i, j) = velocity;
  Simulation simulation(p, state);
  return message_of<Failure>([&] { simulation.advance(10); });
}

TEST(BlowUp, is_reported_with_time_and_block) {
  const std::string advice =
      ": start again with a smaller numerics.dt or change the parameters by less";
  EXPECT_EQ(blow_up(1e300, 0, 0), "numerical blow-up at t = 2e-07 s in block (0, 0)" + advice);
  // within one step it reaches the neighbours, of which the first is named
  EXPECT_EQ(blow_up(1e300, 3, 2), "numerical blow-up at t = 2e-07 s in block (2, 1)" + advice);
  EXPECT_EQ(blow_up(-1e200, 8, 4), "numerical blow-up at t = 2e-07 s in block (7, 3)" + advice);
  using Double = std::numeric_limits<double>;
  for (const double velocity : {Double::quiet_NaN(), Double::infinity()}) {
    EXPECT_NE(blow_up(velocity, 4, 0).find("blow-up"), std::string::npos) << velocity;
  }
}

}  // namespace rupture::testing
