"""The judge of claims: conditions, shares and the four verdicts, and the table of claims itself."""

import tomllib
from math import isfinite
from unittest import mock

from pytest import mark, raises

from claims import judge
from claims.conditions import RELATIONS, as_number, met
from claims.judge import PRIMARY, conditions_of, holds, interval, judged, table, unmet, unmet_text
from conftest import ROOT, approx

ROW = {
    "recipe": "fig0",
    "says": "something",
    "accepted": "if it is",
    "unit": "run",
    "kind": "finding",
    "fixed": "today",
}
MADE_UP = {
    "all": ROW | {"conditions": {"x/L": {"at_least": "1/4", "at_most": 0.5}, "type": "fast"}},
    "same": ROW | {"like": "all"},
    "like": ROW | {"like": "all", "conditions": {"type": "slow"}},
    "one": ROW | {"conditions": {"x": {"above": 2}}, "exists": True},
    "alone": ROW | {"unit": "", "conditions": {"x": {"below": 1}}},
    "state": ROW | {"unit": "seed", "conditions": {"x": {"below": 1}}},
    "unstated": ROW | {"unit": "", "conditions": {}},
}
GOOD, BAD = {"x": 3}, {"x": 1}
LOW, HIGH = {"x": 0}, {"x": 2}


def is_finite(bound):
    return isfinite(as_number(bound))


def units(good, bad, **others):
    measured = {f"{n}": {PRIMARY: [BAD, GOOD]} for n in range(good)}
    measured |= {f"{good + n}": {PRIMARY: [BAD]} for n in range(bad)}
    for name, count in others.items():
        for n, of_unit in enumerate(measured.values()):
            of_unit[name] = [GOOD if n < count else BAD]
    return measured


def seeds(held, other):
    return {
        f"{n}": {PRIMARY: [LOW if n < held else HIGH], "other": [LOW if n < other else HIGH]}
        for n in range(5)
    }


FEW = "(primary); too few runs for a verdict"
NOT_SHOWN = FEW.replace(";", ", but not in the case shown;")
OVER_UNITS = [  # the shown case, units, the verdict, and how the reason ends
    (GOOD, units(20, 0), "reproduced", "holds in at least 20 of 20 runs (primary)"),
    (GOOD, units(14, 6), "reproduced", "14 of 20 runs (primary)"),  # one exists: above a half
    (GOOD, units(13, 7), "depends", f"holds in 13 of 20 runs {FEW}"),
    (GOOD, units(9, 11), "depends", "9 of 20 runs (primary)"),
    (BAD, units(20, 0), "depends", "holds in 20 of 20 runs (primary), but not in the case shown"),
    (BAD, units(1, 19), "differs", "holds in at most 1 of 20 runs (primary)"),
    (BAD, units(2, 18), "depends", f"2 of 20 runs {NOT_SHOWN}"),
    (BAD, units(4, 16), "depends", f"4 of 20 runs {NOT_SHOWN}"),
    (BAD, units(5, 15), "depends", "5 of 20 runs (primary), but not in the case shown"),
    (GOOD, units(10, 10), "depends", f"10 of 20 runs {FEW}"),
    (GOOD, units(20, 0, other=3), "depends", "runs (primary), down to 3 of 20 runs (other)"),
    (GOOD, units(20, 0, other=13), "depends", "(other); too few runs for a verdict"),
    (GOOD, units(20, 0, other=14), "reproduced", "14 of 20 runs (other)"),
    (
        BAD,
        units(0, 20, other=2),
        "depends",
        f"up to 2 of 20 runs {NOT_SHOWN}".replace(PRIMARY, "other"),
    ),
]
OTHER_LOW, OTHER_HIGH = ({"others": {"other": found}} for found in (LOW, HIGH))
JUDGED = [  # a claim, the shown case, what was measured beside it, and the same
    ("alone", LOW, {}, "reproduced", "holds"),
    ("alone", HIGH, {}, "differs", "does not hold"),
    ("one", GOOD, {}, None, "only the case shown was judged, no other runs"),
    ("one", None, {}, "not comparable", "it could not be measured"),
    ("unstated", None, {}, "not comparable", "gives no number to compare with; ours are reported"),
    *(("one", shown, {"units": found}, *said) for shown, found, *said in OVER_UNITS),
    ("state", LOW, {"units": seeds(3, 3)}, "reproduced", "holds in all of the 2 ways to measure"),
    (
        "state",
        LOW,
        {"units": seeds(3, 2)},
        "depends",
        "of the 2 ways to measure, does not hold in other",
    ),
    ("state", LOW, {"units": seeds(2, 0)}, "differs", "holds in none of the 2 ways to measure"),
    ("alone", LOW, OTHER_LOW, "reproduced", "holds in all of the 2 ways to measure"),
    ("alone", HIGH, OTHER_HIGH, "differs", "holds in none of the 2 ways to measure"),
    ("alone", LOW, OTHER_HIGH, "depends", "of the 2 ways to measure, does not hold in other"),
    ("alone", HIGH, OTHER_LOW, "depends", "of the 2 ways to measure, does not hold in primary"),
    ("alone", None, OTHER_LOW, "not comparable", "could not be measured"),
]


