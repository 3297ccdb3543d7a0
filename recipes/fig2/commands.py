"""Figure 2: events I, II and III, and that of independent runs which is most like the paper's."""

from functools import cache
from types import SimpleNamespace

import numpy as np
from rupture.errors import Failure
from rupture.once import keep, run
from rupture.reports import LOADING_ZONE, value, values

import events
from claims.resampling import interval_by_runs
from claims.samples import Samples, sampled
from claims.words import FEWEST
from events import FINE, shipped, shown_event, shown_events
from fig2.most_like import candidates
from measure.ways import PRIMARY
from measure.fronts import front_spans


def film():
    """Event I as a film of the slider. What happens later than in 4 ms is not slow any more."""
    recorded = "--fields 2e-5 --record record.h5 --record-every 2e-5"
    line = f"restart {shipped('fast-slow-fast')} -o filmed.h5 --for 0.004 {recorded}"
    movie = f"movie {run(line)['record.h5']} -o movie.gif --event 0"
    return run(movie, keep=["movie.gif"])["movie.gif"]


def most_like():
    """The event most like the paper's, from 0.5 ms before its first rupture; and all candidates."""
    compared = candidates({seed: of[PRIMARY] for seed, of in events.all_runs().items()})
    seed, event, _ = compared[0]
    start = events.before(events.load(seed), event)
    record = run(f"restart {start} -o event.h5 --for 0.01 {FINE}")["record.h5"]
    keep(record)
    front = run(f"analyze front {record} --event 0")
    return SimpleNamespace(record=record, front=front, candidates=[row for *_, row in compared])


@cache
def most_like_if_known():
    """None without independent runs."""
    return next((found for _, found in sampled(most_like, [()])), None)


# --- first and later events of runs ------------------------------------------------------------

OF_STRETCH = {  # of an event's stretch below c_s/10: what is measured
    "begin [L]": lambda event: value(event, "in_words.x_from") / event.L,
    "end [L]": lambda event: value(event, "in_words.x_to") / event.L,
    "slowest/c_s": lambda event: value(event, "in_words.slowest") / event.c_s,
    "speed before/c_s": lambda event: value(event, "in_words.fast_before") / event.c_s,
    "duration [ms]": lambda event: value(event, "in_words.duration") * 1e3,
}

ENDS = ("begin [L]", "end [L]")


def by_order(runs, way=PRIMARY):
    """{order: [fast-slow-fast events of each run that has such]}: the first one, and all later."""
    slow = [[event for event in of[way] if event.fast_slow_fast] for of in runs]
    parts = {"first": [of[:1] for of in slow], "later": [of[1:] for of in slow]}
    return {order: [of for of in of_runs if of] for order, of_runs in parts.items()}


def median_of(quantity, of_runs):
    """With its 90 % interval; NaN for what cannot be known."""
    of_runs = [[OF_STRETCH[quantity](event) for event in of] for of in of_runs]
    every = [one for of in of_runs for one in of]
    bounds = interval_by_runs(np.median, of_runs)
    found = (float(np.median(every)) if every else None, *bounds)
    return tuple(np.nan if one is None else one for one in found)


def first_events():
    """All runs are one state."""
    found = [of for _, of in events.runs() if not isinstance(of, Failure)]
    return Samples({"": found} if len(found) >= FEWEST else {})


def first_event(runs, way):
    """first-event"""
    orders = by_order(runs, way)
    found = {"runs with such an event": len(orders["first"])}
    for name, of in OF_STRETCH.items():
        for order, before in (("first", ""), ("later", "later events: ")):
            every = [of(event) for of_run in orders[order] for event in of_run]
            found[before + name] = median(np.array(every))
    for name in ENDS:
        _, low, high = median_of(name, orders["first"])
        found |= {f"low of the {name}": low, f"high of the {name}": high}
    begin, end = (found[f"high of the {name}"] - found[f"low of the {name}"] for name in ENDS)
    return found | {"wider interval [L]": max(begin, end)}


# --- other claims ------------------------------------------------------------------------------


def runs_beside(name):
    """A sample is the spanning events of a run; in the picture it is one of them."""
    return Samples({"": {PRIMARY: [shown_event(name).front]}}, events.samples_of_runs())


def runs_beside_I():
    return runs_beside("fast-slow-fast")


def runs_beside_III():
    return runs_beside("fast-only")


def shown_of(law):
    """The event of the run that figures show: the first spanning event that is fast-slow-fast in
    words, or the first one."""
    spanning = [event for event in shown_events(law)[PRIMARY] if event.spanning]
    such = [event for event in spanning if event.fast_slow_fast]
    return {PRIMARY: [*such, *spanning][:1]}


def median(times):
    known = times[np.isfinite(times)]
    return np.median(known) if len(known) else np.nan


def is_in_time(event):
    """Whether most blocks before the slow stretch rupture before it, and most behind it after."""
    stretch, times = event.in_words, values(event.t_rupture)
    x = np.arange(len(times)) * (event.L / (len(times) - 1))
    before = median(times[(x > LOADING_ZONE) & (x < stretch.x_from)])
    behind = median(times[x > stretch.x_to])
    return before < stretch.t_from and behind > stretch.t_to


def fast_slow_fast(of, way):
    """2A"""
    return [
        {
            "fast-slow-fast in words": event.fast_slow_fast,
            "below c_s/10 from [L]": value(event, "in_words.x_from") / event.L,
            "to [L]": value(event, "in_words.x_to") / event.L,
            "fast before [m/s]": value(event, "in_words.fast_before"),
            "fast, slow and fast in order of time": event.fast_slow_fast and is_in_time(event),
        }
        for event in of[way]
    ]


def numbers(of, way):
    """2A-numbers"""
    return [
        {
            "spans": front_spans(event),
            "begins at [L]": value(event, "in_words.x_from") / event.L,
            "ends at [L]": value(event, "in_words.x_to") / event.L,
            "duration [ms]": value(event, "in_words.duration") * 1e3,
            "speed before/c_s": value(event, "in_words.fast_before") / event.c_s,
            "slowest/c_s": value(event, "in_words.slowest") / event.c_s,
        }
        for event in of[way]
    ]


def slowest(event):
    """The lowest speed of a front's stencils beyond the loading zone [m/s]; NaN for a run's
    events."""
    pairs = zip(event.get("x", ()), values(event.get("v_c", ())))
    return min((v for x, v in pairs if x > LOADING_ZONE and v > 0), default=np.nan)


def fast_everywhere(of, way):
    """2B"""
    return [
        {
            "type": event.type,
            "slowest stencil [m/s]": slowest(event),
            "c_s/slowest": event.c_s / slowest(event),
        }
        for event in of[way]
    ]


def speeds(of, way):
    """2C"""
    return [
        {
            "spans": front_spans(event),
            "fast before/c_s": value(event, "slow.fast_before") / event.c_s,
            "slowest/c_s": value(event, "slow.slowest") / event.c_s,
            "length/duration/c_s": (value(event, "slow.x_to") - value(event, "slow.x_from"))
            / ((value(event, "slow.duration") or np.nan) * event.c_s),
        }
        for event in of[way]
    ]
