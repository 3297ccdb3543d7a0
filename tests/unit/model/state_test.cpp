// Fields. A change of the time step is in verification/convergence_test.cpp and lineage.txt, one of
// the driving speed in the goldens.
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

}  // namespace rupture::testing
