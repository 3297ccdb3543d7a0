# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Slow fronts on prepared interfaces, and the slow slip behind them: how it is measured, and seeds
as units of claims. Rows are those of a sweep's table with what measure_slow_slip.py adds."""

from pathlib import Path

from data.records import report
from data.tables import numbers
from events.conventions import PRIMARY
from maps.front_map import SKIP_BELOW_X

BLOCKS = 5  # fewer tell nothing about a front
NEAR_ARREST = 3.0  # m/s; slower fronts are near arrest
WITHOUT_NEAR_ARREST = "without fronts near arrest"
SKIP = {"--skip-below-x": SKIP_BELOW_X}
FOR_TWO_T_R, FOR_WHOLE_T_R = "followed for up to 2 <t_R>", "followed for whole <t_R>"
NARROW = "stencils at the ends to neither"  # the programs' own rule; its time ends earlier
# Options of `analyze slow-slip`. In all of these the time ends when the block of the last slow
# stencil ruptures, and the blocks are those at least two from both ends of the slow stretch.
WINDOWS: dict[str, dict] = {
    PRIMARY: {},
    FOR_TWO_T_R: {"--longest": 2, "--shortest": 1},
    FOR_WHOLE_T_R: {"--shortest": 1},
}
OTHER_WINDOWS = [*WINDOWS, NARROW][1:]
WHERE = (
    "Blocks of prepared interfaces: those of the slow stretch without the two at either end. Time:"
    " from H/c_s after the block's rupture for <t_R>, or until the front ruptures the block of"
    " the last slow stencil if that is earlier (at least <t_R>/2); speed between 20 % and 80 % of"
    " the slip in this time. R^2 against the mean of the measured values."
)


def in_window(row, window):
    """The row with what was measured in a window; without values where nothing was."""
    found = row["windows"].get(window) or {"blocks": 0}
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


def fronts(path, window=PRIMARY):
    """The usable rows of a file of measure_slow_slip.py."""
    return usable([in_window(row, window) for row in report(path)])


def too_short(path):
    """How many slow fronts of such a file are not usable."""
    slow = [row for row in report(path) if row["type"] == "slow"]
    return len(slow) - len(fronts(path))


def without_near_arrest(rows):
    return [row for row, v_c in zip(rows, speeds(rows)) if v_c >= NEAR_ARREST]


def speeds(rows):
    """v_c [m/s]"""
    return numbers(rows, "front speed [m/s]")


# --- seeds ---------------------------------------------------------------------------------


def name_and_seed(path):
    """("slow_slip", 2) of .../slow_slip-seed-2-windows.json; without seed it is 1."""
    sweep, _, seed = Path(path).name.removesuffix("-windows.json").partition("-seed-")
    return sweep, int(seed or 1)


def of_seeds(paths, conventions, sweeps):
    """The units: {seed: {convention: [case]}}, of seeds of which the files of all sweeps are there.
    `conventions`: a function of these files, in the order of `sweeps`."""
    found = {name_and_seed(path): path for path in paths}
    files = {seed: [found.get((sweep, seed)) for sweep in sweeps] for _, seed in sorted(found)}
    return {
        f"seed {seed}": conventions(*of_seed)
        for seed, of_seed in sorted(files.items())
        if None not in of_seed
    }
