"""The table of a sweep: a row for each point, and what is said of them in the terminal."""

import shutil
from collections import Counter
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from measure.fronts import TYPES
from measure.tables import write_table
from rupture.tools.command_line import in_one_line, plural
from rupture.units import AMOUNT, without_unit
from sweeps.picture import draw
from sweeps.points import DONE, REFUSED, UNFINISHED, most_said

TWO_DECADES = 100
FORMULA = ("=", "@", "+", "-")  # begins one of a spreadsheet, unless it is a number


@dataclass(frozen=True)
class Column:
    name: str
    unit: str  # 1: a dimensionless number; empty: a text
    cells: list  # texts and numbers of JSON; None where there is none
    axis: str = ""  # log or linear; empty: by the numbers

    @property
    def heading(self):
        return self.name if self.unit in ("", "1") else f"{self.name} [{self.unit}]"

    @property
    def texts(self):
        return [text_of(cell) for cell in self.cells]

    @cached_property
    def categories(self):
        """Texts at 0, 1, ... of an axis: those of fronts from arrested to fast, then others in the
        order in which they appear. Empty for numbers."""
        present = [] if self.unit else [text for text in self.texts if text]
        return [text for text in dict.fromkeys(("none", *TYPES, *present)) if text in {*present}]

    @cached_property
    def positions(self):
        """Where each point is along an axis: its number, or the place of its category."""
        if self.unit:
            return np.array(self.cells, dtype=float)
        places = {text: place for place, text in enumerate(self.categories)}
        return np.array([places.get(text, np.nan) for text in self.texts])

    @property
    def scale(self):
        """Logarithmic where positive numbers span two decades, or three or more of them are spaced
        by a factor, unless the sweep says it."""
        places = np.unique(self.positions[np.isfinite(self.positions)])
        if not self.unit or not len(places) or places[0] <= 0:
            return "linear"
        if self.axis:
            return self.axis
        spans = places[-1] >= TWO_DECADES * places[0]
        return "log" if spans or (len(places) > 2 and is_geometric(places)) else "linear"


def is_geometric(places):
    even, even_logs = (
        np.ptp(steps) / steps.mean() for steps in map(np.diff, (places, np.log(places)))
    )
    return even_logs < min(0.1, even)


def text_of(cell):
    if isinstance(cell, str):
        cell = in_one_line(cell)
        is_formula = cell.startswith(FORMULA) and not AMOUNT.fullmatch(cell)
        return f"'{cell}" if is_formula else cell
    return "" if cell is None else str(cell).lower() if isinstance(cell, bool) else str(cell)


def columns_of(sweep, rows):
    """Numbers are in the unit of their column, whatever unit they were written with."""
    values = list(dict.fromkeys(name for point in sweep.points for name in point.values))
    found = []
    for name in (*values, "status", "sentence", *sweep.columns, *sweep.kept, "point"):
        unit, cells = sweep.units.get(name, ""), [row.get(name) for row in rows]
        if name in values and unit:
            cells = [cell and without_unit(cell) for cell in cells]
        is_number = not unit or all(is_one(cell) for cell in cells)
        found.append(Column(name, unit if is_number else "", cells))
    return found


def is_one(cell):
    """Whether it is a number; values along x are none."""
    try:
        return cell is None or float(cell) is not None
    except ValueError:
        return False


def write_csv(path, columns):
    cells = zip(*(column.texts for column in columns))
    write_table(path, [column.heading for column in columns], cells)


def summary(sweep, rows):
    """What is said of them. A quantity without a value is, for instance, the front speed at a block
    that does not exist."""
    counts = Counter(row["status"] for row in rows)
    states = ", ".join(f"{counts[s]} {s}" for s in (DONE, REFUSED, UNFINISHED) if counts[s])
    lines = [f"{sweep.title}: {plural(len(rows), 'point')}: {states}."]
    for status in (REFUSED, UNFINISHED):
        said = Counter(row["sentence"] for row in rows if row["status"] == status)
        lines += [f"{status.capitalize()}:"] * bool(said)
        lines += most_said(said, "; the table has all")
    for heading, path in sweep.columns.items() if counts[DONE] else ():
        if all(row[heading] is None for row in rows):
            lines.append(f"No point has a value for {path} ({heading}).")
    return lines


def write_results(folder, sweep, rows):
    """Writes the table, the picture, and the file as it was run. Returns what there is."""
    stem = folder / sweep.name
    columns = columns_of(sweep, rows)
    write_csv(Path(f"{stem}.csv"), columns)
    Path(f"{stem}.ini").write_text(sweep.text.text, encoding="utf-8")
    if sweep.table:
        shutil.copyfile(sweep.table, f"{stem}-points.csv")
    picture = draw(stem, sweep, columns) or f"Picture: {sweep.name}.png and .pdf"
    return [f"Table: {sweep.name}.csv", picture]
