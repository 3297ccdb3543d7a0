"""The picture of the paper's event: which events are the first of their run."""

from pytest import approx
from rupture.errors import Failure

from claims.samples import Sample
from ensemble import event_of_paper as picture
from ensemble.event_of_paper import FIRST, LATER

L = 0.14


def event(spanning, slow=False, x_last=0.0):
    stretch = {"x_from": 0.4 * L, "x_to": 0.6 * L}
    of = {"spanning": spanning, "fast_slow_fast": slow, "x_last": x_last * L, "L": L}
    return of | {"in_words": stretch, "t_start": 0.7}


def test_the_first_fast_slow_fast_event_of_a_run_is_apart_and_has_its_precursor():
    """The second one follows an event that spans, so it has no precursor; nor has one with which a
    run begins."""
    slow, arrested = event(True, True), event(False, x_last=0.5)
    unfinished = event(None) | {"x_last": None}
    first_run = [event(True), arrested, slow, slow, arrested, slow, unfinished]
    found = picture.ordered([first_run, [slow], []])
    assert [order for order, *_ in found] == [FIRST, LATER, LATER, FIRST]
    assert [x_p for _, x_p, _ in found] == [approx(0.5), None, approx(0.5), None]
    assert [*picture.rows(found)][0] == [FIRST, 0.7, approx(0.4), approx(0.6), approx(0.5)]


def test_samples_are_in_the_order_of_their_run_without_those_that_failed():
    samples = [Sample(401, "a"), Sample(402, Failure("")), Sample(401, "b"), Sample(403, "c")]
    assert picture.by_order(samples) == [(FIRST, "a"), (LATER, "b"), (FIRST, "c")]
