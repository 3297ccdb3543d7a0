// analyze front, classify, slow-slip: which event they speak of where a record holds several.
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

/// Seven events within 6 ms; the second and the fourth span the interface.
class EventChoice : public ToolTest {
 protected:
  EventChoice() {
    output_of(
        "load --config small.ini -o a.h5 --until 6e-3 --record r.h5 --record-every 1e-4 "
        "--set driving.V=0.1 --set junctions.t_R=2e-5 --set junctions.delta_t_R=0 -q");
  }
};

constexpr const char* kSeveral =
    "there are 7 events (0 at 0.001513 s, 1 at 0.001893 s, 2 at 0.003253 s, ..., 6 at 0.005416 s): "
    "choose one with --event N or --event first-spanning, or with --from and --to";

TEST_F(EventChoice, several_events_make_no_front) {
  ASSERT_EQ(json_of("analyze events r.h5 --json")["events"].size(), 7U);
  for (const std::string command : {"front", "classify", "slow-slip"}) {
    expect_refusal("analyze " + command + " r.h5", kFailed, kSeveral);
  }
  expect_refusal("analyze front r.h5 --from 3e-3 --to 4.5e-3", kFailed,
                 "there are 2 events (2 at 0.003253 s, 3 at 0.003568 s): choose one with --event N "
                 "or --event first-spanning, or with --from and --to");
}

TEST_F(EventChoice, an_event_is_named_by_its_number_or_its_time) {
  const Json events = json_of("analyze events r.h5 --json")["events"];
  for (std::size_t n = 0; n < events.size(); ++n) {
    EXPECT_EQ(events[n]["number"], n);
    const Json front = json_of("analyze front r.h5 --json --event " + std::to_string(n));
    EXPECT_EQ(front["t_rupture"], events[n]["t_rupture"]) << n;
    EXPECT_EQ(front["type"], events[n]["type"]) << n;
  }
  const Json second = json_of("analyze front r.h5 --event 1 --json");
  EXPECT_EQ(json_of("analyze front r.h5 --from 1.8e-3 --to 3e-3 --json"), second);
  EXPECT_EQ(output_of("analyze classify r.h5 --event 0"), "arrested\n");
  EXPECT_EQ(output_of("analyze classify r.h5 --event 1"), "fast\n");
  EXPECT_EQ(json_of("analyze slow-slip r.h5 --event 1 --json")["type"], "fast");
}

TEST_F(EventChoice, the_first_spanning_event_may_be_meant) {
  EXPECT_EQ(output_of("analyze front r.h5 --event first-spanning"),
            output_of("analyze front r.h5 --event 1"));
  output_of("load --config small.ini -o b.h5 --until 2e-4 --record early.h5 -q");
  expect_refusal("analyze front early.h5 --event first-spanning", kFailed,
                 "none of the 1 events in this record spans the interface: give --event N (analyze "
                 "events lists them)");
}

TEST_F(EventChoice, an_event_that_reaches_the_edge_without_spanning_is_arrested) {
  const std::string front = "analyze front r.h5 --quiet-time 1e-5 --json --event ";
  for (const char* n : {"11", "23"}) {  // backwards from the edge; one block there and the first
    const Json json = json_of(front + n);
    EXPECT_EQ(json["type"], "arrested") << n;
    EXPECT_EQ(json["reached_edge"], true) << n;
    EXPECT_NEAR(json["x_arrest"], 0.14, 1e-12) << n;
  }
  EXPECT_EQ(json_of(front + "first-spanning"), json_of(front + "24"));
}

TEST_F(EventChoice, the_quiet_time_splits_as_in_events) {
  EXPECT_EQ(json_of("analyze events r.h5 --quiet-time 1 --json")["events"].size(), 1U);
  EXPECT_EQ(output_of("analyze front r.h5 --quiet-time 1"),
            output_of("analyze front r.h5 --quiet-time 1 --event 0"));
}

TEST_F(EventChoice, refuses_events_that_there_are_not) {
  expect_refusal("analyze front r.h5 --event 7", kUsage,
                 "there is no event 7: this record has 0 to 6 (analyze events lists them)");
  for (const std::string name : {"-1", "1.5", "last"}) {
    expect_refusal("analyze front r.h5 --event " + name, kUsage,
                   "--event " + name +
                       " names no event: give its number in analyze events, or first-spanning");
  }
  output_of("load --config small.ini -o b.h5 --until 1e-4 --record quiet.h5 -q");
  expect_refusal("analyze front quiet.h5 --event 0", kUsage,
                 "there is no event 0: in this record nothing ruptured");
}

