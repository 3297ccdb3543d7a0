// A run that is interrupted and taken up again arrives at the bits of one that
// is not: before, during and after the rupture of the interface.
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "rupture/checkpoint/checkpoint.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/dynamics/equilibrium.hpp"
#include "support/files.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

struct Split {
  std::string name;
  std::int64_t ruptures;  ///< split 5 steps after this many blocks have ruptured
  std::int64_t steps;     ///< but not before this step
};

std::string checksum(const Simulation& simulation) {
  return content_checksum(checkpoint_content({simulation.parameters(), simulation.state(), {}}));
}

class RunSplit : public ::testing::TestWithParam<std::tuple<Law, Split>> {
 protected:
  RunSplit()
      : p_(quick_slider(std::get<Law>(GetParam()))), whole_(p_, normal_load_equilibrium(p_)) {
    const Split& split = std::get<Split>(GetParam());
    const auto wanted = static_cast<std::size_t>(split.ruptures);
    while (whole_.state().step < split.steps || whole_.ruptures().size() < wanted) {
      whole_.advance();
    }
    whole_.advance(5);
    if (split.name != "during") return;
    EXPECT_LT(whole_.ruptures().size(), 9U);
    EXPECT_GT((whole_.state().junctions.repin_time < Junctions::never).count(), 0);
  }
  Parameters p_;
  Simulation whole_;  ///< has arrived at the step of the split
};

TEST_P(RunSplit, by_a_checkpoint_file_gives_the_bits_of_one_run) {
  const std::int64_t N = whole_.state().step;
  const std::size_t ruptures = whole_.ruptures().size();
  const Folder folder;
  write_checkpoint(folder.file("split.h5"), {p_, whole_.state(), {}}, IfExists::refuse);
  const Checkpoint checkpoint = read_checkpoint(folder.file("split.h5"));
  Simulation second(checkpoint.parameters, checkpoint.state);
  EXPECT_EQ(checksum(second), checksum(whole_));
  whole_.advance(N);
  EXPECT_NE(checksum(second), checksum(whole_));
  second.advance(N);
  EXPECT_EQ(checksum(second), checksum(whole_));
  EXPECT_EQ(second.ruptures(),
            std::vector<Rupture>(whole_.ruptures().begin() + static_cast<std::ptrdiff_t>(ruptures),
                                 whole_.ruptures().end()));
}

INSTANTIATE_TEST_SUITE_P(AtRupture, RunSplit,
                         ::testing::Combine(::testing::ValuesIn(kAllLaws),
                                            ::testing::Values(Split{"before", 0, 500},
                                                              Split{"during", 4, 0},
                                                              Split{"after", 9, 2500})),
                         [](const auto& run) {
                           return law_name(std::get<Law>(run.param)) + "_" +
                                  std::get<Split>(run.param).name;
                         });

class DeterminismOf : public ::testing::TestWithParam<Law> {};

INSTANTIATE_TEST_SUITE_P(Law, DeterminismOf, ::testing::ValuesIn(kAllLaws),
                         [](const auto& law) { return law_name(law.param); });

TEST_P(DeterminismOf, any_number_of_threads_gives_the_same_bits_through_a_rupture) {
  const Parameters p = quick_slider(GetParam());
  const State start = normal_load_equilibrium(p);
  Simulation alone(p, start);
  alone.advance(3000);
  ASSERT_GT(alone.ruptures().size(), 8U);
  for (const int threads : {2, 3, 4, 7}) {
    Simulation together(p, start, threads);
    for (const std::int64_t steps : {1, 0, 2, 997, 2000}) together.advance(steps);
    EXPECT_EQ(checksum(together), checksum(alone)) << threads;
    EXPECT_EQ(together.ruptures(), alone.ruptures()) << threads;
    EXPECT_EQ(together.work().damping, alone.work().damping) << threads;
    EXPECT_EQ(together.work().junctions, alone.work().junctions) << threads;
  }
}

}  // namespace rupture::testing
