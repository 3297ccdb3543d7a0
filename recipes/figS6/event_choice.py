#!/usr/bin/env python3
"""Judges the events of a load by claim S6A: event_choice.py events.json CHECKPOINT_EVERY

The criteria are those of claim 2A with another slow speed, at most c_s/8. Of the events whose front
crosses the interface, the first one that meets all of them is taken; if there is none, the first
that meets as many as any. Prints every such event with the criteria it meets, and where to
continue the one taken from: 0.5 ms before its first rupture, by way of the last checkpoint.
"""

import json
import sys

from common.choose_events import start
from common.fronts import DURATION, FAST_OVER_SLOW, TO_FAST, TO_SLOW, within

SLOW_SPEED = 1 / 8  # of c_s
CRITERIA = ["slow speed", "duration", "to slow", "to fast", "fast before", "fast after"]


def is_fast(speed, slow):
    return speed is not None and speed >= FAST_OVER_SLOW * slow["speed"]


def criteria(event):
    """Which of the criteria the event meets."""
    slow = event["slow"]
    if slow is None:
        return dict.fromkeys(CRITERIA, False)
    met = [
        slow["speed"] <= SLOW_SPEED * event["c_s"],
        within(slow["duration"], DURATION),
        within(slow["x_from"] / event["L"], TO_SLOW),
        within(slow["x_to"] / event["L"], TO_FAST),
        is_fast(slow["fast_before"], slow),
        is_fast(slow["fast_after"], slow),
    ]
    return dict(zip(CRITERIA, met))


def main(path, checkpoint_every):
    with open(path, encoding="utf-8") as file:
        spanning = [event for event in json.load(file)["events"] if event["spanning"]]
    if not spanning:
        sys.exit("no event of this load spans the interface: load for longer")
    judged = [
        {"t_start": event["t_start"], "slow": event["slow"], "met": criteria(event)}
        for event in spanning
    ]
    taken = max(judged, key=lambda event: sum(event["met"].values()))  # the first of equals
    print(json.dumps(start(taken, float(checkpoint_every)) | {"events": judged}, indent=2))


if __name__ == "__main__":
    main(*sys.argv[1:])
