"""The judge of claims: conditions and shares, and the table of claims."""

from itertools import product
from math import isfinite, nan
from unittest import mock

from pytest import mark, raises
from rupture.errors import Failure

from claims import judge
from claims.conditions import RELATIONS, as_number, met
from claims.judge import as_written, by_way, holds, interval, interval_of, judged, share_of
from claims.judge import shares_of, unmet, unmet_text
from claims.samples import Sample, Samples, Sampling, every, sampled
from claims.table import left_out, read, rows_of, table, ways_of
from conftest import ROOT, approx
from measure.ways import PRIMARY, WAYS

ROW: dict = {"id": "row", "says": "something", "accepted": "if it is", "kind": "finding"}
ROW |= {"fixed": "today"}
OTHER: dict = {"ways": ["other"]}
ROWS: dict[str, dict] = {
    "all": {"conditions": {"x/L": {"at_least": "1/4", "at_most": 0.5}, "type": "fast"}},
    "one": {"conditions": {"x": {"above": 2}}, "share_of": "runs", "one_of": "events"} | OTHER,
    "alone": {"conditions": {"x": {"below": 1}}},
    "two": {"conditions": {"x": {"below": 1}}} | OTHER,
    "any": {"conditions": {"x": {"below": 1}}, "share_of": "events"} | OTHER,
    "state": {"conditions": {"x": {"below": 1}}, "share_of": "seeds"} | OTHER,
    "events": {"conditions": {"x": {"below": 1}}, "share_of": "events"},
    "unstated": {"conditions": {}},
}
MADE_UP = {name: ROW | row for name, row in ROWS.items()}
GOOD, BAD = 3, 1
LOW, HIGH = 0, 2


def measured(sample, way):
    """A sample is x by way; x is a number, or those of several events, of which one is enough. A
    way that it lacks finds nothing."""
    x = sample.get(way, [])
    if x is None:
        return None
    return [{"x": one} for one in x] if isinstance(x, list) else {"x": x}


def seed(x, other=None):
    return Sample(None, {PRIMARY: x, "other": x if other is None else other})


def run(*xs, **others):
    return seed([*xs], **others)


def runs(good, bad, other=None):
    """So many runs in which it holds, and does not; of all, so many in the other way."""
    other = good if other is None else other
    found = [[BAD, GOOD]] * good + [[BAD]] * bad
    return [run(*xs, other=[GOOD if n < other else BAD]) for n, xs in enumerate(found)]


MORE = "; more runs would tell"
OVER_RUNS = (
    [  # what is shown, samples, the verdict, and how the reason ends. One is enough: bound 0.5
        (GOOD, runs(20, 0), "reproduced", "holds in at least 20 of 20 runs (primary)"),
        (BAD, runs(20, 0), "reproduced", "holds in at least 20 of 20 runs (primary)"),
        (GOOD, runs(14, 6), "reproduced", "14 of 20 runs (primary)"),
        (GOOD, runs(13, 7), "undecided", f"holds in 13 of 20 runs (primary){MORE}"),
        (GOOD, runs(7, 13), "undecided", f"holds in 7 of 20 runs (primary){MORE}"),
        (GOOD, runs(6, 14), "in part", "holds in 6 of 20 runs (primary)"),
        (GOOD, runs(1, 19), "differs", "holds in at most 1 of 20 runs (primary)"),
        (GOOD, runs(2, 18), "in part", "holds in 2 of 20 runs (primary)"),  # up to 0.28
        (GOOD, runs(0, 20, other=6), "differs", "holds in at most 6 of 20 runs (other)"),
        (BAD, runs(0, 20, other=7), "in part", "holds in 0 of 20 runs (primary)"),
        (
            GOOD,
            runs(0, 20, other=14),
            "by the measure",
            "14 of 20 runs (other), but in 0 of 20 runs (primary)",
        ),
        (
            GOOD,
            runs(20, 0, other=6),
            "by the measure",
            "20 of 20 runs (primary), but in 6 of 20 runs (other)",
        ),
        (
            GOOD,
            runs(20, 0, other=13),
            "undecided",
            f"20 of 20 runs (primary), and in 13 of 20 runs (other){MORE}",
        ),
        (GOOD, runs(4, 0), "undecided", "holds in 4 of 4 runs (primary); a verdict needs 5 runs"),
    ]
)


def seeds(held, other):
    """Five or more: it holds for `held` of them, and for `other` by the other way to measure."""
    return [
        seed(LOW if n < held else HIGH, other=LOW if n < other else HIGH)
        for n in range(max(held, 5))
    ]


