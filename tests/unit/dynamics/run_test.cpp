// The loop and its stop rules. Observers are tested in tests/tools.
#include "rupture/dynamics/run.hpp"

#include <gtest/gtest.h>

#include "rupture/dynamics/equilibrium.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

/// With ten blocks beyond the loading zone; ruptures from end to end between steps 1,700 and 2,850.
class Run : public ::testing::Test {
 protected:
  static Parameters quickly_ruptured() {
    Parameters p = small_slider(19, 5);
    p.V = 0.1;
    return p;
  }
  const Parameters p_ = quickly_ruptured();
  const State start_ = normal_load_equilibrium(p_);
};

TEST_F(Run, ends_at_a_whole_hundred_after_nothing_broke_for_long_enough) {
  Parameters p = p_;
  p.V = 0.0;
  State state = continued(start_, p);
  Simulation quiet(p, state);
  EXPECT_EQ(run(quiet, {10000, {.quiet_steps = 250, .spanned = true}}, {}), Ending::quiet);
  EXPECT_EQ(quiet.state().step, 300);
  state.junctions.attachment.row(18) -= 1e-5;
  Simulation edge_alone(p, state);  // which is no event that spans
  EXPECT_EQ(run(edge_alone, {10000, {.quiet_steps = 250, .spanned = true}}, {}), Ending::quiet);
  EXPECT_EQ(edge_alone.ruptures().size(), 1U);
  EXPECT_TRUE(edge_alone.run().leading_edge_ruptured);
}

TEST(RunSoFar, tells_whether_one_of_its_events_has_spanned) {
  const Parameters p;
  RunSoFar run = run_from(p, 0);
  const auto has_spanned_after = [&](double t, std::int64_t first, std::int64_t last) {
    for (std::int64_t i = first; i <= last; ++i) add_rupture(p, {0, t += 1e-5, i}, run);
    return run.spanned;
  };
  EXPECT_FALSE(has_spanned_after(1.0, 56, 56)) << "one block";
  EXPECT_FALSE(has_spanned_after(2.0, 0, 35));
  EXPECT_FALSE(has_spanned_after(2.0104, 36, 56)) << "10.03 ms later: another event";
  EXPECT_FALSE(has_spanned_after(3.0, 0, 35));
  EXPECT_TRUE(has_spanned_after(3.0102, 36, 56)) << "9.85 ms later: the same event, 5 t_R = 10 ms";
}

TEST(RunSoFar, goes_on_with_an_event_that_began_before_it) {
  const Parameters p;
  RunSoFar before = run_from(p, 0);
  for (std::int64_t i = 0; i < 40; ++i) add_rupture(p, {0, 1.0, i}, before);
  const auto spans_with = [&](const LatestEvent& event, std::int64_t first, double pause) {
    RunSoFar run = run_from(p, 10, event);
    if (pause > 0.0) run.early.quiet_time = pause;
    for (std::int64_t i = first; i < 57; ++i) add_rupture(p, {0, 1.005, i}, run);
    return run.spanned;
  };
  EXPECT_TRUE(spans_with(before.event, 40, 0.0)) << "by half of it";
  EXPECT_FALSE(spans_with({}, 40, 0.0));
  EXPECT_FALSE(spans_with(before.event, 40, 0.004)) << "another event, with this --quiet-time";
  for (std::int64_t i = 40; i < 57; ++i) add_rupture(p, {0, 1.001, i}, before);
  EXPECT_FALSE(spans_with(before.event, 0, 0.0)) << "it had spanned before the run began";
}

TEST(PauseBetweenEvents, is_not_set_by_a_patch) {
  Parameters p;
  EXPECT_DOUBLE_EQ(pause_between_events(p), 5 * 2e-3);
  std::vector<double> t_R(57, 2e-3);
  for (const std::size_t i : {20, 21, 22, 23, 24}) t_R[i] = 20e-3;
  p.t_R = AlongX<double>(t_R);
  EXPECT_DOUBLE_EQ(pause_between_events(p), 5 * 2e-3);
  EXPECT_EQ(AlongX<double>({4, 1, 3, 2}).median(), 2);
}

TEST_F(Run, ends_at_rest_once_nothing_can_rupture) {
  for (const Law law : kAllLaws) {
    Parameters p = quick_slider(law);
    p.V = 0.0;
    const Parameters driven = quick_slider(law);
    Simulation loading(driven, normal_load_equilibrium(driven));
    loading.advance(1350);  // half of the blocks have ruptured
    Simulation stopped(p, continued(loading.state(), p));
    EXPECT_EQ(run(stopped, {1'000'000, {.rupture_of = 8}}, {}),
              stopped.ruptures().empty() ? Ending::at_rest : Ending::ruptured);
    EXPECT_EQ(run(stopped, {1'000'000, {.spanned = true}}, {}), Ending::at_rest);
    const std::size_t ruptures = stopped.ruptures().size();
    stopped.advance(50'000);
    EXPECT_EQ(stopped.ruptures().size(), ruptures) << "nothing ruptured any more";
    EXPECT_EQ(run(stopped, {stopped.state().step + 100, {}}, {}), Ending::last_step);
  }
}

TEST_F(Run, is_at_rest_only_if_the_drive_stands_still) {
  for (const double V : {0.0, 1e-6}) {
    Parameters p = p_;
    p.V = V;
    State state = normal_load_equilibrium(p);
    state.step = 10'000 * kQuietCheck;
    const auto end = ending_at(state, {}, {2 * state.step, {.spanned = true}});
    EXPECT_EQ(end, V > 0 ? std::nullopt : std::optional(Ending::at_rest));
  }
}

TEST_F(Run, asks_more_often_whether_it_is_interrupted_where_there_are_many_junctions) {
  Parameters p = p_;
  p.N_s = 100000;
  Simulation simulation(p, normal_load_equilibrium(p));
  int questions = 0;
  const auto interrupted = [&] { return ++questions > 1; };
  EXPECT_EQ(run(simulation, {.last_step = 100, .early = {}, .interrupted = interrupted}, {}),
            Ending::interrupted);
}

}  // namespace rupture::testing
