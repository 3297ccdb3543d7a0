#!/usr/bin/env python3
"""Chooses the first fast-slow event of a load: choose.py events.json CHECKPOINT_EVERY

An event is fast-slow if its front crosses the interface and becomes slow after it was fast: beyond
the loading zone it runs at least ten times as fast, before the slow stretch, as within it, and the
slow stretch lasts as long as claim 2A asks for. Prints where to restart it from: 0.5 ms before its
first rupture, by way of the last checkpoint before that.
"""

import json
import sys

from events.choose_events import read_events, start
from events.fronts import is_fast_slow


def main(path, checkpoint_every):
    events = read_events(path)
    chosen = next(filter(is_fast_slow, events), None)
    if chosen is None:
        sys.exit(f"none of the {len(events)} events of this load is fast-slow: load for longer")
    print(json.dumps(start(chosen, float(checkpoint_every)), indent=2))


if __name__ == "__main__":
    main(*sys.argv[1:])
