"""The judge of claims: conditions, shares and the four verdicts, and the table of claims itself."""

import re
from math import isfinite, nan
from unittest import mock

from pytest import mark, raises
from rupture.errors import Failure

from claims import judge
from claims.conditions import RELATIONS, as_number, met
from claims.judge import as_written, by_convention, holds, interval, interval_of, judged, shares_of
from claims.judge import unmet, unmet_text
from claims.samples import Samples, Sampling, Unit, every, sampled
from claims.table import read, rows_of, table, ways_of
from conftest import ROOT, approx
from measure.conventions import PRIMARY

ROW: dict = {"id": "row", "says": "something", "accepted": "if it is", "kind": "finding"}
ROW |= {"fixed": "today"}
OTHER: dict = {"ways": ["other"]}
ROWS: dict[str, dict] = {
    "all": {"conditions": {"x/L": {"at_least": "1/4", "at_most": 0.5}, "type": "fast"}},
    "one": {"conditions": {"x": {"above": 2}}, "unit": "run", "one_of": "spanning events"} | OTHER,
    "alone": {"conditions": {"x": {"below": 1}}},
    "two": {"conditions": {"x": {"below": 1}}} | OTHER,
    "any": {"conditions": {"x": {"below": 1}}, "unit": "event"} | OTHER,
    "state": {"conditions": {"x": {"below": 1}}, "unit": "seed"} | OTHER,
    "events": {"conditions": {"x": {"below": 1}}, "unit": "event"},
    "unstated": {"conditions": {}},
}
MADE_UP = {name: ROW | row for name, row in ROWS.items()}
GOOD, BAD = 3, 1
LOW, HIGH = 0, 2


def measured(sample, way):
    """A sample is x by way; x is a number, or those of several cases, of which one is enough."""
    x = sample.get(way, sample[PRIMARY])
    if x is None:
        return None
    return [{"x": one} for one in x] if isinstance(x, list) else {"x": x}


def seed(x, **others):
    return Unit(None, {PRIMARY: x} | others)


def run(*xs, **others):
    return seed([*xs], **others)


def runs(good, bad, **others):
    """So many units for which it holds, and does not; of all, so many under other ways."""
    found = [[BAD, GOOD]] * good + [[BAD]] * bad
    return [
        run(*xs, **{way: [GOOD if n < count else BAD] for way, count in others.items()})
        for n, xs in enumerate(found)
    ]


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
    """Five or more: it holds for `held` of them, and for `other` by the other way to measure."""
    return [
        seed(LOW if n < held else HIGH, other=LOW if n < other else HIGH)
        for n in range(max(held, 5))
    ]


JUDGED = [  # a claim, its shown case, its units, the verdict, and how the reason ends
    ("alone", LOW, None, "reproduced", "holds"),
    ("alone", HIGH, None, "differs", "does not hold"),
    ("one", GOOD, [], None, "only the case shown was judged, no other runs"),
    ("one", GOOD, runs(4, 0), None, "only 4 runs were judged; a verdict needs 5"),
    (
        "unstated",
        None,
        None,
        "not comparable",
        "gives no number to compare with; ours are reported",
    ),
    *(("one", shown, found, *said) for shown, found, *said in OVER_UNITS),
    ("state", LOW, seeds(3, 3), "reproduced", "holds in all of the 2 ways to measure"),
    ("state", LOW, seeds(3, 2), "depends", "of the 2 ways to measure, does not hold in other"),
    ("state", LOW, seeds(2, 0), "differs", "holds in none of the 2 ways to measure"),
    ("two", (LOW, LOW), None, "reproduced", "holds in all of the 2 ways to measure"),
    ("two", (HIGH, HIGH), None, "differs", "holds in none of the 2 ways to measure"),
    ("two", (LOW, HIGH), None, "depends", "of the 2 ways to measure, does not hold in other"),
    ("two", (HIGH, LOW), None, "depends", "of the 2 ways to measure, does not hold in primary"),
    ("events", LOW, seeds(19, 0) + seeds(0, 0)[:1], "reproduced", "19 of 20 events (primary)"),
    ("events", LOW, seeds(18, 0) + seeds(0, 0)[:2], "depends", "too few events for a verdict"),
    ("events", None, seeds(5, 0), "not comparable", "it could not be measured"),
]


