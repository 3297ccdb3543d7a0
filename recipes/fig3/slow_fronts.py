"""Slow fronts on prepared interfaces, and the slow slip behind them: windows in time, and fits.
Rows have the parameters of an interface by name, and what was measured.
"""

from collections import namedtuple

import numpy as np
from rupture.once import each, run

import maps
from claims.resampling import interval_by_runs
from events import CROSSINGS
from measure.tables import numbers, rounded
from measure.ways import PRIMARY, WAYS, others

RECORDED = f"--record record.h5 --record-every 2e-5 {CROSSINGS}"
BLOCKS = 5  # fewer tell nothing about a front
NEAR_ARREST = 3.0  # m/s; slower fronts are near arrest
WITHOUT_NEAR_ARREST = "without fronts near arrest"
WINDOWS = {  # options of `analyze slow-slip`
    PRIMARY: "",
    "followed for up to 2 <t_R>": "--longest 2 --shortest 1",
    "followed for whole <t_R>": "--shortest 1",
    **{way: WAYS[way] for way in others(WAYS)},
}


# --- fronts ------------------------------------------------------------------------------------


def as_typed(parameters):
    """The parameters with 12 digits."""
    return {
        name: value if isinstance(value, str) else rounded(value)
        for name, value in parameters.items()
    }


def option(name, value):
    text = value if isinstance(value, str) else f"{value:.12g}"
    return f"--set {name}={text}" if "." in name else f"--{name} {text}"


def words_of(parameters):
    """The options of `prepare` for these parameters."""
    return " ".join(option(*of) for of in parameters.items())


def record_of(parameters, kept=()):
    """The record of a front on a prepared interface."""
    return maps.record_of(words_of(parameters), RECORDED, kept)


def front_of(variant, parameters):
    """The row of a front, with its slow slip in all windows."""
    record = record_of(parameters, ["record.h5"])
    windows = {
        name: run(f"analyze slow-slip {record} {options}") for name, options in WINDOWS.items()
    }
    of_front = {"type": windows[PRIMARY].type, "point": record.work.own, "windows": windows}
    return {"variant": variant, **parameters, **of_front}


def rows_of(variants, parameters, title, measure=front_of):
    """The rows of the fronts of all variants; `parameters` is a function of what each changes."""
    points = [(name, parameters(**of)) for name, several in variants.items() for of in several]
    return [row for _, row in each(measure, points, title)]


# --- rows --------------------------------------------------------------------------------------


def in_window(row, window=PRIMARY):
    """The row with what was measured in a window; without values where nothing was."""
    found = row["windows"][window]
    speed = found.speed or {}
    return row | {
        "blocks": found.blocks,
        "front speed [m/s]": found.front_speed,
        "slow slip [m/s]": speed.get("mean"),
        "slowest [m/s]": speed.get("min"),
        "fastest [m/s]": speed.get("max"),
        "estimate [m/s]": found.estimate,
        "per_block": found.per_block,
    }


def usable(rows):
    """Fronts that span and slow down, with slow slip at BLOCKS blocks or more."""
    return [row for row in rows if row["type"] == "slow" and row["blocks"] >= BLOCKS]


def by_way(rows):
    """{way to measure: usable rows}"""
    found = {
        name: usable([in_window(row, name) | {"type": row["windows"][name].type} for row in rows])
        for name in WINDOWS
    }
    fast_enough = [row for row in found[PRIMARY] if row["front speed [m/s]"] >= NEAR_ARREST]
    return found | {WITHOUT_NEAR_ARREST: fast_enough}


def speeds(rows):
    """v_c [m/s]"""
    return numbers(rows, "front speed [m/s]")


# --- fits --------------------------------------------------------------------------------------

# y = slope x. R^2 compares with the mean of y, as for a line with an intercept: it says how much
# better the fit is than no dependence on x at all. `exponent`: of a power law through the same
# points, 1 if y is proportional to x; NaN unless all are positive. `largest`: deviation of a point
# from the line, relative to the line. `offset`: y where x is 0, of the line with an intercept.
ProportionalFit = namedtuple("ProportionalFit", "slope r_squared exponent largest offset x y")
NO_FIT = ProportionalFit(np.nan, np.nan, np.nan, np.nan, np.nan, (), ())


def fit_through_origin(x, y):
    x, y = np.asarray(x, float), np.asarray(y, float)
    if len(x) < 2:
        return NO_FIT
    slope = (x @ y) / (x @ x)
    residual = ((y - slope * x) ** 2).sum()
    r_squared = 1 - residual / ((y - y.mean()) ** 2).sum()
    exponent = exponent_of(np.stack([x, y], axis=1)) if min(*x, *y) > 0 else np.nan
    largest, offset = np.abs(y / (slope * x) - 1).max(), np.polyfit(x, y, 1)[1]
    return ProportionalFit(slope, r_squared, exponent, largest, offset, x, y)


def exponent_of(points):
    """Of a power law through rows of x and y; NaN if all x are the same."""
    x, y = np.log(points.T)
    x, y = x - x.mean(), y - y.mean()
    return x @ y / (x @ x) if x.any() else np.nan


def exponent_interval(fit):
    """90 % interval, for which fronts are drawn."""
    found = interval_by_runs(exponent_of, [[point] for point in zip(fit.x, fit.y)])
    return [*found]
