#!/usr/bin/env python3
"""Judges the events of a load by claim S6A: event_choice.py events.json CHECKPOINT_EVERY

Of the events whose front crosses the interface, the first one that meets all conditions is taken;
if there is none, the first that meets as many as any. Prints every such event with the conditions
that it does not meet, and where to continue the one taken from: 0.5 ms before its first rupture, by
way of the last checkpoint.
"""

import json
import sys

from claims.judge import unmet
from events.choose_events import read_events, start
from events.event_claims import case_of_event
from events.conventions import DECAYING


def main(path, checkpoint_every):
    spanning = [event for event in read_events(path, DECAYING) if event["spanning"]]
    if not spanning:
        sys.exit("no event of this load spans the interface: load for longer")
    for event in spanning:
        event["unmet"] = unmet("S6A", case_of_event(event))
    taken = min(spanning, key=lambda event: len(event["unmet"]))  # the first of equals
    print(json.dumps(start(taken, float(checkpoint_every)) | {"events": spanning}))


if __name__ == "__main__":
    main(*sys.argv[1:])
