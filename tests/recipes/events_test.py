"""Kinds of events, and which of a load are shown (recipes/common/events)."""

import json

import numpy as np
from pytest import mark, raises

from claims.judge import holds
from conftest import approx
from data.value import main as value
from events.choose_events import choose, read_events
from events.conventions import CONVENTIONS, PRIMARY, WITH_ENDS
from events.event_claims import case_3Cv, judged_event
from events.front_claims import speeds_compared
from events.slip import with_peak_speed
from events.units import of_event
from pictures.panels import ruptured_early


def event(t_start, *, kind="slow", fast_slow_fast=True):
    return {"t_start": t_start, "type": kind, "fast_slow_fast": fast_slow_fast}


class TestChoice:
    def test_the_fast_event_comes_after_the_first_slow_one(self):
        events = [
            event(0.1, kind="fast", fast_slow_fast=False),
            event(0.2),
            event(0.3, kind="fast", fast_slow_fast=False),
            event(0.4, fast_slow_fast=False),
            event(0.5),
        ]
        chosen = {name: found["t_start"] for name, found in choose(events).items()}
        assert chosen == {"fast-slow-fast": 0.2, "fast-only": 0.3, "second-slow": 0.5}

    def test_a_load_with_one_slow_event_has_no_second(self):
        chosen = choose([event(0.1)])
        assert chosen["second-slow"] is None
        assert chosen["fast-only"] is None


def test_a_missing_value_is_an_error(tmp_path):
    path = tmp_path / "front.json"
    path.write_text('{"slow": null, "t": [null, 2.0]}')
    assert value(path, "t.1") == 2
    for name in ("t.0", "slow.t_to"):
        with raises(SystemExit, match=f"has no number or name {name}"):
            value(path, name)


def test_blocks_ahead_of_a_front_rupture_long_before_their_neighbours():
    milliseconds = np.array([0, 5, 3, 5, np.nan, 9])  # a front of c_s/100 needs 1 ms per block
    for unit, ahead in ((1e-3, [0, 2]), (1e-4, [])):
        front = {"t_rupture": milliseconds * unit, "L": 0.05, "c_s": 1000.0}
        assert np.flatnonzero(ruptured_early(front)).tolist() == ahead


@mark.parametrize("kind, spans", [("slow", True), ("arrested", False), ("none", False)])
def test_a_front_that_arrests_or_never_starts_does_not_span(kind, spans):
    slow = {"slow": {"speed": 10.0}}
    assert judged_event("3A", {"event": (slow, slow | {"type": kind})}, {}).shown == spans


class TestConventions:
    def test_each_differs_from_the_primary_one_in_one_way(self):
        assert CONVENTIONS[PRIMARY] == {}
        others = [options for name, options in CONVENTIONS.items() if name != PRIMARY]
        assert {len(options) for options in others} == {1}


# Slip of a block: 1 um, then 5 um in 0.05 ms (0.1 m/s), then 1 um; after its arrest, faster still.
SLIP = {
    "time": [0.0, 1e-4, 1.5e-4, 2.5e-4, 2.6e-4],
    "slip": [0.0, 1e-6, 6e-6, 7e-6, 27e-6],
    "t_arrest": 2.5e-4,
    "fast_slip": 7e-6,
    "slow_slip": 2e-6,
    "slow_speed": 2e-3,
}


class TestSlip:
    def test_the_peak_speed_is_that_before_the_arrest_and_both_ratios_are_reported(self):
        claim = judged_event("3Cv", {"event II": ({"stopped": with_peak_speed(SLIP)},)}, {})
        assert claim.shown
        for name, expected in (
            ("peak slip speed [mm/s]", 100.0),
            ("peak/slow speed", 50.0),
            ("fast/slow slip distance", 3.5),
            ("peak speed over the paper's", 1.0),
        ):
            assert claim.measured[name] == approx(expected), name

    def test_a_block_that_never_stops_counts_against_the_claim(self):
        unstopped = with_peak_speed(
            SLIP | dict.fromkeys(("t_arrest", "fast_slip", "slow_slip", "slow_speed"))
        )
        claim = judged_event("3Cv", {"event II": ({"stopped": unstopped},)}, {})
        assert not claim.shown
        assert claim.measured["peak/slow speed"] is None

    def test_within_a_factor_of_two(self):
        for speed, expected in ((0.0499, False), (0.05, True), (0.2, True), (0.201, False)):
            case = case_3Cv({"stopped": {"peak_speed": speed}})
            assert holds("3Cv", [case]) == expected, speed

    def test_units_are_measured_at_each_branch_and_of_each_block(self):
        def slips(speed):
            return {"slip": {x: {"stopped": {"peak_speed": speed}} for x in ("0.34", "0.30")}}

        branches = {"0.14": slips(0.1), "0.2": slips(0.3), "0.25": None}
        cases = of_event("3Cv", {"branches": branches})
        speed = "peak slip speed [mm/s]"
        assert cases[PRIMARY] == [{speed: 100.0}]
        assert cases["branch at 0.2 L"] == [{speed: 300.0}]
        assert cases["branch at 0.25 L"] == []
        assert cases["block at 0.30 L"] == [{speed: 100.0}]
        assert cases["block at 0.38 L"] == []


def test_speeds_are_compared_with_the_papers():
    slow = {"speed": 12.0, "mean": 15.0, "slowest": 20.0, "fast_before": 600.0}
    case = {"fast before/c_s": 2 / 3, "slowest/c_s": 1 / 50, "fast/slowest": 30.0}
    assert speeds_compared({"slow": slow}, case) == {
        "fast before [m/s]": 600.0,
        "over the paper's c_s/3": approx(2),
        "median slow speed [m/s]": 12.0,
        "mean slow speed [m/s]": 15.0,
        "slowest stencil [m/s]": 20.0,
        "slowest over the paper's c_s/100": approx(2),
        "fast/slowest": 30.0,
        "over the paper's 33": approx(0.9),
    }


@mark.parametrize(
    "x_from, x_to, lasts", [(0.06, 0.09, 2.0), (0.01, 0.03, None), (0.06, 0.07, None)]
)
def test_the_time_between_crossings_is_that_of_the_same_stretch(tmp_path, x_from, x_to, lasts):
    within = {"x_from": 0.07, "x_to": 0.08, "duration": 1.0}
    around = {"x_from": x_from, "x_to": x_to, "duration": 2.0}
    found = {PRIMARY: [{"slow": within}, {"slow": None}], WITH_ENDS: 2 * [{"slow": around}]}
    (tmp_path / "events.json").write_text(json.dumps(found))
    first, other = read_events(tmp_path / "events.json")
    assert (first["slow"].get("between_crossings"), other["slow"]) == (lasts, None)
