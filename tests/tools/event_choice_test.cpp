// analyze front, classify, slow-slip: which event they speak of where a record holds several.
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

/// Seven events within 6 ms.
class EventChoice : public ToolTest {
 protected:
  EventChoice() {
    output_of(
        "load --config small.ini -o a.h5 --until 6e-3 --record r.h5 --record-every 1e-4 "
        "--set driving.V=0.1 --set junctions.t_R=2e-5 --set junctions.delta_t_R=0 -q");
  }
};

TEST_F(EventChoice, an_event_is_named_by_its_number) {
  const Json events = json_of("analyze events r.h5 --json")["events"];
  for (std::size_t n = 0; n < events.size(); ++n) {
    EXPECT_EQ(events[n]["number"], n);
    const Json front = json_of("analyze front r.h5 --json --event " + std::to_string(n));
    EXPECT_EQ(front["t_rupture"], events[n]["t_rupture"]) << n;
    EXPECT_EQ(front["type"], events[n]["type"]) << n;
  }
}

TEST_F(EventChoice, events_as_csv_have_what_the_json_has) {
  const auto rows =
      csv_of(output_of("analyze events r.h5 --csv --slow-below 3 --stencils-at-ends slow"));
  const Json events =
      json_of("analyze events r.h5 --json --slow-below 3 --stencils-at-ends slow")["events"];
  ASSERT_EQ(rows.size(), events.size() + 1);
  for (std::size_t n = 0; n < events.size(); ++n) {
    const auto& row = rows[n + 1];
    ASSERT_EQ(row.size(), 23U);
    EXPECT_EQ(row[0], std::to_string(n));
    EXPECT_EQ(std::stod(row[1]), events[n]["t_start"]);
    EXPECT_EQ(row[5], events[n]["spanning"] ? "true" : "false");
    EXPECT_EQ(row[6], events[n]["type"].get<std::string>());
    const Json& slow = events[n]["slow"];
    EXPECT_EQ(row[7], events[n]["reached_edge"] ? "true" : "false");
    EXPECT_EQ(std::stoi(row[9]), events[n]["backward_stencils"]);
    EXPECT_EQ(row[10].empty(), slow.is_null());
    if (!slow.is_null()) {
      EXPECT_EQ(std::stod(row[15]), slow["speed"]);
      EXPECT_EQ(std::stod(row[16]), slow["slowest"]);
    }
  }
  EXPECT_FALSE(rows[2][10].empty()) << "the second event is slow by this measure";
}

}  // namespace
}  // namespace rupture::testing
