// Follows the histories of law_histories.hpp, forwards and backwards.
#include "law_histories.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <ostream>
#include <set>
#include <sstream>

#include "hand_made_interface.hpp"

namespace rupture {
namespace {

using testing::Interface;
using Step = std::map<std::string, double>;

struct History {
  std::string name, text;
  Parameters parameters;
  std::vector<Step> steps;
};

std::ostream& operator<<(std::ostream& out, const History& history) {
  return out << history.text;
}

double number(const std::string& text) {
  const double value = std::stod(text);
  if (text.back() == '+') return std::nextafter(value, 10.0);
  return text.back() == '-' ? std::nextafter(value, 0.0) : value;
}

template <class Use>
void each_pair(const std::string& line, const Use& use) {
  std::istringstream words(line);
  for (std::string word; words >> word;) {
    const auto equals = word.find('=');
    if (equals < word.size() - 1) use(word.substr(0, equals), word.substr(equals + 1));
  }
}

std::vector<History> histories() {
  std::vector<History> all;
  Parameters parameters;
  std::istringstream lines(testing::kLawHistories);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (line.starts_with("==")) {
      parameters = testing::hand_made(1);
      each_pair(line.substr(2), [&](const auto& name, const auto& value) {
        set_parameter(parameters, name, value);
      });
    } else if (line[0] != ' ') {
      const bool breaks = line.ends_with('*');
      if (breaks) line.pop_back();
      all.push_back({testing::law_name(parameters.law) + "_" + line, "", parameters, {}});
      if (breaks) all.back().steps.push_back({{"u", 0.21}, {"broken", 1.0}});
    } else {
      all.back().text += "\n" + line;
      Step& step = all.back().steps.emplace_back();
      each_pair(line, [&](const auto& name, const auto& value) { step[name] = number(value); });
    }
  }
  for (std::size_t n = 0; n < all.size(); ++n) all[n].name += "_" + std::to_string(n);
  return all;
}

const std::set<std::string> kWords = {"p",        "t",      "u",     "f",    "a",   "broken",
                                      "repinned", "pinned", "draws", "left", "slow"};

class ByHand : public ::testing::TestWithParam<History> {
 protected:
  void expect(const Step& step, const char* name, double value) const {
    const auto found = step.find(name);
    if (found == step.end()) return;
    if (found->second == 0.0) {
      EXPECT_EQ(value, 0.0) << name;
    } else {
      EXPECT_NEAR(value, found->second, 2 * testing::kRounding * std::max(1.0, std::abs(value)))
          << name;
    }
  }
};

TEST_P(ByHand, goes_as_worked_out_by_hand) {
  for (const double sign : {1.0, -1.0}) {
    Interface block(GetParam().parameters);
    double t = 0.0;
    int n = 0;
    for (Step step : GetParam().steps) {
      SCOPED_TRACE("step " + std::to_string(++n) + ", sign " + std::to_string(sign));
      if (step.contains("p")) block.press(step["p"]);
      if (step.contains("t")) t = step["t"];
      for (const auto& [name, value] : step) EXPECT_TRUE(kWords.contains(name)) << name;
      const auto changes = block.move(sign * step["u"], t);
      const Junctions& junctions = block.junctions();
      EXPECT_EQ(changes.broken, step["broken"]);
      EXPECT_EQ(changes.repinned, step["repinned"]);
      expect(step, "f", sign * block.friction());
      expect(step, "a", sign * block.attachment());
      expect(step, "pinned", block.pinned());
      expect(step, "draws", junctions.draws(0, 0));
      if (GetParam().parameters.law == Law::distance) {
        EXPECT_EQ(junctions.repin_time(0, 0),
                  block.pinned() == 1 ? Junctions::never : Junctions::unknown);
      }
      if (step.contains("left")) expect(step, "left", junctions.slip_left(0, 0));
      if (step.contains("slow")) expect(step, "slow", sign * junctions.slow_until(0, 0));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, ByHand, ::testing::ValuesIn(histories()),
                         [](const auto& history) { return history.param.name; });

}  // namespace
}  // namespace rupture
