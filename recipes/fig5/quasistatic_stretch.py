"""Finds a quasi-static front between dynamic events.

Dynamic events are times at which more than half of the blocks rupture within 1 ms. Between the
first two of them, the tip is the furthest block that has ruptured. What happens within 10 ms (5
t_R) of either event belongs to that: single blocks rupture again, or the later event nucleates.
"""

import numpy as np
import rupture
from rupture.errors import Failure

WINDOW = 1e-3  # [s]
APART = 10e-3  # from a dynamic event [s]
TENTHS = range(1, 10)
MIDDLE = 5  # of the tenths
STOPPED_FOR = 20e-3  # [s]


def read_ruptures(path):
    """Time [s] and block of each rupture, and the positions of the blocks [m]."""
    record = rupture.open(path)
    return record.ruptures.time, record.ruptures.block, record.x


def dynamic_events(time, block, blocks):
    """[start, end] of each dynamic event [s]."""
    events: list[list[float]] = []
    for start in time:
        within = (time >= start) & (time <= start + WINDOW)
        if len(np.unique(block[within])) <= blocks / 2:
            continue
        end = time[within][-1]
        if events and start <= events[-1][1]:
            events[-1][1] = end
        else:
            events.append([start, end])
    return events


def tip_advances(time, block, from_t, to_t):
    """Times at which the tip advances after from_t, and the blocks that it then reaches."""
    within = (time > from_t) & (time < to_t)
    time, tip = time[within], np.maximum.accumulate(block[within])
    first = np.diff(tip, prepend=-1) > 0
    return time[first], tip[first]


def quasistatic_stretch(ruptures, checkpoint_every):
    """Between the first two dynamic events, or from the first one to the end of the record."""
    time, block, x = ruptures
    events = dynamic_events(time, block, len(x))
    if not events:
        raise Failure("this load has no dynamic event: load for longer")
    end = events[1][0] if len(events) > 1 else np.inf
    start = events[0][1] + APART
    t, tip = tip_advances(time, block, start, end - APART)
    tenths = {tenth: t[0] + tenth / 10 * (t[-1] - t[0]) for tenth in TENTHS}
    near = {n: round(at / checkpoint_every) * checkpoint_every for n, at in tenths.items()}
    return {
        "dynamic_events": [start for start, _ in events],
        "interval_from": start,
        "tip": [[when, x[b]] for when, b in zip(t, tip)],
        "speed": (x[tip[-1]] - x[tip[0]]) / (t[-1] - t[0]),
        "branches": [{"t": f"{at:.9f}", "middle": n == MIDDLE} for n, at in near.items()],
    }


def furthest(ruptures, from_t, to_t):
    """Furthest block that ruptures in a stretch of time; -1 if there is none."""
    time, block, _ = ruptures
    return max(block[(time > from_t) & (time <= to_t)], default=-1)


def advances(load, stopped, interval_from, t_branch):
    """Blocks by which the tip advances after a branch, with the driving and without it."""
    until = t_branch + STOPPED_FOR
    tip = furthest(load, interval_from, t_branch)
    driven = max(furthest(load, t_branch, until) - tip, 0)
    return {
        "t": t_branch,
        "tip": int(tip),
        "driven": int(driven),
        "stopped": int(max(furthest(stopped, t_branch, until) - tip, 0)),
    }


def stretch_of(record, checkpoint_every):
    """When the tip was where, and the checkpoints nearest to each tenth of the stretch, where a run
    with the driving stopped can branch off."""
    return quasistatic_stretch(read_ruptures(record), checkpoint_every)


def advances_of(record, stopped, interval_from, t_branch):
    """The number of blocks by which the tip advances after a branch, with the driving and without
    it."""
    found = advances(read_ruptures(record), read_ruptures(stopped), interval_from, t_branch)
    return found | {"c_s": rupture.open(record).c_s}
