"""Kinds of events, and which of a load are shown (recipes/measure)."""

from choose_shown import choose
from conftest import approx
from measure.conventions import CONVENTIONS, PRIMARY
from measure.event_numbers import numbers_of_events


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


class TestConventions:
    def test_each_differs_from_the_primary_one_in_one_way(self):
        assert CONVENTIONS[PRIMARY] == {}
        others = [options for name, options in CONVENTIONS.items() if name != PRIMARY]
        assert {len(options) for options in others} == {1}


def made_up(fast, slowest, x_from=0.05, duration=1e-3, in_words=True):
    """An event that spans; c_s is 1000 m/s, L is 0.1 m, and a block ruptures every millisecond."""
    slow = dict(fast_before=fast, slowest=slowest, mean=9.0, x_from=x_from, x_to=0.06)
    return {
        "type": "slow" if in_words else "fast",
        "spanning": True,
        "fast_slow_fast": in_words,
        "speed": 10.0,
        "c_s": 1000.0,
        "L": 0.1,
        "slow": slow | {"duration": duration},
        "t_rupture": [k * 1e-3 for k in range(11)],
        "t_front": [k * 1e-3 for k in range(11)],
    }


class TestNumbers:
    def test_an_event_that_creeps_is_not_in_the_set(self):
        """0.4 counted one of 26 ms at 1.27 m/s, which had never been fast."""
        shown, creeping = made_up(300.0, 20.0), made_up(1.3, 1.27, duration=26e-3, in_words=False)
        events = [shown, made_up(100.0, 10.0), made_up(200.0, 10.0), creeping]
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
        shown = made_up(300.0, 20.0)
        first, *_ = numbers_of_events(shown, shown, None, [])
        assert (first.median, first.most_like, first.ratio) == (None, None, approx(0.9))
