"""Chooses the event most like the paper's of independent loads: most_like.py LOAD POINTS

README.md says how. POINTS is a file with the events of all loads. Reports all candidates in order,
and the first of them, the one chosen, in a list: empty if it is not of this LOAD.
"""

import sys

import numpy as np

from chains.results import read_points
from claims import paper
from measure.event_numbers import numbers_of
from measure.fronts import has_slow_stretch
from measure.loads import events_of

PAPER = {  # for readers: of numbers_of(), the paper's value
    "fast before over c_s/3": ("fast before/c_s", paper.FAST),
    "slowest stencil over c_s/100": ("slowest/c_s", paper.SLOW),
    "from over 0.4 L": ("from [L]", paper.TRANSITIONS[0]),
    "to over 0.6 L": ("to [L]", paper.TRANSITIONS[1]),
    "duration over 1 ms": ("duration [ms]", paper.SLOW_FOR * 1e3),
}
SUM = "sum of squared logarithms"
COLUMNS = ["load", "t_start [s]", *PAPER, SUM]  # of the table


def ratios_of(event):
    """Measured over the paper's; None where the event spans without a slow stretch, or where one of
    the five is not known or zero. A stretch that is not fast at an end has no transition there."""
    case = numbers_of(event)
    known = [case[key] for key, _ in PAPER.values()] + [(event["slow"] or {}).get("fast_after")]
    if not has_slow_stretch(event) or not all(known):
        return None
    return {name: case[key] / of_paper for name, (key, of_paper) in PAPER.items()}


def unlikeness(ratios):
    return float(np.sum(np.log(list(ratios.values())) ** 2))


def candidates(loads):
    """[(event, row), ...], the most like one first. `loads`: {name: events}."""
    found = [
        (event, {"load": load, "t_start [s]": event["t_start"], **ratios, SUM: unlikeness(ratios)})
        for load, events in loads.items()
        for event in events
        if (ratios := ratios_of(event))
    ]
    return sorted(found, key=lambda pair: pair[1][SUM])


def choice(load, loads):
    found = candidates(loads)
    if not found:
        sys.exit("no event of these loads has all that is compared: load for longer")
    event, first = found[0]
    chosen = [event] if first["load"] == load else []
    return {"candidates": [row for _, row in found], "chosen": chosen}


def main(load, points):
    return choice(load, events_of(read_points(points)))
