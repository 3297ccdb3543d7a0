#!/usr/bin/env python3
"""Chooses one event of each seed: choose.py CHECKPOINT_EVERY run-02-events.json ...

It is the first of those that count which slows down: of the kind of claim 2A, but at any position
and any ratio of speeds (events/fronts.py). Few events meet all of claim 2A; whether they do must
not decide what the other claims are tested on. Prints from where to run it, as choose_events.py
does, or null where a seed has no such event.
"""

import json
import re
import sys

from events.choose_events import read_events, start
from events.fronts import counted, slows_down


def chosen(path, checkpoint_every):
    slowing = [event for event in counted(read_events(path)) if slows_down(event)]
    return start(slowing[0], checkpoint_every) if slowing else None


def name_of(path):
    return "seed-" + re.findall(r"run-(\d\d)-events\.json$", path)[0]


def main(checkpoint_every, *paths):
    starts = {name_of(path): chosen(path, float(checkpoint_every)) for path in paths}
    print(json.dumps(starts, indent=2))


if __name__ == "__main__":
    main(*sys.argv[1:])
