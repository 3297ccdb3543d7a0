"""The slip of a block during an event, as `analyze slip --json` reports it."""

import numpy as np


def peak_speed(slip):
    """Of the fast slip, between two samples [m/s]; None where the block does not stop."""
    if slip["t_arrest"] is None:
        return None
    time, moved = np.array(slip["time"]), np.array(slip["slip"])
    fast = time <= slip["t_arrest"]
    return float(np.max(np.diff(moved[fast]) / np.diff(time[fast])))


def with_peak_speed(slip):
    return slip | {"peak_speed": peak_speed(slip)}


def until(front):
    """The time to which slip is followed [s]: the end of the slow stretch, or the front's arrival
    at the leading edge; None, to the end of the record, where it does not arrive."""
    return front["slow"]["t_to"] if front["slow"] else front["t_rupture"][-1]
