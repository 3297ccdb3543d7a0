#!/usr/bin/env python3
"""Kinds of events, and which of a load are shown (recipes/events)."""

import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "recipes"))

from events.choose_events import choose  # noqa: E402
from events.conventions import CONVENTIONS, PRIMARY  # noqa: E402
from events.fronts import is_fast_slow_fast_in_words  # noqa: E402
from events.product import combinations, range_of  # noqa: E402


def event(t_start=0.0, *, stencils=3, before=200.0, after=200.0, kind="slow"):
    slow = {"stencils": stencils, "fast_before": before, "fast_after": after}
    return {
        "t_start": t_start,
        "type": kind,
        "slow": slow if kind != "fast" else None,
        "c_s": 1000.0,
    }


class InWords(unittest.TestCase):
    def test_three_slow_stencils_between_fast_ones(self):
        self.assertTrue(is_fast_slow_fast_in_words(event()))
        self.assertFalse(is_fast_slow_fast_in_words(event(stencils=2)))

    def test_fast_is_a_tenth_of_the_wave_speed(self):
        self.assertTrue(is_fast_slow_fast_in_words(event(before=100.0, after=100.0)))
        self.assertFalse(is_fast_slow_fast_in_words(event(before=99.0)))
        self.assertFalse(is_fast_slow_fast_in_words(event(after=99.0)))

    def test_without_speeds_on_a_side_it_is_none(self):
        self.assertFalse(is_fast_slow_fast_in_words(event(before=None)))
        self.assertFalse(is_fast_slow_fast_in_words(event(after=None)))

    def test_what_arrests_or_has_no_slow_stretch_is_none(self):
        self.assertFalse(is_fast_slow_fast_in_words(event() | {"slow": None}))
        self.assertFalse(is_fast_slow_fast_in_words(event(kind="arrested")))
        self.assertFalse(is_fast_slow_fast_in_words(event(kind="fast")))


class Choice(unittest.TestCase):
    def test_the_fast_event_comes_after_the_first_slow_one(self):
        events = [
            event(0.1, kind="fast"),
            event(0.2),
            event(0.3, kind="fast"),
            event(0.4, stencils=1),
            event(0.5),
        ]
        chosen = {name: found["t_start"] for name, found in choose(events, events).items()}
        self.assertEqual(chosen, {"fast-slow-fast": 0.2, "fast-only": 0.3, "second-slow": 0.5})

    def test_a_load_with_one_slow_event_has_no_second(self):
        chosen = choose([event(0.1)], [event(0.1)])
        self.assertIsNone(chosen["second-slow"])
        self.assertIsNone(chosen["fast-only"])


class Conventions(unittest.TestCase):
    def test_each_differs_from_the_primary_one_in_one_way(self):
        self.assertEqual(CONVENTIONS[PRIMARY], {})
        others = [options for name, options in CONVENTIONS.items() if name != PRIMARY]
        self.assertEqual({len(options) for options in others}, {1})


class FullProduct(unittest.TestCase):
    def test_each_way_to_measure_is_combined_with_each_other(self):
        found = combinations()
        self.assertEqual(len(found), 3 * 3 * 4 * 3)  # stencil, pinned fraction, slow below, ends
        self.assertEqual(found[PRIMARY], {})
        both = found["stencil 3, 20 % pinned"]
        self.assertEqual(both, {"--stencil": 3, "--ruptured-below": 0.2})

    def test_conventions_one_at_a_time_are_among_the_combinations(self):
        found = combinations()
        self.assertEqual({name: found[name] for name in CONVENTIONS}, CONVENTIONS)

    def test_the_range_goes_over_combinations_not_over_loads(self):
        loads = [
            {"a": {"2A": True}, "b": {"2A": False}},
            {"a": {"2A": True}, "b": {"2A": True}},
            {"a": {"2A": False}, "b": {"2A": False}},
        ]
        self.assertEqual(range_of(loads, "2A"), (1, 2))


if __name__ == "__main__":
    unittest.main()