JUDGED = [  # a claim, what is shown, its samples, the verdict, and how the reason ends
    ("alone", LOW, None, "reproduced", "holds"),
    ("alone", HIGH, None, "differs", "does not hold"),
    ("one", GOOD, [], None, "no sample has been computed yet"),
    (
        "unstated",
        None,
        None,
        "not comparable",
        "gives no number to compare with; ours are reported",
    ),
    *(("one", shown, found, *said) for shown, found, *said in OVER_RUNS),
    ("state", HIGH, seeds(3, 3), "reproduced", "holds in all of the 2 ways to measure"),
    (
        "state",
        LOW,
        seeds(3, 2),
        "by the measure",
        "of the 2 ways to measure, does not hold in other",
    ),
    ("state", LOW, seeds(2, 0), "differs", "holds in none of the 2 ways to measure"),
    ("state", LOW, seeds(5, 5)[:4], None, "no sample has been computed yet"),
    ("two", (LOW, LOW), None, "reproduced", "holds in all of the 2 ways to measure"),
    ("two", (HIGH, HIGH), None, "differs", "holds in none of the 2 ways to measure"),
    (
        "two",
        (LOW, HIGH),
        None,
        "by the measure",
        "of the 2 ways to measure, does not hold in other",
    ),
    (
        "two",
        (HIGH, LOW),
        None,
        "by the measure",
        "of the 2 ways to measure, does not hold in primary",
    ),
    ("events", LOW, seeds(19, 0) + seeds(0, 0)[:1], "reproduced", "19 of 20 events (primary)"),
    ("events", LOW, seeds(18, 0) + seeds(0, 0)[:2], "undecided", MORE),
    ("events", None, seeds(20, 0), "reproduced", "20 of 20 events (primary)"),
]


FAILED = Sample(None, Failure("it was refused"))
BRANCHES = {"further": [seed(LOW), seed(HIGH)]}
SHARES: list = [  # a claim, samples elsewhere, samples, and for how many of how many it holds
    # A sample in which nothing was found counts against it, and so does one that failed.
    ("one", {}, [run(GOOD, other=[]), run(GOOD, other=[GOOD])], {PRIMARY: (2, 2), "other": (1, 2)}),
    ("events", {}, [*seeds(5, 0), FAILED], {PRIMARY: (5, 6)}),
    ("state", {}, [*seeds(5, 5), FAILED], {PRIMARY: (1, 1), "other": (1, 1)}),
    # Where there is nothing to compare, there is no sample.
    ("events", {}, [seed(LOW), seed(HIGH), seed(None)], {PRIMARY: (1, 2)}),
    # A way that nobody measured does not count as the primary one.
    ("any", {}, [Sample(None, {PRIMARY: LOW})], {PRIMARY: (1, 1), "other": (0, 1)}),
    # A branch is another way, after the ways to measure.
    ("any", BRANCHES, [seed(HIGH)], {PRIMARY: (0, 1), "other": (0, 1), "further": (1, 2)}),
]


