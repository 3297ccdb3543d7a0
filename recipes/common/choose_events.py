#!/usr/bin/env python3
"""Chooses the events of Figures 2 and 3 by rule: choose_events.py events.json CHECKPOINT_EVERY

The fast-slow-fast event is the first one that meets the criteria of claim 2A, the fast-only event
the first that meets those of claim 2B (common/fronts.py). Each is to be continued from 0.5 ms
before its first rupture. Prints, per event, that time and the last checkpoint before it.
"""

import json
import math
import sys

from common.fronts import is_fast_only, is_fast_slow_fast

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


def main(path, checkpoint_every):
    with open(path, encoding="utf-8") as file:
        events = json.load(file)["events"]
    chosen = {
        "fast-slow-fast": first(events, "fast-slow-fast", is_fast_slow_fast),
        "fast-only": first(events, "fast-only", is_fast_only),
    }
    starts = {name: start(event, float(checkpoint_every)) for name, event in chosen.items()}
    print(json.dumps(starts, indent=2))


if __name__ == "__main__":
    main(*sys.argv[1:])
