"""Figure S2: events with the simplified law, as they are and without slow slip."""

from functools import cache

from rupture.once import keep

from claims.samples import Samples, Sample
from events import all_simplified, shown_events, simplified
from measure.ways import PRIMARY
from measure.fronts import is_fast_slow


@cache
def shown():
    """The first event that spans and becomes slow after it was fast."""
    events = shown_events("simplified")[PRIMARY]
    of = simplified(next(n for n, event in enumerate(events) if is_fast_slow(event)))
    keep(of.record, of.without_record)
    return of


def in_way(event, events):
    """What is the event among those that were found in another way; None if it is not there."""
    same = (e for e in events if e.t_start <= event.t_end and e.t_end >= event.t_start)
    return next(same, None)


def transitions():
    """A sample is an event, found in each way, and continued without slow slip. A seed has no
    effect, so there is one run."""
    found = [
        ({way: in_way(of.event, of_way) for way, of_way in shown_events("simplified").items()}, of)
        for of in all_simplified()
    ]
    taken = [Sample(1, (fronts, of.without)) for fronts, of in found]
    return Samples({"": ({PRIMARY: shown().front}, shown().without)}, {PRIMARY: taken})


def transition(of, way):
    """S2"""
    front, without = (fronts[way] for fronts in of)
    if not front or not is_fast_slow(front) or without.type == "none":
        return None
    return {
        "transition with slow slip": True,
        "transition without": without.slow is not None,
        "slow [m/s]": front.slow.speed,
        "for [ms]": front.slow.duration * 1e3,
        "without slow slip": without.type,
    }
