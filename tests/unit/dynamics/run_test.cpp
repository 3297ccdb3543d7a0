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
