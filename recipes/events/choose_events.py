#!/usr/bin/env python3
"""Chooses the events that figures show by rule: choose_events.py events.json CHECKPOINT_EVERY

fast-slow-fast is the first event that meets the criteria of claim 2A, fast-only the first that
meets those of claim 2B (events/fronts.py), second-slow the first after fast-slow-fast that spans
the interface and has a slow stretch. Each is to be continued from 0.5 ms before its first rupture.
Prints, per event, that time and the last checkpoint before it.
"""

import json
import math
import sys

from data.records import report
from events.event_claims import is_fast_slow_fast
from events.fronts import has_slow_stretch, is_fast_only

LEAD = 0.5e-3  # [s]


def first(events, name, is_wanted):
    for event in events:
        if is_wanted(event):
            return event
    sys.exit(f"none of the {len(events)} events of this run is {name}: load for longer")


def start(event, checkpoint_every):
    until = event["t_start"] - LEAD
    last_checkpoint = math.floor(until / checkpoint_every) * checkpoint_every
    return {"from": f"{last_checkpoint:.9f}", "until": f"{until:.7f}", "event": event["t_start"]}


def read_events(path):
    return report(path)["events"]


def main(path, checkpoint_every):
    events = read_events(path)
    first_slow = first(events, "fast-slow-fast", is_fast_slow_fast)
    later = events[events.index(first_slow) + 1 :]
    chosen = {
        "fast-slow-fast": first_slow,
        "fast-only": first(events, "fast-only", is_fast_only),
        "second-slow": first(later, "a second one with a slow stretch", has_slow_stretch),
    }
    starts = {name: start(event, float(checkpoint_every)) for name, event in chosen.items()}
    print(json.dumps(starts, indent=2))


if __name__ == "__main__":
    main(*sys.argv[1:])
