"""The event most like the paper's of independent runs: made-up events worked out by hand."""

import math

from pytest import raises

from conftest import approx
from most_like import candidates, choice, ratios_of, unlikeness

C_S, L = 900.0, 0.14


def event(t_start=0.3, kind="slow", **changed):
    """The paper's own numbers where nothing else is said."""
    slow = {"x_from": 0.4 * L, "x_to": 0.6 * L, "duration": 1e-3, "fast_before": C_S / 3}
    slow |= {"slowest": C_S / 100, "speed": 12.0, "mean": 15.0, "fast_after": 400.0} | changed
    return {"t_start": t_start, "type": kind, "slow": slow, "c_s": C_S, "L": L}


FAST_EVENT = event(kind="fast") | {"slow": None}


class TestMostLike:
    def test_the_papers_own_numbers_are_one(self):
        for name, ratio in ratios_of(event()).items():
            assert ratio == approx(1), name
        assert unlikeness(ratios_of(event())) == approx(0)

    def test_each_of_the_five_counts_by_its_logarithm(self):
        for changed in (
            *({"fast_before": C_S / 6}, {"slowest": C_S / 50}, {"duration": 2e-3}),
            *({"x_from": 0.2 * L}, {"x_to": 1.2 * L}),
        ):
            assert unlikeness(ratios_of(event(**changed))) == approx(math.log(2) ** 2)

    def test_an_event_that_lacks_one_is_no_candidate(self):
        for name in ("fast_before", "slowest", "x_from", "x_to", "duration", "fast_after"):
            assert ratios_of(event(**{name: None})) is None, name
        assert ratios_of(FAST_EVENT) is None
        assert ratios_of(event(kind="arrested")) is None
        assert ratios_of(event(duration=0.0)) is None

    def test_half_the_duration_is_nearer_than_three_times(self):
        loads = {
            "load-01": [FAST_EVENT, event(0.1, duration=3e-3)],
            "load-02": [event(0.2, slowest=C_S / 25), event(0.3123456, duration=0.5e-3)],
        }
        rows = [row for _, row in candidates(loads)]
        assert [row["t_start [s]"] for row in rows] == [0.3123456, 0.1, 0.2]
        chosen = {load: choice(load, loads)["chosen"] for load in loads}
        assert chosen == {"load-01": [], "load-02": loads["load-02"][1:]}
        assert choice("load-01", loads)["candidates"] == rows

    def test_no_candidate_is_an_error_that_says_so(self):
        with raises(SystemExit, match="load for longer"):
            choice("load-01", {"load-01": [FAST_EVENT]})
