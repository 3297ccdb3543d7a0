// modify-phi: the histogram that it prints; its numbers are in tables/modify_phi.txt.
#include <numeric>
#include <sstream>

#include "tool_test.hpp"

namespace rupture::testing {
namespace {

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

using ModifyPhi = ToolTest;

TEST_F(ModifyPhi, prints_the_histogram_of_the_changed_blocks_before_and_after) {
  output_of("load --config small.ini -o a.h5 --until 1.9e-4");
  const std::string out =
      output_of("modify-phi a.h5 -o b.h5 --slipping pin --sigma-bar 0.2 --x-from 0.05 --x-to 0.09");
  const auto counted = [&](const std::string& file) {
    const Json blocks = json_of("analyze phi " + file + " --json --bins 20");
    std::vector<int> sum(20);
    for (std::size_t i = 0; i < blocks["x"].size(); ++i) {
      const std::vector<int> counts = blocks["histogram"][i];
      EXPECT_EQ(counts.size(), 20U);
      EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0), 100);
      if (blocks["x"][i] < 0.05 || blocks["x"][i] > 0.09) continue;
      for (std::size_t n = 0; n < 20; ++n) sum[n] += counts[n];
    }
    return sum;
  };
  const Histograms printed = printed_histograms(out);
  EXPECT_EQ(printed.before, counted("a.h5")) << out;
  EXPECT_EQ(printed.after, counted("b.h5")) << out;
}

}  // namespace
}  // namespace rupture::testing
