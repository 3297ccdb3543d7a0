"""The words for verdicts (claims/words.py)."""

from itertools import combinations_with_replacement, product

from pytest import mark

from claims.claim import Share
from claims.judge import interval
from claims.words import needed, reason_of_shares, word_of_shares, word_of_state
from measure.ways import PRIMARY

OF_EVENTS: dict = {"share_of": "events"}
ONE_OF_A_RUN: dict = {"share_of": "runs", "one_of": "events"}


def share(low, high, way=PRIMARY, runs=20):
    return Share(way, 0, 20, runs, low, high)


PLACES = (0, 0.15, 0.19, 0.21, 0.45, 0.55, 0.75, 0.85, 1)  # of the ends of an interval
INTERVALS = [*combinations_with_replacement(PLACES, 2)]


def words_that_fit(intervals, runs, bound):
    """docs/claims.md, line by line."""
    default, others = intervals[0], intervals[1:]
    above, below = (
        [pick(i, bound) for i in intervals]
        for pick in (lambda interval, b: interval[0] > b, lambda interval, b: interval[1] < b)
    )
    if runs < 5:
        yield "undecided"
    if not above.count(False):
        yield "reproduced"
    if default[1] < 0.2 and all(high < bound for _, high in others):
        yield "differs"
    if True in above and True in below:
        yield "by the measure"
    if below[0]:
        yield "in part"
    yield "undecided"


@mark.parametrize("count", (1, 2, 3))
@mark.parametrize("bound", (0.5, 0.8))
def test_the_first_line_that_fits_gives_the_word(count, bound):
    for intervals, runs in product(product(INTERVALS, repeat=count), (4, 5)):
        shares = [share(low, high, f"way {n}", runs) for n, (low, high) in enumerate(intervals)]
        word = word_of_shares(shares, bound)
        assert word == next(words_that_fit(intervals, runs, bound)), (intervals, runs)


def test_the_bound_is_0_8_and_0_5_where_one_event_is_enough():
    assert [needed(row) for row in (OF_EVENTS, ONE_OF_A_RUN)] == [0.8, 0.5]


RANK = ["differs", "in part", "undecided", "reproduced"]


@mark.parametrize("size", (5, 10, 20, 87))
def test_of_all_shares_the_word_is_the_better_the_more_samples_hold(size):
    """For one way: it never gets worse, all or none of many is clear, and each names itself."""
    for row in (OF_EVENTS, ONE_OF_A_RUN):
        words = []
        for k in range(size + 1):
            shares = [Share(PRIMARY, k, size, size, *interval(k, size))]
            words.append(word_of_shares(shares, needed(row)))
            reason = reason_of_shares(words[-1], shares, row)
            assert f"{k} of {size} {row['share_of']} (primary)" in reason
        assert sorted(words, key=RANK.index) == words
        assert "by the measure" not in words
        assert (
            (words[0], words[-1]) == ("differs", "reproduced")
            or size < 10
            or row is not ONE_OF_A_RUN
        )


def test_of_one_state_all_none_or_some_ways():
    for held in product((True, False), repeat=3):
        word = {3: "reproduced", 0: "differs"}.get(sum(held), "by the measure")
        assert word_of_state(dict(enumerate(held))) == word
