"""Alternation of events in loads: made-up sequences with known answers."""

from unittest import mock

import numpy as np

from conftest import approx
from ensemble import precursors
from ensemble.alternation import FROM, SLOW, alternates, own_result, shuffled


def kinds(text):
    """s: fast-slow-fast, -: another."""
    return np.array([letter == "s" for letter in text])


class TestAlternation:
    def test_a_load_alternates_if_each_event_is_of_another_kind(self):
        for text, expected in (("-s-", True), ("s-s", True), ("s-ss-", False), ("s", False)):
            assert alternates(kinds(text)) == expected, text

    def test_events_of_one_age_are_shuffled_among_the_loads_that_have_them(self):
        loads = [kinds("s-s"), kinds("-s"), kinds("--s")]
        random = np.random.default_rng(1)
        seen = {
            "".join("-s"[int(k)] for load in shuffled(loads, random) for k in load)
            for _ in range(99)
        }
        assert len(seen) == 9  # one s among the three first events, one among the second ones
        assert all(len(text) == 8 and text[2] == text[7] == "s" for text in seen)

    @staticmethod
    def measured(*texts, since=FROM):
        """In fewer shuffles."""

        def load(text):
            return [(SLOW if kind == "s" else "other", {"t_start": since}) for kind in text]

        with mock.patch("ensemble.alternation.SHUFFLES", 500):
            return own_result({f"load-{n}": load(text) for n, text in enumerate(texts)}).measured

    def test_alternation_of_all_loads_at_once_is_no_more_than_their_age(self):
        p = "p of so many, or more, by chance"
        assert self.measured(*["s-s-s-s-"] * 5)[p] == 1.0
        half = ["s-s-s-s-", "-s-s-s-s"] * 4
        assert self.measured(*half)[p] < 0.005
        assert self.measured(*half)["loads that alternate"] == 8
        assert self.measured(*half)["loads that alternate by chance"] < 1
        assert self.measured(*["ssss----", "----ssss"] * 4)[p] > 0.99
        early = self.measured("s-s", "ss", since=FROM - 1e-3)
        assert early["pairs of successive spanning events"] == 0

    def test_shares_go_by_the_event_before(self):
        measured = self.measured("s-s-ss")
        assert measured["share after a fast-slow-fast event"] == approx(1 / 3)
        assert measured["share after another event"] == 1.0


class TestPrecursors:
    @staticmethod
    def events(*places):
        """The events of a run in which each precursor that arrests at x_p is followed by an event
        that is fast-slow-fast, from x_p - 0.1 L to x_p + 0.05 L, if x_p is below 0.6 L."""
        found = []
        for x_p in places:
            found.append({"spanning": False, "x_last": 0.14 * x_p, "L": 0.14})
            stretch = {"x_from": 0.14 * (x_p - 0.1), "x_to": 0.14 * (x_p + 0.05)}
            spans = {"spanning": True, "x_last": 0.14, "L": 0.14, "in_words": stretch}
            found.append(spans | {"fast_slow_fast": x_p < 0.6})
        return found

    def test_the_slow_stretch_is_compared_with_where_the_event_before_it_arrested(self):
        found = precursors.own_result([self.events(0.3, 0.5, 0.8), self.events(0.4, 0.7)])
        assert [*found.measured.values()] == approx([1, -0.1, 0.75, 0, 5, 3, 1, 0.05])
        assert not found.met  # a share of 0.75 where 0.8 is expected

    def test_events_that_follow_one_that_spans_do_not_count(self):
        first, second = self.events(0.3)
        assert precursors.pairs_of([[second, second, first, second]]) == [(approx(0.3), second)]
        assert precursors.own_result([[second]]).measured["correlation of end and x_p"] is None
