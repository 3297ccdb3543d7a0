"""Slip and fronts on prepared interfaces."""

import numpy as np
from rupture.reports import values

from measure.tables import numbers

SLIPPED = 1e-6  # [m], about f_thres/k_ij
X_TRIGGER = 0.0225  # [m]
FINAL, OFF = (0.7, 0.9), 0.2  # where a front has its final speed [L]; relative
FRONT, SLIP = "front speed [m/s]", "slip speed [m/s]"


def slip_speed(slip):
    """Mean speed of a block over SLIPPED from its rupture on [m/s]; NaN if it slips less."""
    time, moved, start = np.array(slip["time"]), np.array(slip["slip"]), slip["t_rupture"]
    end = np.interp(start, time, moved) + SLIPPED
    reached = np.interp(end, np.maximum.accumulate(moved), time, right=np.nan)
    return SLIPPED / (reached - start)


def pairs_of(fronts):
    """A row for each block that was followed, with the speed of the front that passed it."""
    for row, front, slips in fronts:
        x, v_c = front["x"], values(front["v_c"])
        for slip in slips:
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