def samples(shown, taken):
    """None: of one state."""
    of_ways = dict(zip((PRIMARY, "other"), shown if isinstance(shown, tuple) else (shown,)))
    return Samples({"": of_ways}, {} if taken is None else {PRIMARY: taken})


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

    @mark.parametrize("name, shown, taken, verdict, reason", JUDGED)
    def test_a_verdict_and_its_reason(self, name, shown, taken, verdict, reason):
        shown = [shown] if name == "one" else shown
        claim = judged(MADE_UP[name], measured, samples(shown, taken))
        because, _, wanted = claim.reason.partition(" (shown: x is ")
        assert (claim.verdict, because[-len(reason) :]) == (verdict, reason)
        assert bool(wanted) == (claim.shown == "does not hold")

    def test_what_was_chosen_because_it_holds_is_not_reported_as_holding(self):
        for row, shown in (
            (MADE_UP["alone"], "holds"),
            (MADE_UP["alone"] | {"chosen": "so"}, None),
        ):
            assert judged(row, measured, samples(LOW, None)).shown == shown

    def test_one_state_has_a_share_without_interval(self):
        found = by_way(MADE_UP["state"], measured, {PRIMARY: seeds(3, 3)})
        shares = shares_of(MADE_UP["state"], found)
        assert [(s.samples, s.low, s.high) for s in shares] == 2 * [(1, None, None)]

    @mark.parametrize("name, others, taken, expected", SHARES)
    def test_shares(self, name, others, taken, expected):
        row = MADE_UP[name]
        found = by_way(row, measured, {PRIMARY: taken} | others)
        shares = {way: share_of(row, way, of) for way, of in found.items()}
        counted = {way: (share.holds, share.samples) for way, share in shares.items()}
        assert (counted, [*counted]) == (expected, [*expected])

    def test_samples_of_a_run_share_its_history(self):
        taken = {PRIMARY: [Sample(n // 5, {PRIMARY: LOW if n < 50 else HIGH}) for n in range(100)]}
        [share] = shares_of(MADE_UP["events"], by_way(MADE_UP["events"], measured, taken))
        assert (share.low, share.high) == approx((0.3, 0.7))
        assert (share.samples, share.runs) == (100, 20)

    def test_a_verdict_needs_five_runs_however_many_events_there_are(self):
        for count, verdict in ((4, "undecided"), (5, "reproduced")):
            taken = [Sample(n % count, {PRIMARY: LOW}) for n in range(60)]
            assert judged(MADE_UP["events"], measured, samples(LOW, taken)).verdict == verdict

    def test_counts_spanning_events_where_one_is_enough(self):
        taken = [run(GOOD, BAD, BAD) for _ in range(20)]
        found = judged(MADE_UP["one"], measured, samples([GOOD], taken))
        assert found.measured["of all events"] == "20 of 60"

    def test_counts_samples_of_which_a_quantity_is_known_and_not_no(self):
        row = MADE_UP["one"] | {"counts": {"with more": "more"}}

        def more(sample, way):
            return [one | {"more": one["x"] > 2 or None} for one in measured(sample, way)]

        for taken, count in ((runs(3, 2), "3 of 5"), ([], "not run")):
            found = judged(row, more, samples([GOOD], taken)).measured
            assert [*found.items()][:3] == [("x", 3), ("more", "yes"), ("with more", count)]

    def test_several_are_shown_and_the_first_is_reported(self):
        shown = Samples({"II": {PRIMARY: LOW}, "I": {PRIMARY: HIGH}})
        found = judged(MADE_UP["alone"], measured, shown)
        assert (found.measured, found.shown) == ({"II: x": LOW, "I: x": HIGH}, "holds")

    def test_a_name_that_does_not_exist_is_named_with_the_claim(self):
        for name, module in (("nothing", "figS3.commands"), ("none.of", "figS3.none")):
            row = ROW | {"recipe": "figS3", "measured": name, "samples": name}
            with mock.patch.object(judge, "rows_of", lambda _, row=row: [row]):
                with raises(Failure, match=f"claims.toml, claim row, 'measured': .*{module}"):
                    judge.judge("figS3")

    def test_interval(self):
        """Brown, Cai and DasGupta (2001): Jeffreys' interval, closed where all or none hold."""
        for k, n, expected in (
            *((0, 20, (0, 0.0906)), (20, 20, (0.9094, 1)), (10, 20, (0.324, 0.676))),
            *((1, 20, (0.0087, 0.1797)), (0, 10, (0, 0.1708)), (0, 0, (0, 1))),
        ):
            assert interval(k, n) == approx(expected, abs=5e-4), (k, n)

    def test_interval_of_events_of_which_runs_are_drawn(self):
        """If all five events of a run hold or none does, a share of 20 runs is binomial: 6 and 14
        of 20 are its quantiles. If half of each run holds, it is that of independent events."""
        assert interval_of([5 * [run < 10] for run in range(20)]) == approx((0.3, 0.7))
        assert interval_of(10 * [5 * [False, True]]) == interval(50, 100)
        assert interval_of([[n < 5] for n in range(10)]) == interval(5, 10)
        assert interval_of([[True], [], [False]]) == interval(1, 2)

    def test_two_runs_are_drawn_too(self):
        """Both runs, or one of them twice: 0, 0.5 and 1."""
        assert interval_of([10 * [True], 10 * [False]]) == (0, 1)

    def test_events_have_the_same_weight_and_runs_have_not(self):
        """Ten runs of one event that holds, ten of nine that do not. Of 20 runs that are drawn, 6
        to 14 are of the first kind: 6 of 132 events to 14 of 68."""
        drawn = interval_of(10 * [[True]] + 10 * [9 * [False]])
        assert drawn == approx((6 / 132, 14 / 68))

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


def test_what_is_shown_changes_no_word():
    for shown, good in product((GOOD, BAD), range(21)):
        claim = judged(MADE_UP["one"], measured, samples([shown], runs(good, 20 - good)))
        assert (
            claim.verdict
            == judged(MADE_UP["one"], measured, samples([GOOD], runs(good, 20 - good))).verdict
        )


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

    def test_ways_are_all_of_fronts_but_those_left_out_and_others_by_name(self):
        ways = ["fronts", "a"]
        assert [*ways_of({}), *ways_of({"ways": ["a"]})] == ["a"]
        assert ways_of({"ways": ways}) == [*WAYS][1:] + ["a"]
        row = {"ways": ways, "left_out": {"slow below": "why", "raw": "so"}}
        assert ways_of(row) == [w for w in WAYS if w[:4] not in ("prim", "slow", "raw ")] + ["a"]
        assert left_out(row) == "Ways to measure that are left out: slow below: why; raw: so."
        assert left_out({}) == ""

    def test_every_finding_is_measured_in_all_ways_or_says_why_not(self):
        for name, row in table().items():
            if row["kind"] == "finding" and row["conditions"]:
                assert ("fronts" in row.get("ways", ())) != ("" in row.get("left_out", {})), name
