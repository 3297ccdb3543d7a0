"""Alternation of events in loads: made-up sequences with known answers."""

import sys
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
sys.path[:0] = [
    str(SOURCE / "python"),
    str(SOURCE / "recipes/common"),
    str(SOURCE / "recipes/ensemble"),
]
import numpy as np  # noqa: E402

from alternation import SLOW, alternates, changes, own_result, p_of_changes  # noqa: E402


def kinds(text):
    """s: fast-slow-fast, -: another."""
    return np.array([letter == "s" for letter in text])


class Alternation(unittest.TestCase):
    def test_counts_changes(self):
        self.assertEqual([changes(kinds(t)) for t in ("s", "ss", "s-s-", "ss--")], [0, 0, 3, 1])

    def test_goes_by_the_third_event_on(self):
        for text, expected in (("ss-s-", True), ("s-s-s", True), ("s-ss-", False), ("s-s", False)):
            self.assertEqual(alternates(kinds(text)), expected, text)

    def test_regular_loads_are_unlikely_and_clustered_ones_are_not(self):
        self.assertLess(p_of_changes([kinds("s-s-s-s-")] * 5), 0.001)
        self.assertGreater(p_of_changes([kinds("ssss----")] * 5), 0.99)

    def test_shares_go_by_the_event_before(self):
        load: list = [(SLOW if letter == "s" else "other", {}) for letter in "s-s-ss"]
        measured = own_result({"load-01": load}).measured
        self.assertAlmostEqual(measured["share after a fast-slow-fast event"], 1 / 3)
        self.assertEqual(measured["share after another event"], 1.0)


if __name__ == "__main__":
    unittest.main()
