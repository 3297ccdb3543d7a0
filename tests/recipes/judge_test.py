"""The judge of claims: conditions, shares and the four verdicts, and the table of claims itself."""

from math import isfinite
from unittest import mock

from pytest import mark, raises

from claims import cases, judge
from claims.conditions import RELATIONS, as_number, met
from claims.judge import PRIMARY, holds, interval, interval_of, judged, table, unmet, unmet_text
from conftest import ROOT, approx
from made_up import Made
from rupture.errors import Failure

ROW: dict = {"recipe": "fig0", "says": "something", "accepted": "if it is", "kind": "finding"}
ROW |= {"fixed": "today", "shown": "shown", "measured": {"x": "x"}}
OTHER: dict = {"under": {"other": {"with": {"x": "other"}}}}
OF_UNITS: dict = {"unit": "run", "each": "case in units: of.cases", "ways": True}
OF_UNITS["with"] = {"x": "case.x"}
OF_UNITS |= {"in_picture": {"x": "x_shown"}, "among": {"spanning events": "case.spans"}}
OF_UNITS |= {"counts": {"with more": "x > 2", "that it holds for": "holds"}}
OF_EACH: dict = {"each": "units", "with": {"x": "of.x"}, "in_picture": {"x": "x_shown"}}
ROWS: dict[str, dict] = {
    "all": {"conditions": {"x/L": {"at_least": "1/4", "at_most": 0.5}, "type": "fast"}},
    "one": {"conditions": {"x": {"above": 2}}} | OF_UNITS,
    "alone": {"conditions": {"x": {"below": 1}}},
    "two": {"conditions": {"x": {"below": 1}}, "with": {"x": "first"}} | OTHER,
    "any": {"conditions": {"x": {"below": 1}}, "if": "x is not None", "ways": True} | OF_EACH,
    "state": {"conditions": {"x": {"below": 1}}, "unit": "seed", "ways": True} | OF_EACH,
    "events": {"conditions": {"x": {"below": 1}}, "unit": "event", "if": "known"} | OF_EACH,
    "unstated": {"conditions": {}},
}
MADE_UP = {name: ROW | row | {"id": name} for name, row in ROWS.items()}
GOOD, BAD = 3, 1
LOW, HIGH = 0, 2


def run(*xs, **others):
    """A unit with cases of these x; under other ways to measure it has others."""
    listed = {way: {"cases": [{"x": x, "spans": True} for x in of]} for way, of in others.items()}
    return Made(of={"cases": [{"x": x, "spans": True} for x in xs], "under": listed})


def runs(good, bad, **others):
    """So many units for which it holds, and does not; of all, so many under other ways."""
    found = [run(BAD, GOOD) for _ in range(good)] + [run(BAD) for _ in range(bad)]
    for way, count in others.items():
        for n, unit in enumerate(found):
            unit["of"]["under"] |= run(GOOD, **{way: [GOOD if n < count else BAD]})["of"]["under"]
    return found


def seed(x, **others):
    return Made(of={"x": x, "under": {way: {"x": of} for way, of in others.items()}}, known=True)


FEW = "(primary); too few runs for a verdict"
NOT_SHOWN = FEW.replace(";", ", but not in the case shown;")
OVER_UNITS = [  # the shown case, units, the verdict, and how the reason ends
    (GOOD, runs(20, 0), "reproduced", "holds in at least 20 of 20 runs (primary)"),
    (GOOD, runs(14, 6), "reproduced", "14 of 20 runs (primary)"),  # one exists: above a half
    (GOOD, runs(13, 7), "depends", f"holds in 13 of 20 runs {FEW}"),
    (GOOD, runs(9, 11), "depends", "9 of 20 runs (primary)"),
    (BAD, runs(20, 0), "depends", "holds in 20 of 20 runs (primary), but not in the case shown"),
    (BAD, runs(1, 19), "differs", "holds in at most 1 of 20 runs (primary)"),
    (BAD, runs(2, 18), "depends", f"2 of 20 runs {NOT_SHOWN}"),
    (BAD, runs(4, 16), "depends", f"4 of 20 runs {NOT_SHOWN}"),
    (BAD, runs(5, 15), "depends", "5 of 20 runs (primary), but not in the case shown"),
    (GOOD, runs(10, 10), "depends", f"10 of 20 runs {FEW}"),
    (GOOD, runs(20, 0, other=3), "depends", "runs (primary), down to 3 of 20 runs (other)"),
    (GOOD, runs(20, 0, other=13), "depends", "(other); too few runs for a verdict"),
    (GOOD, runs(20, 0, other=14), "reproduced", "14 of 20 runs (other)"),
    (
        BAD,
        runs(0, 20, other=2),
        "depends",
        f"up to 2 of 20 runs {NOT_SHOWN}".replace(PRIMARY, "other"),
    ),
]


