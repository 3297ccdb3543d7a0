// Fields, the initial state and the quantities that are read off a state.
#include "rupture/model/state.hpp"

#include <gtest/gtest.h>

namespace rupture::testing {

TEST(Field, keeps_zero_padding_around_every_row) {
  for (Eigen::Index Nx = 1; Nx <= 20; ++Nx) {
    Field field(Nx, 3);
    EXPECT_EQ(field.stride() % 8, 0);
    EXPECT_GT(field.stride(), Nx);
    field.blocks() = 1.0;
    for (Eigen::Index j = -1; j <= 3; ++j) {
      for (Eigen::Index i = -1; i < field.stride(); ++i) {
        const bool inside = i >= 0 && i < Nx && j >= 0 && j < 3;
        EXPECT_EQ(field.row(j)[i], inside ? 1.0 : 0.0) << Nx << ": " << i << ", " << j;
      }
    }
  }
}

TEST(State, tells_time_and_driving_point_from_the_step_count) {
  Parameters p;
  p.dt = 0.1;
  p.V = 2.0;
  State state(p);
  state.step = 3;
  EXPECT_EQ(time(p, state), 3 * 0.1);  // not 0.1 + 0.1 + 0.1
  EXPECT_EQ(drive_position(p, {0, 0.0}, 3), 2.0 * (3 * 0.1));
  EXPECT_EQ(drive_position(p, {13, 5.0}, 13), 5.0);
}

TEST(State, goes_on_in_time_and_drive_when_the_time_step_changes) {
  Parameters p;
  p.dt = 0.5;
  p.V = 2.0;
  State state(p);
  state.step = 7;
  Parameters after = p;
  after.dt = 0.125;
  change_pace(p, after, state);
  EXPECT_EQ(state.clock, (Clock{7, 3.5}));
  EXPECT_EQ(time(after, state), 3.5);
  EXPECT_EQ(drive_position(after, state.drive, 7), 7.0);
  state.step = 9;
  EXPECT_EQ(time(after, state), 3.75);
  EXPECT_EQ(time_at(after, state.clock, 15), 4.5);
  EXPECT_EQ(drive_position(after, state.drive, 9), 7.5);
  change_pace(after, p, state);
  EXPECT_EQ(state.clock, (Clock{9, 3.75}));
  EXPECT_EQ(drive_position(p, state.drive, 10), 8.5);
}

TEST(State, keeps_its_clock_when_only_the_driving_speed_changes) {
  Parameters p;
  p.dt = 0.5;
  p.V = 2.0;
  State state(p);
  state.step = 7;
  Parameters after = p;
  change_pace(p, after, state);
  EXPECT_EQ(state.drive.origin_step, 0);
  after.V = -1.0;
  change_pace(p, after, state);
  EXPECT_EQ(state.clock, Clock{});
  EXPECT_EQ(drive_position(after, state.drive, 8), 6.5);
}

}  // namespace rupture::testing