TEST_F(EventChoice, an_event_and_a_window_exclude_each_other) {
  for (const std::string command : {"front", "classify", "slow-slip"}) {
    for (const std::string window : {"--from 1e-3", "--to 2e-3"}) {
      expect_refusal("analyze " + command + " r.h5 --event 1 " + window, kUsage,
                     "--event and --from or --to exclude each other: give one of them");
    }
  }
}

TEST_F(EventChoice, where_nothing_ruptured_there_is_no_front) {
  const std::string window = " r.h5 --from 4.3e-3 --to 4.5e-3";
  EXPECT_EQ(output_of("analyze classify" + window), "none\n");
  const Json front = json_of("analyze front" + window + " --json");
  EXPECT_EQ(front["type"], "none");
  EXPECT_TRUE(front["x_arrest"].is_null());
  EXPECT_EQ(json_of("analyze slow-slip" + window + " --json")["type"], "none");
  for (const std::string command : {"front", "slow-slip"}) {
    EXPECT_EQ(lines_of(output_of("analyze " + command + window)).back(),
              "no front: nothing ruptured from t = 0.0043 s to 0.0045 s");
  }
}

/// Events after the trigger's on a prepared interface are no reason to refuse it.
TEST_F(EventChoice, on_a_prepared_interface_the_triggers_event_is_meant) {
  output_of("prepare --config small.ini --set driving.V=0 --tau-bar 0.8 -o p.h5 -q");
  output_of("restart p.h5 -o q.h5 --for 6e-5 --record early.h5 -q");
  const std::string quiet = " --quiet-time 5e-6";
  ASSERT_GT(json_of("analyze events early.h5 --json" + quiet)["events"].size(), 1U);
  EXPECT_EQ(json_of("analyze front early.h5 --json" + quiet),
            json_of("analyze front early.h5 --event 0 --json" + quiet));
  const std::string last = lines_of(output_of("analyze front early.h5" + quiet)).back();
  EXPECT_NE(last.find("; event 0, the trigger's, of "), std::string::npos) << last;

  output_of("restart q.h5 -o s.h5 --for 2e-4 --record later.h5 -q");
  expect_refusal_with("analyze front later.h5" + quiet, kFailed, "choose one with --event N");
}

TEST_F(EventChoice, events_as_csv_have_what_the_json_has) {
  const auto rows =
      csv_of(output_of("analyze events r.h5 --csv --slow-below 3 --stencils-at-ends slow"));
  const Json events =
      json_of("analyze events r.h5 --json --slow-below 3 --stencils-at-ends slow")["events"];
  const std::vector<std::string> head = {"number",
                                         "t_start [s]",
                                         "t_end [s]",
                                         "x_first [m]",
                                         "x_last [m]",
                                         "spanning",
                                         "type",
                                         "reached_edge",
                                         "fast_slow_fast",
                                         "backward_stencils",
                                         "slow.x_from [m]",
                                         "slow.x_to [m]",
                                         "slow.t_from [s]",
                                         "slow.t_to [s]",
                                         "slow.duration [s]",
                                         "slow.speed [m/s]",
                                         "slow.slowest [m/s]",
                                         "slow.stencils",
                                         "slow.mean [m/s]",
                                         "slow.fast_before [m/s]",
                                         "slow.fast_after [m/s]",
                                         "F_T_before [N]",
                                         "F_T_after [N]"};
  ASSERT_EQ(rows.size(), events.size() + 1);
  EXPECT_EQ(rows[0], head);
  for (std::size_t n = 0; n < events.size(); ++n) {
    const auto& row = rows[n + 1];
    ASSERT_EQ(row.size(), head.size());
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

TEST_F(EventChoice, events_as_text_begin_with_the_number) {
  const auto lines = lines_of(output_of("analyze events r.h5"));
  ASSERT_EQ(lines.size(), 8U);
  EXPECT_EQ(lines[0].find("number"), 0U);
  EXPECT_EQ(std::stoi(lines[7]), 6);
}

}  // namespace
}  // namespace rupture::testing
