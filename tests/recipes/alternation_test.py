"""Alternation of events in loads: made-up sequences with known answers."""

from unittest import mock

import numpy as np

from alternation import FROM, SLOW, alternates, own_result, shuffled
from conftest import approx


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

        with mock.patch("alternation.SHUFFLES", 500):
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
