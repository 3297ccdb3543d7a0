// A record that begins inside an event shows, beyond its beginning, the front that the whole record
// shows: under each law and on a prepared interface, cut at each rupture.
#include <gtest/gtest.h>

#include "rupture/analysis/front.hpp"
#include "rupture/checkpoint/record.hpp"
#include "rupture/model/laws.hpp"
#include "support/sliders.hpp"

namespace rupture::testing {

constexpr std::int64_t kSteps = 4000;

struct Slider {
  std::string name;
  Parameters p;
  State state;
};

Slider sliding(Law law) {
  const Parameters p = quick_slider(law);
  return {std::string(law_info(law).name), p, normal_load_equilibrium(p)};
}

std::vector<Slider> all_sliders() {
  std::vector<Slider> sliders;
  for (const Law law : kAllLaws) sliders.push_back(sliding(law));
  const Parameters p = prepared_slider();
  sliders.push_back({"prepared", p, prepared_state(p, quick_prestress())});
  return sliders;
}

/// The ruptures of what is left of the run, as a record of it holds them.
std::vector<Rupture> recorded_from(const Simulation& start, std::int64_t steps) {
  const Parameters& p = start.parameters();
  Simulation rest(p, start.state());
  rest.resume_from(run_from(p, start.state().step, start.run().event));
  Record record;
  record.parameters = p;
  record.before = rest.run().event;
  record.time = {rest.time()};
  rest.advance(steps);
  record.ruptures.assign(rest.ruptures().begin(), rest.ruptures().end());
  return ruptures_below(record, kRupturedFraction);
}

std::vector<Event> events_of(const Parameters& p, std::span<const Rupture> ruptures, double from) {
  const std::vector<double> time = {from, static_cast<double>(kSteps) * p.dt}, F_T = {0.0, 0.0};
  return find_events(p, ruptures, {time, F_T}, pause_between_events(p), {.skip_below_x = 2e-3});
}

TEST(CutRecord, shows_the_front_of_the_whole_record_beyond_the_cut) {
  for (const Slider& slider : all_sliders()) {
    const Parameters& p = slider.p;
    Simulation whole(p, slider.state), start(p, slider.state);
    whole.advance(kSteps);
    const auto events = events_of(p, whole.ruptures(), 0.0);
    int cuts = 0;
    for (const Rupture& last : whole.ruptures()) {
      if (last.step == start.state().step || last.time == whole.ruptures().back().time) continue;
      start.advance(last.step - start.state().step);
      const Event& expected = *std::ranges::find_if(
          events, [&](const Event& event) { return event.t_end >= last.time; });
      if (last.time == expected.t_end) continue;
      const auto ruptures = recorded_from(start, kSteps - last.step);
      const Front found = events_of(p, ruptures, start.time()).at(0).front, &all = expected.front;
      SCOPED_TRACE(slider.name + " cut at " + std::to_string(last.time));
      ++cuts;
      for (std::size_t i = 2; i + 2 < all.v_c.size(); ++i) {
        bool is_beyond = true;
        for (const std::size_t j : {i - 2, i, i + 2}) is_beyond &= all.t_front[j] > last.time;
        EXPECT_EQ(found.v_c[i], is_beyond ? all.v_c[i] : std::nullopt) << i;
      }
      const bool is_empty =
          std::ranges::none_of(found.line.t_rupture, [](const auto& t) { return t.has_value(); });
      EXPECT_EQ(spans(found.type), spans(all.type) && !is_empty);
      EXPECT_EQ(found.x_arrest, all.x_arrest);
    }
    EXPECT_GE(cuts, 5) << slider.name;
  }
}

}  // namespace rupture::testing
