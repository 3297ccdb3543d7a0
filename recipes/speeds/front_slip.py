"""Slip and fronts on prepared interfaces, as points of fronts.ini report them."""

import numpy as np

from measure.tables import numbers, values
from measure.fronts import front_spans

SLIPPED = 1e-6  # [m], about f_thres/k_ij
X_TRIGGER = 0.0225  # [m]
FINAL, OFF = (0.7, 0.9), 0.2  # where a front has its final speed [L]; relative
FOLLOWED = ("slip_1", "slip_2", "slip_3", "slip_4")
FRONT, SLIP = "front speed [m/s]", "slip speed [m/s]"


def slip_speed(slip):
    """Mean speed of a block over SLIPPED from its rupture on [m/s]; NaN if it slips less."""
    time, moved, start = np.array(slip["time"]), np.array(slip["slip"]), slip["t_rupture"]
    end = np.interp(start, time, moved) + SLIPPED
    reached = np.interp(end, np.maximum.accumulate(moved), time, right=np.nan)
    return SLIPPED / (reached - start)


def spanning(points):
    """(row, report) of the points whose front spans."""
    return [point for point in points if "front" in point[1] and front_spans(point[1]["front"])]


def pairs_of(points):
    """A row for each block that was followed, with the speed of the front that passed it."""
    for row, found in points:
        x, v_c = found["front"]["x"], values(found["front"]["v_c"])
        for slip in (found[name] for name in FOLLOWED):
            pair = {"x [m]": slip["x"], FRONT: v_c[x.index(slip["x"])], SLIP: slip_speed(slip)}
            if pair[FRONT] > 0 and pair[SLIP] > 0:
                yield row | pair


def exponent(rows, of, over):
    """The exponent of the power law between two columns."""
    return np.polyfit(np.log(numbers(rows, over)), np.log(numbers(rows, of)), 1)[0]


def smoothed(front):
    """Positions and speeds beyond the trigger, medians of five stencils."""
    x, v_c = np.array(front["x"]), values(front["v_c"])
    beyond = (x >= front["criteria"]["skip_below_x"]) & np.isfinite(v_c)
    windows = np.lib.stride_tricks.sliding_window_view(v_c[beyond], 5)
    return x[beyond][2:-2], np.median(windows, axis=1)


def transient(front):
    """How far beyond the trigger the speed is off the final one for the last time [mm]."""
    x, v_c = smoothed(front)
    first, last = (part * front["L"] for part in FINAL)
    final = np.median(v_c[(x >= first) & (x <= last)])
    off = x[(x < first) & (np.abs(v_c / final - 1) > OFF)]
    return (off[-1] - X_TRIGGER) * 1e3 if len(off) else 0.0
