"""States just before the last precursor of a fast-slow-fast event, each continued with slipping
times of its own: where that precursor arrests then varies, and nothing else does."""

from functools import cache

import events
from claims.samples import outcomes
from events import COARSE, SEEDS, events_of
from measure.ways import PRIMARY
from rupture.errors import Failure
from rupture.once import each, run

FROM = 0.6  # [s]; earlier events of a run are of another kind
BEFORE = 1e-3  # the first rupture of the precursor [s]
LONGEST = 0.3  # until the next spanning event [s]
CONTINUATIONS = range(1, 11)


def precursor_of(found):
    """The last event that does not span before the first fast-slow-fast one after FROM."""
    slow = next((e for e in found if e.fast_slow_fast and e.t_start > FROM), None)
    earlier = [e for e in found if slow and e.t_start < slow.t_start and e.type == "arrested"]
    if not earlier:
        raise Failure("no event after 0.6 s is fast, slow and fast again, and follows a precursor")
    return earlier[-1]


def start_of(seed):
    return events.before(events.load(seed), precursor_of(events_of(seed)[PRIMARY]), early=BEFORE)


def place_of(found):
    """Of the first event that spans: where the event just before it arrested, and where its stretch
    below c_s/10 begins and ends, if it is fast-slow-fast [L]. None without a precursor."""
    number = next((n for n, event in enumerate(found) if event.spanning), 0)
    if not number:
        return None
    before, event = found[number - 1], found[number]
    place = {"x_p": before.x_last / event.L, "fast-slow-fast": event.fast_slow_fast}
    stretch = event.in_words if event.fast_slow_fast else {"x_from": None, "x_to": None}
    ends = {"begin": stretch["x_from"], "end": stretch["x_to"]}
    return place | {name: x and x / event.L for name, x in ends.items()}


def continuation(seed, number):
    line = f"restart {start_of(seed)} --seed {100 * seed + number} -o end.h5"
    record = run(f"{line} --until-spanned --for {LONGEST} {COARSE}")["record.h5"]
    return place_of(run(f"analyze events {record}").events)


@cache
def places():
    """{seed: [place of each continuation that has one]}"""
    points = [(seed, number) for seed in SEEDS["reference"] for number in CONTINUATIONS]
    found: dict[int, list] = {seed: [] for seed in SEEDS["reference"]}
    for (seed, _), place in outcomes(points, each(continuation, points, "continuations")):
        if place and not isinstance(place, Failure):
            found[seed].append(place)
    return found