def seeds(held, other):
    """Five or more runs: it holds for `held` of them, and for `other` by the other way to
    measure."""
    return [
        seed(LOW if n < held else HIGH, other=LOW if n < other else HIGH)
        for n in range(max(held, 5))
    ]


JUDGED = [  # a claim, its shown case, its units, the verdict, and how the reason ends
    ("alone", LOW, [], "reproduced", "holds"),
    ("alone", HIGH, [], "differs", "does not hold"),
    ("one", GOOD, [], None, "only the case shown was judged, no other runs"),
    ("one", GOOD, runs(4, 0), None, "only the case shown was judged, no other runs"),
    ("unstated", None, [], "not comparable", "gives no number to compare with; ours are reported"),
    *(("one", shown, found, *said) for shown, found, *said in OVER_UNITS),
    ("state", LOW, seeds(3, 3), "reproduced", "holds in all of the 2 ways to measure"),
    ("state", LOW, seeds(3, 2), "depends", "of the 2 ways to measure, does not hold in other"),
    ("state", LOW, seeds(2, 0), "differs", "holds in none of the 2 ways to measure"),
    ("two", (LOW, LOW), [], "reproduced", "holds in all of the 2 ways to measure"),
    ("two", (HIGH, HIGH), [], "differs", "holds in none of the 2 ways to measure"),
    ("two", (LOW, HIGH), [], "depends", "of the 2 ways to measure, does not hold in other"),
    ("two", (HIGH, LOW), [], "depends", "of the 2 ways to measure, does not hold in primary"),
    ("events", LOW, seeds(19, 0) + seeds(0, 0)[:1], "reproduced", "19 of 20 events (primary)"),
    ("events", LOW, seeds(18, 0) + seeds(0, 0)[:2], "depends", "too few events for a verdict"),
    ("events", None, seeds(5, 0), "not comparable", "it could not be measured"),
    ("any", LOW, seeds(0, 1), "reproduced", "holds in all of the 2 ways to measure"),
    ("any", LOW, seeds(5, 0), "depends", "of the 2 ways to measure, does not hold in other"),
    ("any", None, seeds(1, 1), "not comparable", "it could not be measured"),
]


FAILED = Made()
FAILED.status = "failed"
OF_RUNS: dict = {"unit": "run", "ways": False}
BRANCHES: dict = {"under": {"further": {"each": "others"}, "less": {"with": {"x": "of.x - 2"}}}}
SHARES = [  # a claim, what is changed in it, its units, and for how many of how many it holds
    # A unit without a case counts against it, and so does a point that failed.
    ("one", {}, [run(GOOD, other=[]), run(GOOD, other=[GOOD])], {PRIMARY: (2, 2), "other": (1, 2)}),
    ("one", OF_RUNS, [*runs(5, 0), FAILED], {PRIMARY: (5, 6)}),
    ("state", OF_RUNS, [*seeds(5, 0), FAILED], {PRIMARY: (5, 6)}),
    # Where there is nothing to compare, there is no unit.
    ("any", {"unit": "run"}, [seed(LOW), seed(HIGH), seed(None)], {PRIMARY: (1, 2)}),
    # A branch is another convention.
    ("any", OF_RUNS | BRANCHES, [seed(HIGH)], {PRIMARY: (0, 1), "further": (1, 2), "less": (1, 1)}),
]


def shown_of(x):
    """The point in the picture; one that cannot be compared if there is no x."""
    if isinstance(x, tuple):
        return [Made(zip(("first", "other"), x))]
    return [Made(x=x, x_shown=x, of={"x": x}, known=x is not None)]


