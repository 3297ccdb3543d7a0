"""How far ahead of a slow front the shear force is raised: l_0 of Eq. S2,
tau(x) = A f((x - x_0)/l_0) + tau_0.

x_0 is a block at its threshold: the one that ruptures next, when it carries its largest force. Its
profile is the excess tau - tau_0 on it and on the REACH blocks ahead. What f is the paper leaves
open, and so which blocks count and how; METHODS are the ways to measure, each from one profile.
"""

import math

import numpy as np
import rupture

from measure.fronts import PRIMARY

REACH = 8  # blocks ahead of the tip; the leading edge is farther away
FITTED = (0, 3)  # blocks ahead of the tip, in the primary method


# --- one profile ---------------------------------------------------------------------------


def exponential(first, last):
    """l_0/dx of an exponential through these blocks ahead of the tip (0 is x_0 itself): a straight
    line through the logarithms of the excess. None where there is no decay to fit."""

    def fit(excess):
        blocks, part = np.arange(first, last + 1), excess[first : last + 1]
        if np.any(part <= 0):
            return None
        slope = np.polyfit(blocks, np.log(part), 1)[0]
        return float(-1 / slope) if slope < 0 else None

    return fit


def distance_to_1_over_e(excess):
    """l_0/dx as the distance at which the excess has fallen to 1/e of that at x_0; between blocks
    on straight lines. None if it lies farther ahead."""
    ratio = excess / excess[0]
    below = np.flatnonzero(ratio <= 1 / math.e)
    if not len(below):
        return None
    after = below[0]
    return float(np.interp(-1 / math.e, -ratio[[after - 1, after]], [after - 1, after]))


METHODS = {
    PRIMARY: exponential(*FITTED),
    "5 blocks ahead": exponential(0, 5),
    f"{REACH} blocks ahead": exponential(0, REACH),
    "without the block at the tip": exponential(1, 4),
    "fall to 1/e": distance_to_1_over_e,
}


# --- one front -----------------------------------------------------------------------------


def tips(front):
    """The blocks of the slow stretch that count as x_0."""
    x = np.array(front["x"])
    slow = (x >= front["slow"]["x_from"]) & (x <= front["slow"]["x_to"])
    return [block for block in np.flatnonzero(slow) if block + REACH < len(x)]


def profile(block, t_rupture, time, tau):
    """The excess [N] from block x_0 on, when its force is largest between the rupture of the block
    behind and its own; None if it does not rupture after that one, or no sample lies between."""
    behind, own = t_rupture[block - 1], t_rupture[block]
    if behind is None or own is None:
        return None
    between = np.flatnonzero((time >= behind) & (time <= own))
    if not len(between):
        return None
    sample = between[np.argmax(tau[between, block])]
    return (tau[sample] - tau[0])[block : block + REACH + 1]


def profiles(front, time, tau):
    """The stress ahead of the front for each block of its slow stretch; an empty list if the front
    has none or does not span. `tau`: the shear force on each block [samples][blocks], tau_0
    first."""
    if front["type"] != "slow" or front["slow"] is None:
        return []
    found = [profile(block, front["t_rupture"], time, tau) for block in tips(front)]
    return [excess for excess in found if excess is not None]


def median(numbers):
    """The median of the numbers that could be measured; None if none could."""
    measured = [number for number in numbers if number is not None]
    return float(np.median(measured)) if measured else None


def of_front(front, time, tau):
    """What a report has of one front: l_0 [m] by each method, and the median profile, 1 at x_0."""
    dx = front["x"][1] - front["x"][0]
    found = profiles(front, time, tau)
    lengths = {name: median(map(method, found)) for name, method in METHODS.items()}
    shape = np.median([excess / excess[0] for excess in found], axis=0) if found else None
    return {
        "profiles": len(found),
        "l_0": {name: in_dx and in_dx * dx for name, in_dx in lengths.items()},
        "x - x_0": (dx * np.arange(REACH + 1)).tolist(),
        "excess": None if shape is None else shape.tolist(),
    }


def decay_of_front(record):
    """What of_front() says of one front over a prepared interface."""
    front, series = rupture.analyze("front", record), rupture.open(record)
    return of_front(front, series.time, series["tau"])
