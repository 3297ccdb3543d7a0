"""What the recipe `places` takes as a precursor, its place, and what it compares."""

from pytest import mark, raises
from rupture.errors import Failure
from rupture.once import Report

from conftest import approx
from places import figure
from places.commands import place_of, precursor_of

L = 0.14


def event(t_start, spanning=False, slow=False, x_last=0.0):
    stretch = Report(x_from=0.5 * L, x_to=0.6 * L)
    found = {"t_start": t_start, "spanning": spanning, "fast_slow_fast": slow, "x_last": x_last * L}
    found["type"] = "slow" if spanning else "arrested"
    return Report(found | {"L": L, "in_words": stretch})


def test_a_precursor_is_the_last_event_that_does_not_span_before_a_slow_one_after_0_6_s():
    slow = [event(0.59, True, True), event(0.71, True, True), event(0.85, True, True)]
    found = [event(0.5), slow[0], event(0.62), event(0.65), event(0.7, True), slow[1], event(0.8)]
    assert precursor_of([*found, slow[2]]).t_start == 0.65
    for without in ([event(0.5), slow[0]], [slow[1]], [event(0.7, True)]):
        with raises(Failure, match="follows a precursor"):
            precursor_of(without)


@mark.parametrize("slow, begin, end", [(True, 0.5, 0.6), (False, None, None)])
def test_the_place_is_that_of_the_event_just_before_the_first_one_that_spans(slow, begin, end):
    first, later = event(0.7, True, slow), event(0.8, True, True)
    place = place_of([event(0.61, x_last=0.3), event(0.65, x_last=0.55), first, later])
    assert place["x_p"] == approx(0.55) and place["fast-slow-fast"] == slow
    assert (place["begin"], place["end"]) == (begin and approx(begin), end and approx(end))
    assert place_of([first]) is None and place_of([event(0.61)]) is None


def one(x_p, end, slow=True):
    return {"x_p": x_p, "begin": 0.1, "end": end, "fast-slow-fast": slow}


def test_deviations_are_from_the_mean_of_each_state():
    """Ends go half as far as x_p within a state, and the other way from state to state."""
    found = {1: [one(0.4, 0.9), one(0.5, 0.95), one(0.9, None, False)], 2: [one(0.7, 0.5)]}
    found[3] = [one(0.6, 0.7), one(0.8, 0.8)]
    result = figure.own_result(found)
    assert [*result.measured.values()][:5] == [approx(0.5), approx(1), 3, 6, 4]
    assert result.met is False
    half = {1: [one(0.4, 0.4), one(0.5, 0.5), one(0.6, 0.45)]}
    assert figure.own_result(half).measured[figure.CORRELATION] == approx(0.5)
    assert figure.own_result({1: [one(0.4, 0.5)]}).measured[figure.SLOPE] is None


def test_standard_deviations_are_within_states_and_between_their_means():
    """Of x_p: 0.1 around 0.4 and 0.1 around 0.8; the means are 0.2 from theirs. A front that is not
    fast-slow-fast does not count."""
    found = {1: [one(0.3, 0.5), one(0.5, 0.5)], 2: [one(0.7, 0.7), one(0.9, 0.7)], 3: []}
    found[1] += [one(0.9, None, False)]
    assert [*figure.spreads(found).values()] == [approx(0.1), approx(0), approx(0.2), approx(0.1)]


def test_shares_are_of_parts_of_equal_size_by_x_p():
    every = [one(n / 10, 0.5, n < 5) for n in range(10)]
    found = figure.shares(every[::-1])
    assert [*found.values()] == ["2 of 2", "2 of 2", "1 of 2", "0 of 2", "0 of 2"]
    assert [*found][0] == "fast-slow-fast, x_p from 0.00 to 0.10 L"
