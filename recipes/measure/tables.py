"""CSV tables with one line of names; columns of rows."""

import csv

import numpy as np
from rupture.replacing import replacing

SLOW_STRETCH = {  # name in a report: for readers
    "x_from": "slow from [m]",
    "x_to": "slow to [m]",
    "duration": "duration [s]",
    "speed": "slow speed [m/s]",
    "mean_speed": "mean slow speed [m/s]",
    "slowest": "slowest stencil [m/s]",
    "fast_before": "fast before [m/s]",
    "fast_after": "fast after [m/s]",
}


def rounded(value):
    """Without the noise of the 13th digit."""
    return float(f"{value:.12g}")


def write_table(path, names, rows):
    """Writes all or nothing."""
    with replacing(path) as temporary, temporary.open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(names)
        table.writerows(rows)


def write_columns(path, names, rows):
    """Writes these columns of rows by name; empty where a row has no value."""
    write_table(path, names, ([row.get(name) for name in names] for row in rows))


def write_fronts(path, fronts):
    """Rupture line and speed of fronts: reports of `analyze front` by name."""
    rows = (
        [name, *row]
        for name, front in fronts.items()
        for row in zip(*(front[name] for name in ("x", "t_rupture", "t_front", "v_c")))
    )
    write_table(path, ["front", "x [m]", "t_rupture [s]", "t_front [s]", "v_c [m/s]"], rows)


def write_events(path, events, columns):
    """{heading: function of an event}, when each starts, and what is known of its slow stretch.
    Stencils at which the front runs backwards are in no such stretch."""
    rows = (
        [
            *(of(event) for of in columns.values()),
            event["t_start"],
            event["backward_stencils"],
            *map((event["slow"] or {}).get, SLOW_STRETCH),
        ]
        for event in events
    )
    write_table(path, [*columns, "t_start [s]", "backward stencils", *SLOW_STRETCH.values()], rows)


def read_rows(path):
    """Rows by name; all values are texts."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def numbers(rows, column):
    """One column of such rows; NaN where it is empty."""
    cells = (row.get(column) for row in rows)
    return np.array([np.nan if cell in (None, "") else float(cell) for cell in cells])
