"""Which events of a load figures show: choose_shown.py POINT, a file with its events.

fast-slow-fast, event I, is the first that is so in words, second-slow, event II, the second;
fast-only, event III, is the first after event I that spans the interface and is fast everywhere
(claim 2B)."""

import sys

from chains.results import read_points
from measure.fronts import is_fast_only


def choose(events):
    """{name: event}; None where the load has no such event."""
    slow = [event for event in events if event["fast_slow_fast"]] + [None, None]
    later = (event for event in events if slow[0] and event["t_start"] > slow[0]["t_start"])
    return {
        "fast-slow-fast": slow[0],
        "fast-only": next(filter(is_fast_only, later), None),
        "second-slow": slow[1],
    }


def main(point):
    [load] = read_points(point)
    chosen = choose(load["measured"]["events"])
    if missing := [name for name, event in chosen.items() if event is None]:
        sys.exit(f"this load has no event {' and no '.join(missing)}: load for longer")
    times = {name: event["t_start"] for name, event in chosen.items()}
    return {"events": [{"name": name, "t_start": time} for name, time in times.items()]}
