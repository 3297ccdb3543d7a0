#!/usr/bin/env python3
"""Chooses the events that figures show by rule: choose_events.py events.json CHECKPOINT_EVERY

fast-slow-fast, event I, is the first of the load that is so in words, second-slow, event II, the
second; fast-only, event III, is the first after event I that spans the interface and is fast
everywhere (claim 2B; events/fronts.py). Each is to be continued from 0.5 ms before its first
rupture. Prints, per event, that time and the last checkpoint before it.
"""

import json
import math
import sys

from data.records import report
from events.continuations import LEAD
from events.conventions import PRIMARY
from events.fronts import is_fast_only


def start(event, checkpoint_every):
    until = event["t_start"] - LEAD
    last_checkpoint = math.floor(until / checkpoint_every) * checkpoint_every
    return {"from": f"{last_checkpoint:.9f}", "until": f"{until:.7f}", "event": event["t_start"]}


def read_events(path, convention=PRIMARY):
    """The events of a load as ensemble/measure_events.py lists them."""
    return report(path)[convention]


def choose(events):
    """{name: event}; None where the load has no such event."""
    slow = [event for event in events if event["fast_slow_fast"]] + [None, None]
    later = (event for event in events if slow[0] and event["t_start"] > slow[0]["t_start"])
    return {
        "fast-slow-fast": slow[0],
        "fast-only": next(filter(is_fast_only, later), None),
        "second-slow": slow[1],
    }


def main(path, checkpoint_every):
    chosen = choose(read_events(path))
    if missing := [name for name, event in chosen.items() if event is None]:
        sys.exit(f"{path} has no event {' and no '.join(missing)}: load for longer")
    starts = {name: start(event, float(checkpoint_every)) for name, event in chosen.items()}
    print(json.dumps(starts, indent=2))


if __name__ == "__main__":
    main(*sys.argv[1:])
