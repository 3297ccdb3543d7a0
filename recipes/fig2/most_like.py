"""Chooses the event most like the paper's of independent runs; README.md says how."""

import numpy as np
from rupture.errors import Failure

import paper
from event_numbers import numbers_of

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
    if event["type"] != "slow" or not all(known):
        return None
    return {name: case[key] / of_paper for name, (key, of_paper) in PAPER.items()}


def unlikeness(ratios):
    return float(np.sum(np.log(list(ratios.values())) ** 2))


def candidates(runs):
    """[(seed, event, row of the table)], the most like one first. `runs`: {seed: events}."""
    found = [
        (seed, event, {"load": f"load-{seed}", "t_start [s]": event["t_start"], **ratios})
        for seed, events in runs.items()
        for event in events
        if (ratios := ratios_of(event))
    ]
    for *_, row in found:
        row[SUM] = unlikeness({name: row[name] for name in PAPER})
    if not found:
        raise Failure("no event of these loads has all that is compared: load for longer")
    return sorted(found, key=lambda one: one[-1][SUM])
