"""Alternation of events in loads: made-up sequences with known answers."""

import numpy as np

from alternation import SLOW, alternates, changes, own_result, p_of_changes
from conftest import approx


def kinds(text):
    """s: fast-slow-fast, -: another."""
    return np.array([letter == "s" for letter in text])


class TestAlternation:
    def test_counts_changes(self):
        assert [changes(kinds(t)) for t in ("s", "ss", "s-s-", "ss--")] == [0, 0, 3, 1]

    def test_goes_by_the_third_event_on(self):
        for text, expected in (("ss-s-", True), ("s-s-s", True), ("s-ss-", False), ("s-s", False)):
            assert alternates(kinds(text)) == expected, text

    def test_regular_loads_are_unlikely_and_clustered_ones_are_not(self):
        assert p_of_changes([kinds("s-s-s-s-")] * 5) < 0.001
        assert p_of_changes([kinds("ssss----")] * 5) > 0.99

    def test_shares_go_by_the_event_before(self):
        load: list = [(SLOW if letter == "s" else "other", {}) for letter in "s-s-ss"]
        measured = own_result({"load-01": load}).measured
        assert measured["share after a fast-slow-fast event"] == approx(1 / 3)
        assert measured["share after another event"] == 1.0
