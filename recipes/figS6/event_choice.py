#!/usr/bin/env python3
"""Judges the events of a load by claim S6A: event_choice.py events.json CHECKPOINT_EVERY

The criteria are those of claim 2A with another slow speed, at most c_s/8. Of the events whose front
crosses the interface, the first one that meets all of them is taken; if there is none, the first
that meets as many as any. Prints every such event with the criteria it meets, and where to
continue the one taken from: 0.5 ms before its first rupture, by way of the last checkpoint.
"""

import json
import sys

from events.choose_events import read_events, start
from events.fronts import criteria_2A

SLOW_SPEED = (0, 1 / 8)  # of c_s
CRITERIA = {  # of claim 2A, but for spanning, which all these events do: name here
    "slow speed": "slow speed",
    "duration": "duration",
    "from": "to slow",
    "to": "to fast",
    "fast before": "fast before",
    "fast after": "fast after",
}


def criteria(event):
    """Which of the criteria the event meets."""
    met = criteria_2A(event, SLOW_SPEED) if event["slow"] else {}
    return {name: met.get(criterion, False) for criterion, name in CRITERIA.items()}


def main(path, checkpoint_every):
    spanning = [event for event in read_events(path) if event["spanning"]]
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
