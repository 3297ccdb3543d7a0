"""The judge of claims: conditions, shares and the four verdicts, and the table of claims itself."""

import sys
import unittest
from pathlib import Path
from unittest import mock

SOURCE = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "recipes/common"))
from claims import judge  # noqa: E402
from claims.claim import VERDICTS  # noqa: E402
from claims.judge import PRIMARY, holds, interval, judged, parse, table, unmet  # noqa: E402

ROW = {"recipe": "fig0", "says": "something", "accepted": "if it is", "unit": "load"}
MADE_UP = {
    "all": ROW | {"conditions": ["1/4 <= x/L <= 0.5", "type is fast"]},
    "one": ROW | {"conditions": ["x > 2"], "exists": True},
    "alone": ROW | {"unit": "", "conditions": ["x < 1"]},
    "unstated": ROW | {"unit": "", "conditions": []},
}
GOOD, BAD = {"x": 3}, {"x": 1}


def units(good, bad, **others):
    measured = {f"{n}": {PRIMARY: [BAD, GOOD]} for n in range(good)}
    measured |= {f"{good + n}": {PRIMARY: [BAD]} for n in range(bad)}
    for name, count in others.items():
        for n, of_unit in enumerate(measured.values()):
            of_unit[name] = [GOOD if n < count else BAD]
    return measured


@mock.patch.object(judge, "table", lambda: MADE_UP)
class Judge(unittest.TestCase):
    def test_bounds_belong_to_the_range_and_all_conditions_count(self):
        for x, kind, expected in (
            *((0.25, "fast", True), (0.5, "fast", True), (0.2499, "fast", False)),
            *((0.5001, "fast", False), (0.3, "slow", False), (None, "fast", False)),
        ):
            self.assertEqual(holds("all", [{"x/L": x, "type": kind}]), expected, (x, kind))

    def test_names_what_is_not_met(self):
        self.assertEqual(unmet("all", {"x/L": 0.7, "type": "slow"}), ["x/L", "type"])

    def test_a_quantity_nobody_measured_is_an_error(self):
        with self.assertRaises(KeyError):
            holds("alone", [{"y": 1}])

    def test_one_case_of_a_unit_is_enough(self):
        self.assertTrue(holds("one", [BAD, GOOD]))
        self.assertFalse(holds("one", [BAD]))
        self.assertFalse(holds("one", []))

    def test_without_units_the_shown_case_decides_and_says_so(self):
        self.assertEqual(judged("alone", {}, {"x": 0}).verdict, "reproduced")
        self.assertEqual(judged("alone", {}, {"x": 2}).verdict, "differs")
        self.assertEqual(judged("one", {}, GOOD).reason, "shown case only: holds")
        self.assertEqual(judged("one", {}, None).verdict, "not comparable")

    def test_without_conditions_there_is_nothing_to_compare_with(self):
        claim = judged("unstated", {"x": 3}, None)
        self.assertEqual(claim.verdict, "not comparable")
        self.assertIn("states nothing", claim.reason)

    def test_verdicts_go_by_the_shown_case_and_the_shares(self):
        for shown, measured, verdict in (
            (GOOD, units(10, 10), "reproduced"),  # one exists: half of the units
            (GOOD, units(9, 11), "depends"),
            (BAD, units(20, 0), "depends"),
            (BAD, units(4, 16), "differs"),
            (BAD, units(5, 15), "depends"),
            (GOOD, units(20, 0, other=9), "depends"),
            (GOOD, units(20, 0, other=10), "reproduced"),
            (BAD, units(0, 20, other=5), "depends"),
        ):
            claim = judged("one", {}, shown, measured)
            self.assertEqual(claim.verdict, verdict, claim.reason)

    def test_a_unit_without_a_convention_counts_against_it(self):
        measured = units(20, 0)
        for number in range(9):
            measured[f"{number}"]["other"] = [GOOD]
        claim = judged("one", {}, GOOD, measured)
        self.assertEqual((claim.shares[1].holds, claim.shares[1].units), (9, 20))
        self.assertEqual(claim.verdict, "depends")

    def test_one_state_is_judged_under_each_convention(self):
        low, high = {"x": 0}, {"x": 2}
        for shown, other, verdict in (
            (low, low, "reproduced"),
            (high, high, "differs"),
            (low, high, "depends"),
            (high, low, "depends"),
            (None, low, "not comparable"),
        ):
            claim = judged("alone", {}, shown, others={"other": other})
            self.assertEqual(claim.verdict, verdict, claim.reason)
            self.assertEqual(claim.shares, [])
        claim = judged("alone", {}, low, others={"other": high})
        self.assertEqual(
            claim.reason, "on the convention: holds under primary; does not under other"
        )

    def test_names_the_convention_that_decides(self):
        claim = judged("one", {}, GOOD, units(20, 0, other=3))
        self.assertEqual(claim.reason, "holds as shown; in 3 of 20 loads (other)")
        self.assertEqual([share.convention for share in claim.shares], [PRIMARY, "other"])

    def test_interval(self):
        self.assertEqual(interval(0, 20)[0], 0)
        self.assertEqual(interval(20, 20)[1], 1)
        low, high = interval(10, 20)
        self.assertAlmostEqual(low + high, 1)
        self.assertAlmostEqual(low, 0.324, places=3)

    def test_refuses_what_is_no_condition(self):
        for text in ("x", "x = 3", "<= 3"):
            with self.assertRaises(ValueError):
                parse(text)


class Table(unittest.TestCase):
    def test_every_row_is_complete(self):
        for claim_id, row in table().items():
            with self.subTest(claim_id):
                self.assertLessEqual({"recipe", "says", "unit", "accepted", "conditions"}, set(row))
                self.assertTrue((SOURCE / f"recipes/{row['recipe']}/rules.smk").exists())
                for text in row["conditions"]:
                    parse(text)

    def test_verdicts_are_four(self):
        self.assertEqual(len(VERDICTS), 4)


if __name__ == "__main__":
    unittest.main()