FAILED = Unit(None, Failure("it was refused"))
BRANCHES = {"further": [seed(LOW), seed(HIGH)]}
SHARES: list = [  # a claim, other units, units, and for how many of how many it holds
    # A unit without a case counts against it, and so does one that failed.
    ("one", {}, [run(GOOD, other=[]), run(GOOD, other=[GOOD])], {PRIMARY: (2, 2), "other": (1, 2)}),
    ("events", {}, [*seeds(5, 0), FAILED], {PRIMARY: (5, 6)}),
    ("state", {}, [*seeds(5, 5), FAILED], {PRIMARY: (1, 1), "other": (1, 1)}),
    # Where there is nothing to compare, there is no unit.
    ("events", {}, [seed(LOW), seed(HIGH), seed(None)], {PRIMARY: (1, 2)}),
    # A branch is another convention, after the ways to measure.
    ("any", BRANCHES, [seed(HIGH)], {PRIMARY: (0, 1), "other": (0, 1), "further": (1, 2)}),
]


def samples(shown, units):
    """None: of one state."""
    by_way = dict(zip((PRIMARY, "other"), shown if isinstance(shown, tuple) else (shown,)))
    return Samples({"": by_way}, {} if units is None else {PRIMARY: units})


class TestJudge:
    def test_bounds_belong_to_the_range_and_all_conditions_count(self):
        for x, kind, expected in (
            *((0.25, "fast", True), (0.5, "fast", True), (0.2499, "fast", False)),
            *((0.5001, "fast", False), (0.3, "slow", False), (None, "fast", False)),
        ):
            assert holds(MADE_UP["all"], [{"x/L": x, "type": kind}]) == expected, (x, kind)

    def test_names_what_is_not_met(self):
        assert unmet(MADE_UP["all"], {"x/L": 0.7, "type": "slow"}) == ["x/L", "type"]

    def test_says_what_was_wanted_and_what_there_is(self):
        between = {"at_least": "1/200", "at_most": "1/50"}
        for condition, value, text in (
            (between, 1 / 49.6, "v is c_s/49.6, not c_s/200 to c_s/50"),
            ({"below": 0.5}, None, "v is none, not below c_s/2"),
            ({"above": 2}, 1.25, "v is 1.25 c_s, not above 2 c_s"),
            ("fast", "slow", "v is slow, not fast"),
        ):
            assert unmet_text({"conditions": {"v/c_s": condition}}, {"v/c_s": value}) == text
        close = unmet_text(MADE_UP["all"], {"x/L": 0.50001, "type": "fast"})
        assert close == "x/L is 0.50001, not 1/4 to 0.5"
        assert unmet_text(MADE_UP["one"], {"x": 1.98765}) == "x is 1.99, not above 2"

    def test_a_quantity_nobody_measured_is_an_error(self):
        with raises(KeyError):
            holds(MADE_UP["alone"], [{"y": 1}])

    def test_what_is_not_known_is_null_and_what_is_so_is_yes(self):
        assert as_written([nan, 1.0, True, False, "no", None]) == [None, 1, "yes", "no", "no", None]

    @mark.parametrize("name, shown, units, verdict, reason", JUDGED)
    def test_a_verdict_and_its_reason(self, name, shown, units, verdict, reason):
        shown = [shown] if name == "one" else shown
        claim = judged(MADE_UP[name], measured, samples(shown, units))
        because, _, wanted = claim.reason.partition(" (x is ")
        because = re.sub(r"; \d+ of \d+ spanning events$", "", because)
        assert (claim.verdict, because[-len(reason) :]) == (verdict, reason)
        assert bool(wanted) == (claim.case == "does not hold")

    def test_one_state_has_a_share_without_interval(self):
        found = by_convention(MADE_UP["state"], measured, {PRIMARY: seeds(3, 3)})
        shares = shares_of(MADE_UP["state"], found)
        assert [(s.units, s.low, s.high) for s in shares] == 2 * [(1, None, None)]

    @mark.parametrize("name, others, units, expected", SHARES)
    def test_shares(self, name, others, units, expected):
        row = MADE_UP[name]
        shares = shares_of(row, by_convention(row, measured, {PRIMARY: units} | others))
        found = {s.convention: (s.holds, s.units) for s in shares}
        assert (found, [*found]) == (expected, [*expected])

    def test_units_of_a_run_share_its_history(self):
        units = {PRIMARY: [Unit(n // 5, {PRIMARY: LOW if n < 50 else HIGH}) for n in range(100)]}
        [share] = shares_of(MADE_UP["events"], by_convention(MADE_UP["events"], measured, units))
        assert (share.low, share.high) == approx((0.3, 0.7))

    def test_counts_spanning_events_where_one_is_enough(self):
        units = [run(GOOD, BAD, BAD) for _ in range(20)]
        found = judged(MADE_UP["one"], measured, samples([GOOD], units))
        assert found.reason.endswith("; 20 of 60 spanning events")

    def test_counts_units_of_which_a_quantity_is_known_and_not_no(self):
        row = MADE_UP["one"] | {"counts": {"with more": "more"}}

        def more(sample, way):
            return [case | {"more": case["x"] > 2 or None} for case in measured(sample, way)]

        for units, count in ((runs(3, 2), "3 of 5"), ([], "not run")):
            found = judged(row, more, samples([GOOD], units)).measured
            assert found == {"x": 3, "more": "yes", "with more": count}

    def test_several_cases_are_shown_and_the_first_decides(self):
        shown = Samples({"II": {PRIMARY: LOW}, "I": {PRIMARY: HIGH}})
        found = judged(MADE_UP["alone"], measured, shown)
        assert (found.measured, found.case) == ({"II: x": LOW, "I: x": HIGH}, "holds")

    def test_a_name_that_does_not_exist_is_named_with_the_claim(self):
        for name, module in (("nothing", "figS3.commands"), ("none.of", "figS3.none")):
            row = ROW | {"recipe": "figS3", "measured": name, "samples": name}
            with mock.patch.object(judge, "rows_of", lambda _, row=row: [row]):
                with raises(Failure, match=f"claims.toml, claim row, 'measured': .*{module}"):
                    judge.judge("figS3")

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


def test_samples_are_computed_or_those_count_that_are_there(monkeypatch):
    calls = []

    class Found(list):
        refused = [((2,), "no such phi")]

    for name in ("each", "known"):

        def function(*_, name=name):
            calls.append(name)
            return Found([((3,), "three"), ((1,), "one")])

        monkeypatch.setattr(f"claims.samples.{name}", function)
    for is_whole in (False, True):
        monkeypatch.setattr(Sampling, "is_whole", is_whole)
        points, results = zip(*sampled(print, [(1,), (2,), (3,), (4,)]))
        assert points == ((1,), (2,), (3,))
        assert (results[0], str(results[1]), results[2]) == ("one", "no such phi", "three")
    assert calls == ["known", "each"]


def test_where_every_point_is_needed_a_refusal_is_an_error(monkeypatch):
    class Found(list):
        refused: list = []

    monkeypatch.setattr("claims.samples.each", lambda *_: Found([((1,), "one")]))
    assert every(print, [(1,)], "points") == {(1,): "one"}
    Found.refused = [((2,), "prepare: no such phi")]
    with raises(Failure, match="points: prepare: no such phi"):
        every(print, [(1,), (2,)], "points")


class TestTable:
    def test_no_claim_belongs_to_two_recipes(self):
        recipes = read("")[1]
        assert sum(map(len, recipes.values())) == len(table())
        assert [row["id"] for name in recipes for row in rows_of(name)] == [*table()]

    def test_every_row_is_complete(self):
        for row in table().values():
            assert {"recipe", "says", "fixed", "accepted", "samples", "measured"} <= set(row)
            assert row["kind"] in ("finding", "check")
            assert (ROOT / f"recipes/{row['recipe']}/figure.py").exists()
            for condition in row["conditions"].values():
                if isinstance(condition, dict):
                    assert condition and set(condition) <= set(RELATIONS)
                    assert all(isfinite(as_number(bound)) for bound in condition.values())

    def test_ways_are_a_set_by_name_or_names(self):
        found = [ways_of({"ways": ways}) for ways in ("raw", ["a", "b"])]
        assert [*found, ways_of({})] == [["raw line"], ["a", "b"], ()]
