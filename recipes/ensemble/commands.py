"""The events of independent runs, and all that is computed from them."""

from functools import cache

from rupture.errors import Failure

import events
from fig5.commands import seeds
from measure.ways import PRIMARY
from measure.fronts import is_fast_only

SLOW, FAST, OTHER = "fast-slow-fast in words", "fast everywhere", "other"  # kinds of events
LAWS = {"load": "reference"} | {law: law for law in events.LAWS if law != "reference"}


def kind_of(event):
    if event["fast_slow_fast"]:
        return SLOW
    return FAST if is_fast_only(event) else OTHER


@cache
def runs(name):
    """{run: its events}, such as load-226093 and decaying-226093; seed 1 if it has no effect."""
    law = LAWS[name]
    found = events.runs(law) if law in events.SEEDS else [(1, events.shown_events(law))]
    return {f"{name}-{seed:02d}": of[PRIMARY] for seed, of in found if not isinstance(of, Failure)}


@cache
def spanning(name):
    """{run: [(kind, event)]} of the events that span."""
    return {
        run: [(kind_of(event), event) for event in of if event.spanning]
        for run, of in runs(name).items()
    }


def compute():
    """What figures and claims of others read."""
    events.samples_of_events()
    events.samples_of_branches()
    events.all_simplified()
    seeds()
