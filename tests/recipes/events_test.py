"""Kinds of events, which of a load are shown, and which of independent runs is most like the
paper's; made-up events worked out by hand."""

import math

from pytest import raises
from rupture.errors import Failure

from conftest import approx
from event_numbers import numbers_of_events
from fig2.from_scratch import choose
from fig2.most_like import candidates, ratios_of, unlikeness
from measure.ways import WAYS, PRIMARY

C_S, L = 1000.0, 0.1


def event(t_start=0.3, kind="slow", **changed):
    """It spans with the paper's own numbers where nothing else is said, and a block ruptures every
    millisecond."""
    slow = {"x_from": 0.4 * L, "x_to": 0.6 * L, "duration": 1e-3, "fast_before": C_S / 3}
    slow |= {"slowest": C_S / 100, "mean": 9.0, "fast_after": 400.0} | changed
    ruptures = [k * 1e-3 for k in range(11)]
    found = {"t_start": t_start, "type": kind, "fast_slow_fast": kind == "slow", "slow": slow}
    found |= {"spanning": True, "speed": 10.0, "t_rupture": ruptures, "t_front": ruptures}
    return found | {"c_s": C_S, "L": L}


FAST_EVENT = event(kind="fast") | {"slow": None}


class TestChoice:
    def test_the_fast_event_comes_after_the_first_slow_one(self):
        events = [event(0.1, "fast"), event(0.2), event(0.3, "fast"), event(0.4), event(0.5)]
        events[3]["fast_slow_fast"] = False
        chosen = {name: found["t_start"] for name, found in choose(events).items()}
        assert chosen == {"fast-slow-fast": 0.2, "fast-only": 0.3, "second-slow": 0.5}

    def test_a_load_with_one_slow_event_has_no_second(self):
        with raises(Failure, match="no event fast-only and no second-slow: load for longer"):
            choose([event(0.1)])


class TestConventions:
    def test_each_differs_from_the_primary_one_in_one_way(self):
        assert WAYS[PRIMARY] == ""
        others = [options for name, options in WAYS.items() if name != PRIMARY]
        assert {options.count("--") for options in others} == {1}


class TestNumbers:
    def test_an_event_that_creeps_is_not_in_the_set(self):
        """0.4 counted one of 26 ms at 1.27 m/s, which had never been fast."""
        creeping = event(kind="fast", fast_before=1.3, slowest=1.27, duration=26e-3)
        shown = event(fast_before=300.0, slowest=20.0)
        events = [shown, event(fast_before=100.0), event(fast_before=200.0), creeping]
        found = {n.quantity: n for n in numbers_of_events(shown, creeping, events[1], events)}
        before = found["speed before the slow stretch [c_s]"]
        assert (before.shown, before.most_like, before.median) == approx((0.3, 0.1, 0.2))
        assert before.ratio == approx(0.6)
        assert before.of == "3 of 3 fast-slow-fast events"
        assert found["slowest speed [c_s]"].median == approx(0.01)
        assert found["duration of the slow stretch [ms]"].high == approx(1)
        assert found["mean speed of the slow stretch [c_s]"].paper == approx(0.02)
        assert found["time from 0.4 L to 0.6 L [ms]"].shown == approx(2)
        assert found["speed of events that are fast everywhere [c_s]"].median == approx(0.01)

    def test_without_independent_runs_there_is_no_median(self):
        shown = event(fast_before=300.0)
        first, *_ = numbers_of_events(shown, shown, None, [])
        assert (first.median, first.most_like, first.ratio) == (None, None, approx(0.9))


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
        runs = {
            401: [FAST_EVENT, event(0.1, duration=3e-3)],
            402: [event(0.2, slowest=C_S / 25), event(0.3123456, duration=0.5e-3)],
        }
        found = candidates(runs)
        assert found[0][:2] == (402, runs[402][1])
        assert [row["t_start [s]"] for *_, row in found] == [0.3123456, 0.1, 0.2]
        assert [row["load"] for *_, row in found] == ["load-402", "load-401", "load-402"]

    def test_no_candidate_is_an_error_that_says_so(self):
        with raises(Failure, match="load for longer"):
            candidates({401: [FAST_EVENT]})
