// Fronts of few blocks, each worked out by hand.
#include <gtest/gtest.h>

#include <string>

#include "rupture/analysis/front.hpp"
#include "rupture/model/derived.hpp"

namespace rupture::testing {

/// A character is a block: 0 to 9, then a to z, in units of 1/16384 s; . if it has no time.
FirstRuptures times_of(const std::string& text) {
  FirstRuptures times;
  for (const char c : text) {
    times.push_back((c >= 'a' ? c - 'a' + 10 : c - '0') / 16384.0);  // differences are exact
    if (c == '.') times.back().reset();
  }
  return times;
}

/// Blocks 0 to 2 are the loading zone. With a stencil of 3, a front that takes n units of time for
/// 5 mm has 82 m/s / n, so it is slow from n = 2 on. With a stencil of 5 it is slow from n = 4 on.
struct FrontByHand {
  std::optional<std::pair<std::size_t, std::size_t>> slow = {};  // first and last block
  std::size_t ahead = 0, backward = 0;
  FrontType type = FrontType::slow;
};

void expect_front(const char* why, const std::string& ruptures, const std::string& front_times,
                  const FrontByHand& expected, Line line = Line::contiguous,
                  std::size_t stencil = 3) {
  SCOPED_TRACE(why);
  Parameters p;  // a part of the reference slider
  p.Nx = std::ssize(ruptures);
  p.L = static_cast<double>(p.Nx - 1) * block_spacing(Parameters{});
  p.M *= p.L / Parameters{}.L;
  const auto x = block_positions(p);
  const FirstRuptures times = times_of(front_times);
  const Front front = measure_front(p, {x, times_of(ruptures)},
                                    {.skip_below_x = x[2], .stencil = stencil, .line = line});
  EXPECT_EQ(front.t_front, times);
  EXPECT_EQ(front.ahead, expected.ahead);
  EXPECT_EQ(front.backward_stencils, expected.backward);
  EXPECT_EQ(front.type, expected.type);
  if (expected.type == FrontType::arrested) {
    EXPECT_EQ(front.x_arrest, x[ruptures.find_last_not_of('.')]);
  } else {
    EXPECT_FALSE(front.x_arrest);
  }
  ASSERT_EQ(front.slow.has_value(), expected.slow.has_value());
  if (!front.slow) return;
  const auto [first, last] = *expected.slow;
  EXPECT_EQ(std::pair(front.slow->x_from, front.slow->x_to), std::pair(x[first], x[last]));
  EXPECT_EQ(front.slow->t_from, times[first]);
  EXPECT_EQ(front.slow->t_to, times[last]);
}

TEST(Front, is_as_worked_out_by_hand) {
  expect_front("It starts at the first of two blocks, 1 and 3, with one block ahead of it.",
               "21212", "21222", {.ahead = 1, .type = FrontType::fast});
  expect_front("It starts amid blocks that ruptured ahead: from block n, 534232555 of them.",
               "615243789", "655244789", {.slow = {{4, 7}}, .ahead = 1, .backward = 1});
  expect_front("Only blocks beyond the loading zone are ahead, also if it arrests.", "0314657.8...",
               "0334667.8...", {.slow = {{3, 4}}, .ahead = 1, .type = FrontType::arrested});
  expect_front("The second stretch lasted longest; the first has more blocks, the third is slower.",
               "001123456677ccdd.dhm.mmnn", "001123456677ccdd.dhm.mmnn", {.slow = {{11, 12}}});
  expect_front("The second stretch lasted as long as the first.", "00112244557788",
               "00112244557788", {.slow = {{5, 6}}});
  expect_front("A stretch goes on over a block that did not rupture.", "0011234.678899",
               "0011234.678899", {.slow = {{4, 9}}});
  expect_front("A stretch starts at a block that ruptured ahead.", "0011215566", "0011225566",
               {.slow = {{5, 6}}, .ahead = 1});
  expect_front("A backward stencil, that of block 6 from 9 to 8, ends a stretch.",
               "001194568bgghhii", "001194568bgghhii", {.slow = {{7, 11}}, .backward = 1},
               Line::raw, 5);
  expect_front("A stretch ends where the next block ruptured earlier.", "00012749aa", "00012749aa",
               {.slow = {{3, 5}}}, Line::raw);
  expect_front("It does so behind a stencil without a speed, that of block 5 from 3 to 3.",
               "00123537888", "00123537888", {.slow = {{6, 7}}}, Line::raw);
  expect_front("Nothing ruptures.", "....", "....", {.type = FrontType::none});
}

}  // namespace rupture::testing