@mock.patch.object(judge, "table", lambda: MADE_UP)
class TestJudge:
    def test_bounds_belong_to_the_range_and_all_conditions_count(self):
        for x, kind, expected in (
            *((0.25, "fast", True), (0.5, "fast", True), (0.2499, "fast", False)),
            *((0.5001, "fast", False), (0.3, "slow", False), (None, "fast", False)),
        ):
            for name in ("all", "same"):
                assert holds(name, [{"x/L": x, "type": kind}]) == expected, (x, kind)
        assert unmet("like", {"x/L": 0.7, "type": "slow"}) == ["x/L"]

    def test_names_what_is_not_met(self):
        assert unmet("all", {"x/L": 0.7, "type": "slow"}) == ["x/L", "type"]

    def test_says_what_was_wanted_and_what_there_is(self):
        between = {"at_least": "1/200", "at_most": "1/50"}
        for condition, value, text in (
            (between, 1 / 49.6, "v is c_s/49.6, not c_s/200 to c_s/50"),
            ({"below": 0.5}, None, "v is none, not below c_s/2"),
            ({"above": 2}, 1.25, "v is 1.25 c_s, not above 2 c_s"),
            ("fast", "slow", "v is slow, not fast"),
        ):
            row = {"row": {"conditions": {"v/c_s": condition}}}
            with mock.patch.object(judge, "table", lambda row=row: row):
                assert unmet_text("row", {"v/c_s": value}) == text
        close = unmet_text("all", {"x/L": 0.50001, "type": "fast"})
        assert close == "x/L is 0.50001, not 1/4 to 0.5"
        assert unmet_text("one", {"x": 1.98765}) == "x is 1.99, not above 2"

    def test_a_quantity_nobody_measured_is_an_error(self):
        with raises(KeyError):
            holds("alone", [{"y": 1}])

    @mark.parametrize("claim_id, shown, beside, verdict, reason", JUDGED)
    def test_a_verdict_and_its_reason(self, claim_id, shown, beside, verdict, reason):
        claim = judged(claim_id, {}, shown, **beside)
        because, _, wanted = claim.reason.partition(" (x is ")
        assert (claim.verdict, because[-len(reason) :]) == (verdict, reason)
        assert bool(wanted) == (claim.case == "does not hold")
        assert bool(claim.shares) == ("units" in beside)

    def test_one_state_has_a_share_without_interval(self):
        shares = judged("state", {}, LOW, seeds(3, 3)).shares
        assert [(s.units, s.low, s.high) for s in shares] == 2 * [(1, None, None)]

    def test_a_unit_counts_under_its_conventions_only(self):
        measured = units(20, 0)
        for number in range(9):
            measured[f"{number}"]["other"] = [GOOD] if number else []
        claim = judged("one", {}, GOOD, measured)
        _, other = claim.shares
        assert (other.convention, other.holds, other.units) == ("other", 8, 9)

    def test_counts_spanning_events_where_one_is_enough(self):
        good, bad = GOOD | {"spans": "yes"}, BAD | {"spans": "yes"}
        runs = {f"{n}": {PRIMARY: [good, bad, bad, BAD | {"spans": "no"}]} for n in range(20)}
        assert judged("one", {}, GOOD, runs).reason.endswith("; 20 of 60 spanning events")

    def test_counts_units_that_have_run(self):
        assert judge.units_with(lambda case: case["x"] > 2, units(3, 2)) == "3 of 5"
        assert judge.units_with(lambda case: case["x"] > 2, {}) == "not run"

    def test_interval(self):
        assert interval(0, 20)[0] == 0
        assert interval(20, 20)[1] == 1
        low, high = interval(10, 20)
        assert low + high == approx(1)
        assert low == approx(0.324, abs=5e-4)

    def test_refuses_what_is_no_condition(self):
        for condition in ({"equals": 3}, {"at_most": "a lot"}):
            with raises((KeyError, ValueError)):
                met(condition, 1)


class TestTable:
    def test_no_claim_belongs_to_two_recipes(self):
        recipes = tomllib.loads(judge.TABLE.read_text(encoding="utf-8"))
        assert sum(map(len, recipes.values())) == len(table())

    def test_every_row_is_complete(self):
        for claim_id, row in table().items():
            assert {"recipe", "says", "fixed", "accepted"} <= set(row)
            assert row["kind"] in ("finding", "check")
            assert {"conditions", "like"} & set(row)
            assert (ROOT / f"recipes/{row['recipe']}/figure.py").exists()
            for condition in conditions_of(claim_id).values():
                if isinstance(condition, dict):
                    assert condition and set(condition) <= set(RELATIONS)
                    assert all(map(is_finite, condition.values()))
