#!/usr/bin/env python3
# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Lists the fast-slow events of a load: choose.py events.json CHECKPOINT_EVERY

An event is fast-slow if its front crosses the interface and becomes slow after it was fast: beyond
the loading zone it runs at least ten times as fast, before the slow stretch, as within it, and the
slow stretch lasts as long as claim 2A asks for. The figure shows the first one. Prints for each
where it becomes slow, how fast it is before and then, and where to restart it from: 0.5 ms before
its first rupture, by way of the last checkpoint before that.
"""

import json
import sys

from events.choose_events import read_events, start
from events.fronts import is_fast_slow


def main(path, checkpoint_every):
    events = read_events(path)
    chosen = [event for event in events if is_fast_slow(event)]
    if not chosen:
        sys.exit(f"none of the {len(events)} events of this load is fast-slow: load for longer")
    starts = [start(event, float(checkpoint_every)) | {"slow": event["slow"]} for event in chosen]
    print(json.dumps({"spanning": sum(e["spanning"] for e in events), "events": starts}, indent=2))


if __name__ == "__main__":
    main(*sys.argv[1:])
