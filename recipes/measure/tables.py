"""CSV tables with one line of names: those that the figures write and read again, as columns, and
those of sweeps (collect.py), as rows whose cells may be empty."""

import csv
from pathlib import Path

import numpy as np

from chains.chain import is_expression
from chains.expressions import as_text
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


def read_table(path):
    """Reads columns by name; as numbers if all cells are numbers."""
    with open(path, newline="", encoding="utf-8") as file:
        names, *rows = csv.reader(file)
    return {name: as_numbers(column) for name, column in zip(names, zip(*rows))}


def as_numbers(column):
    try:
        return np.array(column, dtype=float)
    except ValueError:
        return np.array(column)


def read_rows(path):
    """Rows by name; all values are texts."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def rows_of(points):
    """Points of chains (chains/results.py) as pairs: a row, which has the values as they are
    written, the status, the name of the point and the type of its front; and all that was measured.
    Both are also those of the points that it comes from."""
    return [pair_of(point) for point in points]


def pair_of(point):
    texts: dict = {}
    measured: dict = {}
    sums: dict = {}
    for one, result in zip(reversed(point.lineage), reversed(point.results)):
        texts |= one["values"]
        measured |= result["reports"]
        sums |= result["checksums"]
    row = {n: as_text(point[n]) if is_expression(t) else t for n, t in texts.items()}
    row |= {"status": point.status, "point": Path(point.lineage[0]["path"]).stem}
    row["type"] = next((of["type"] for of in measured.values() if of and "type" in of), "")
    return row, measured | {"sentence": point.sentence, "checksums": sums}


def numbers(rows, column):
    """One column of such rows; NaN where it is empty."""
    cells = (row.get(column) for row in rows)
    return np.array([np.nan if cell in (None, "") else float(cell) for cell in cells])


def values(numbers):
    """A list from a report as an array, NaN where it says null."""
    return np.array([np.nan if number is None else number for number in numbers])
