"""How far ahead of a slow front the shear force is raised: l_0 of Eq. S2,
tau(x) = A f((x - x_0)/l_0) + tau_0.

x_0 is a block at its threshold: the one that ruptures next, when it carries its largest force. Its
profile is the excess tau - tau_0 on it and on the REACH blocks ahead. What f is the paper leaves
open, and so which blocks count and how; METHODS are the ways to measure, each from one profile.

    decay_length.py SEED FOLDER

runs fronts over prepared interfaces, those of Figure 3 D that have the reference parameters. Works
in FOLDER, which is deleted at the end. Prints

    "l_0"       {method: l_0 [m]}, the median of the fronts
    "fronts"    {tau_bar_0: what of_front() says}
"""

import math
from pathlib import Path

import numpy as np
import rupture

from data.scratch import scratch
from events.conventions import PRIMARY

SIGMA_BAR = 0.1
TAU_BARS = [f"{0.005 * n:g}" for n in range(14, 25)]  # 0.07 to 0.12

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
    """Of all blocks of the slow stretch; none if the front has no such stretch or does not span.
    `tau`: the shear force on each block [samples][blocks], tau_0 first."""
    if front["type"] != "slow" or front["slow"] is None:
        return []
    found = [profile(block, front["t_rupture"], time, tau) for block in tips(front)]
    return [excess for excess in found if excess is not None]


def median(numbers):
    """Of those that could be measured; None if none could."""
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


# --- one seed ------------------------------------------------------------------------------


def of_seed(fronts):
    """{method: l_0 [m]}: the median of the fronts of a seed, all of the same weight."""
    return {name: median(front["l_0"][name] for front in fronts) for name in METHODS}


def measure(seed, tau_bar, folder):
    """The front over one prepared interface."""
    start, end, record = (folder / f"{tau_bar}-{name}.h5" for name in ("start", "end", "record"))
    prestress = {"tau_bar": tau_bar, "sigma_bar": SIGMA_BAR}
    rupture.run("prepare", output=start, set={"numerics.seed": seed}, **prestress)
    recorded = {"record": record, "record_every": 2e-5}
    run = rupture.run("restart", start, output=end, until_quiet=True, **recorded)
    front = rupture.analyze("front", record)
    return of_front(front, run.record.time, run.record["tau"])


def main(seed, folder):
    with scratch(Path(folder)) as folder:
        fronts = {tau_bar: measure(int(seed), tau_bar, folder) for tau_bar in TAU_BARS}
    return {"l_0": of_seed(fronts.values()), "fronts": fronts}
