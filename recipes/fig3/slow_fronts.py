"""Slow fronts on prepared interfaces, and the slow slip behind them: windows in time, and fits.
Rows have the values of a point, and what was measured in one window.
"""

from collections import namedtuple

import numpy as np

from measure.tables import numbers, rows_of
from measure.conventions import PRIMARY

BLOCKS = 5  # fewer tell nothing about a front
NEAR_ARREST = 3.0  # m/s; slower fronts are near arrest
WITHOUT_NEAR_ARREST = "without fronts near arrest"
FOR_TWO_T_R, FOR_WHOLE_T_R = "followed for up to 2 <t_R>", "followed for whole <t_R>"
# Commands of the chains.
WINDOWS = {PRIMARY: "slow_slip", FOR_TWO_T_R: "two_t_R", FOR_WHOLE_T_R: "whole_t_R"}
OTHER_WINDOWS = [*WINDOWS][1:]


def in_window(row, result, window):
    """The row of a point with what was measured in a window; without values where nothing was."""
    found = result.get(WINDOWS[window]) or {"blocks": 0}
    speed = found.get("speed") or {}
    return row | {
        "blocks": found["blocks"],
        "front speed [m/s]": found.get("front_speed"),
        "slow slip [m/s]": speed.get("mean"),
        "slowest [m/s]": speed.get("min"),
        "fastest [m/s]": speed.get("max"),
        "estimate [m/s]": found.get("estimate"),
        "per_block": found.get("per_block"),
    }


def usable(rows):
    """Fronts that span and slow down, with slow slip at BLOCKS blocks or more."""
    return [row for row in rows if row["type"] == "slow" and row["blocks"] >= BLOCKS]


def fronts(points, window=PRIMARY):
    """The usable rows."""
    return usable([in_window(row, result, window) for row, result in rows_of(points)])


def without_near_arrest(rows):
    return [row for row, v_c in zip(rows, speeds(rows)) if v_c >= NEAR_ARREST]


def speeds(rows):
    """v_c [m/s]"""
    return numbers(rows, "front speed [m/s]")


# y = slope x. R^2 compares with the mean of y, as for a line with an intercept: it says how much
# better the fit is than no dependence on x at all. `exponent`: of a power law through the same
# points, 1 if y is proportional to x; None unless all are positive. `largest`: deviation of a point
# from the line, relative to the line.
ProportionalFit = namedtuple("ProportionalFit", "slope r_squared points exponent largest")


def fit_through_origin(x, y):
    x, y = np.asarray(x, float), np.asarray(y, float)
    if len(x) < 2:
        return None
    slope = (x @ y) / (x @ x)
    residual = ((y - slope * x) ** 2).sum()
    r_squared = 1 - residual / ((y - y.mean()) ** 2).sum()
    are_positive = min(*x, *y) > 0
    exponent = np.polyfit(np.log(x), np.log(y), 1)[0] if are_positive else None
    return ProportionalFit(slope, r_squared, len(x), exponent, np.abs(y / (slope * x) - 1).max())


def measured(fit, *names):
    """{name: value} of the results of a fit; None for each without a fit."""
    return {name: fit and getattr(fit, name) for name in names}
