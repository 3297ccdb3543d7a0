"""Chooses the events that figures show: choose_events.py RULE events.json CHECKPOINT_EVERY

RULE is one of RULES below. Each event is to be continued from 0.5 ms before its first rupture:
returns that time and the last checkpoint before it.
"""

import math
import sys

from data.records import report
from events.continuations import LEAD
from events.conventions import PRIMARY
from events.fronts import is_fast_only, is_fast_slow


def start(event, checkpoint_every):
    until = event["t_start"] - LEAD
    last_checkpoint = math.floor(until / checkpoint_every) * checkpoint_every
    return {"from": f"{last_checkpoint:.9f}", "until": f"{until:.7f}", "event": event["t_start"]}


def read_events(path):
    """The events of a run as ensemble/measure_events.py lists them, by the primary convention."""
    return report(path)[PRIMARY]


def first_in_words(events):
    """The first that is fast-slow-fast in words; if none is, the first that spans."""
    spanning = [event for event in events if event["spanning"]]
    return next((event for event in spanning if event["fast_slow_fast"]), spanning[0])


def choose(events):
    """{name: event}; None where the load has no such event."""
    slow = [event for event in events if event["fast_slow_fast"]] + [None, None]
    later = (event for event in events if slow[0] and event["t_start"] > slow[0]["t_start"])
    return {
        "fast-slow-fast": slow[0],
        "fast-only": next(filter(is_fast_only, later), None),
        "second-slow": slow[1],
    }


def shown(path, checkpoint_every):
    """fast-slow-fast, event I, is the first of the load that is so in words, second-slow, event II,
    the second; fast-only, event III, is the first after event I that spans the interface and is
    fast everywhere (claim 2B)."""
    chosen = choose(read_events(path))
    if missing := [name for name, event in chosen.items() if event is None]:
        sys.exit(f"{path} has no event {' and no '.join(missing)}: load for longer")
    return {name: start(event, checkpoint_every) for name, event in chosen.items()}


def fast_slow(path, checkpoint_every):
    """The first whose front crosses the interface and becomes slow after it was fast (claim S2)."""
    events = read_events(path)
    chosen = next(filter(is_fast_slow, events), None)
    if chosen is None:
        sys.exit(f"none of the {len(events)} events of this load is fast-slow: load for longer")
    return start(chosen, checkpoint_every)


RULES = {"shown": shown, "fast-slow": fast_slow}


def main(rule, path, checkpoint_every):
    return RULES[rule](path, float(checkpoint_every))
