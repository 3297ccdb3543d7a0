// modify-phi: new forces in the junctions, the same force on each block.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "tool_test.hpp"

namespace rupture::testing {
namespace {

class ModifyPhi : public ToolTest {
 protected:
  /// A checkpoint amid the rupture: some blocks slip, others are pinned.
  ModifyPhi() { output_of("load --config small.ini -o a.h5 --until 1.9e-4"); }

  std::vector<double> stress(const std::string& file, const char* what) const {
    return json_of("analyze stress " + file + " --json")[what];
  }
  std::vector<double> phi(const std::string& file, const char* what) const {
    return json_of("analyze phi " + file + " --json")[what];
  }
  void expect_same_friction(const std::string& file) const {
    const auto before = stress("a.h5", "tau"), after = stress(file, "tau");
    const double largest = *std::max_element(before.begin(), before.end());
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_NEAR(after[i], before[i], 1e-12 * largest) << "block " << i;
    }
    EXPECT_EQ(stress(file, "p"), stress("a.h5", "p"));
  }
};

TEST_F(ModifyPhi, keeps_the_friction_of_each_block) {
  const auto slipping = phi("a.h5", "slipping");
  ASSERT_GT(slipping[1], 0.7);
  ASSERT_LT(slipping[7], 0.3);
  for (const std::string options :
       {"", " --shape bell", " --sigma-bar 0.1", " --shape bell --slipping pin",
        " --slipping pin --sigma-bar 0.2"}) {
    output_of("modify-phi a.h5 -o b.h5 --force" + options);
    expect_same_friction("b.h5");
  }
}

TEST_F(ModifyPhi, gives_the_wanted_width) {
  output_of("modify-phi a.h5 -o b.h5 --slipping pin --sigma-bar 0.1");
  output_of("modify-phi a.h5 -o c.h5 --slipping pin --sigma-bar 0.1 --shape bell");
  for (const char* file : {"b.h5", "c.h5"}) {
    for (const double sigma : phi(file, "sigma_bar")) EXPECT_NEAR(sigma, 0.1, 0.002);
  }
}

TEST_F(ModifyPhi, without_width_is_as_wide_as_each_block_allows) {
  output_of("modify-phi a.h5 -o b.h5 --slipping pin");
  const auto mean = phi("b.h5", "mean"), sigma = phi("b.h5", "sigma");
  const auto f_thres = phi("b.h5", "f_thres");
  for (std::size_t i = 0; i < mean.size(); ++i) {
    const double half_width = f_thres[i] - std::abs(mean[i]);
    EXPECT_NEAR(sigma[i], half_width / std::sqrt(3.0), 0.01 * half_width) << "block " << i;
  }
}

TEST_F(ModifyPhi, changes_only_the_region) {
  const std::string out =
      output_of("modify-phi a.h5 -o b.h5 --slipping pin --sigma-bar 0.2 --x-from 0.05 --x-to 0.09");
  const auto before = phi("a.h5", "sigma"), after = phi("b.h5", "sigma");
  const auto sigma_bar = phi("b.h5", "sigma_bar"), x = phi("b.h5", "x");
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] >= 0.05 && x[i] <= 0.09) {
      EXPECT_NEAR(sigma_bar[i], 0.2, 0.01) << out;
    } else {
      EXPECT_EQ(after[i], before[i]) << out;
    }
  }
}

/// The printed histogram, from the lowest force to the highest.
struct Histograms {
  std::vector<int> before, after;
};

/// Its rows: from, to, count before, perhaps a bar, count after, perhaps a bar.
Histograms printed_histograms(const std::string& out) {
  Histograms result;
  std::istringstream lines(out);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream row(line);
    double from = 0, to = 0;
    int before = 0, after = 0;
    if (!(row >> from >> to >> before >> std::ws)) continue;
    if (row.peek() == '#') {
      std::string bar;
      row >> bar;
    }
    if (!(row >> after)) continue;
    result.before.push_back(before);
    result.after.push_back(after);
  }
  return result;
}

TEST_F(ModifyPhi, prints_the_histogram_of_the_changed_blocks_before_and_after) {
  const std::string out =
      output_of("modify-phi a.h5 -o b.h5 --slipping pin --sigma-bar 0.2 --x-from 0.05 --x-to 0.09");
  const auto counted = [&](const std::string& file) {
    const Json blocks = json_of("analyze phi " + file + " --json --bins 20");
    std::vector<int> sum(20);
    for (std::size_t i = 0; i < blocks["x"].size(); ++i) {
      if (blocks["x"][i] < 0.05 || blocks["x"][i] > 0.09) continue;
      for (std::size_t n = 0; n < 20; ++n) sum[n] += blocks["histogram"][i][n].get<int>();
    }
    return sum;
  };
  const Histograms printed = printed_histograms(out);
  EXPECT_EQ(printed.before, counted("a.h5")) << out;
  EXPECT_EQ(printed.after, counted("b.h5")) << out;
}

}  // namespace
}  // namespace rupture::testing