@mock.patch.object(judge, "table", lambda _: MADE_UP)
class TestJudge:
    def test_bounds_belong_to_the_range_and_all_conditions_count(self):
        for x, kind, expected in (
            *((0.25, "fast", True), (0.5, "fast", True), (0.2499, "fast", False)),
            *((0.5001, "fast", False), (0.3, "slow", False), (None, "fast", False)),
        ):
            assert holds("all", [{"x/L": x, "type": kind}]) == expected, (x, kind)

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
            with mock.patch.object(judge, "table", lambda _, row=row: row):
                assert unmet_text("row", {"v/c_s": value}) == text
        close = unmet_text("all", {"x/L": 0.50001, "type": "fast"})
        assert close == "x/L is 0.50001, not 1/4 to 0.5"
        assert unmet_text("one", {"x": 1.98765}) == "x is 1.99, not above 2"

    def test_a_quantity_nobody_measured_is_an_error(self):
        with raises(KeyError):
            holds("alone", [{"y": 1}])

    @mark.parametrize("claim_id, shown, units, verdict, reason", JUDGED)
    def test_a_verdict_and_its_reason(self, claim_id, shown, units, verdict, reason):
        claim = judged(claim_id, {"shown": shown_of(shown), "units": units})
        because, _, wanted = claim.reason.partition(" (x is ")
        because = because.partition("; 20 of")[0] if "spanning" in because else because
        because = because.rpartition("; ")[0] if because.endswith("spanning events") else because
        assert (claim.verdict, because[-len(reason) :]) == (verdict, reason)
        assert bool(wanted) == (claim.case == "does not hold")

    def test_one_state_has_a_share_without_interval(self):
        shares = judge.shares_of(MADE_UP["state"], {"units": seeds(3, 3)})
        assert [(s.units, s.low, s.high) for s in shares] == 2 * [(1, None, None)]

    @mark.parametrize("name, changed, units, expected", SHARES)
    def test_shares(self, name, changed, units, expected):
        chains = {"units": units, "others": [seed(LOW), seed(HIGH)]}
        shares = judge.shares_of(MADE_UP[name] | changed, chains)
        assert {s.convention: (s.holds, s.units) for s in shares} == expected

    def test_counts_spanning_events_where_one_is_enough(self):
        units = [run(GOOD, BAD, BAD) for _ in range(20)]
        units[0]["of"]["cases"][0]["spans"] = False
        found = judged("one", {"shown": shown_of(GOOD), "units": units})
        assert found.reason.endswith("; 19 of 59 spanning events")

    def test_counts_units_that_have_run(self):
        for units, counts in ((runs(3, 2), "3 of 5"), ([], "not run")):
            found = judged("one", {"shown": shown_of(GOOD), "units": units}).measured
            assert found == {"x": 3, "with more": counts, "that it holds for": counts}

    def test_several_cases_are_shown_and_the_first_decides(self):
        row = MADE_UP["alone"] | {"shown": {"II": "shown", "I": "units"}}
        with mock.patch.object(judge, "table", lambda _: {"alone": row}):
            found = judged("alone", {"shown": shown_of(LOW), "units": shown_of(HIGH)})
        assert (found.measured, found.case) == ({"II: x": LOW, "I: x": HIGH}, "holds")

    def test_a_name_that_does_not_exist_is_named_with_the_claim(self):
        row = MADE_UP["alone"] | {"measured": {"x": "y"}}
        with raises(Failure, match="claims.toml, claim alone: 'y': there is no y"):
            cases.Names(row, Made(x=1)).case()
        with raises(Failure, match="a row of claims.toml needs 'shown'"):
            judge.judge("fig0", {})

    def test_interval(self):
        assert interval(0, 20)[0] == 0
        assert interval(20, 20)[1] == 1
        low, high = interval(10, 20)
        assert low + high == approx(1)
        assert low == approx(0.324, abs=5e-4)

    def test_interval_of_events_of_which_runs_are_drawn(self):
        """If all five events of a run hold or none does, a share of 20 runs is binomial: 6 and 14
        of 20 are its quantiles. If half of each run holds, it is that of independent events."""
        assert interval_of([5 * [run < 10] for run in range(20)]) == approx((0.3, 0.7))
        assert interval_of(10 * [5 * [False, True]]) == interval(50, 100)
        assert interval_of([[n < 5] for n in range(10)]) == interval(5, 10)

    def test_refuses_what_is_no_condition(self):
        for condition in ({"equals": 3}, {"at_most": "a lot"}):
            with raises((KeyError, ValueError)):
                met(condition, 1)


class TestTable:
    def test_no_claim_belongs_to_two_recipes(self):
        assert sum(map(len, judge.read("")[1].values())) == len(table())

    def test_every_row_is_complete(self):
        for row in table().values():
            assert {"recipe", "says", "fixed", "accepted"} <= set(row)
            assert row["kind"] in ("finding", "check")
            assert "conditions" in row and "shown" in row and "measured" in row
            assert (ROOT / f"recipes/{row['recipe']}/figure.py").exists()
            for condition in row["conditions"].values():
                if isinstance(condition, dict):
                    assert condition and set(condition) <= set(RELATIONS)
                    assert all(isfinite(as_number(bound)) for bound in condition.values())
