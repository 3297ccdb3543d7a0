"""Says what a user's sweep would compute, and what came out.

Collects the points that there are: writes NAME.csv, NAME.hdf5 (the same columns and units) and, for
one or two varied values, NAME.png and NAME.pdf beside the plan. Numbers are written with all their
digits; equal tables are equal bytes. A point that is not there is `unfinished`.
"""

import os
import sys
from collections import Counter
from dataclasses import dataclass
from functools import cached_property

import h5py
import numpy as np

from rupture.replacing import replacing
from data.tables import write_table
from maps.front_map import TYPES
from sweeps.collect import rows
from sweeps.picture import draw
from sweeps.points import UNFINISHED, PointStore
from sweeps.sweep import names_of_values, read_sweep
from sweeps.values import without_unit

SHOWN = 5  # sentences of failed points
TWO_DECADES = 100
NOT_REACHED = "it was not reached, or its process was ended"


# --- the table ---------------------------------------------------------------------------------


@dataclass(frozen=True)
class Column:
    name: str
    unit: str  # 1: a dimensionless number; empty: a text
    cells: list  # texts and numbers of JSON; None where there is none

    @property
    def heading(self):
        return self.name if self.unit in ("", "1") else f"{self.name} [{self.unit}]"

    @property
    def texts(self):
        return [text_of(cell) for cell in self.cells]

    @property
    def numbers(self):
        return np.array([np.nan if cell is None else float(cell) for cell in self.cells])

    @cached_property
    def categories(self):
        """Texts at 0, 1, ... of an axis: those of fronts from arrested to fast, then others in the
        order in which they appear. Empty for numbers."""
        present = [] if self.unit else [text for text in self.texts if text]
        return [text for text in dict.fromkeys(("none", *TYPES, *present)) if text in present]

    @cached_property
    def positions(self):
        """Of each point along an axis."""
        if self.unit:
            return self.numbers
        places = {text: place for place, text in enumerate(self.categories)}
        return np.array([places.get(text, np.nan) for text in self.texts])

    @property
    def scale(self):
        """Logarithmic where positive numbers span two decades, or four or more of them are spaced
        by a factor."""
        places = np.unique(self.positions[np.isfinite(self.positions)])
        if not self.unit or not len(places) or places[0] <= 0:
            return "linear"
        spans = places[-1] >= TWO_DECADES * places[0]
        return "log" if spans or (len(places) > 3 and is_geometric(places)) else "linear"


def text_of(cell):
    if cell is None:
        return ""
    return str(cell).lower() if isinstance(cell, bool) else str(cell)


def is_geometric(places):
    even, even_logs = (
        np.ptp(steps) / steps.mean() for steps in map(np.diff, (places, np.log(places)))
    )
    return even_logs < min(0.1, even)


def write_csv(path, columns):
    rows = zip(*(column.texts for column in columns))
    write_table(path, [column.heading for column in columns], rows)


def fixed(texts):
    """UTF-8 of the length of the longest one."""
    encoded = [text.encode() for text in texts]
    return np.array(encoded, h5py.string_dtype("utf-8", max([1, *map(len, encoded)])))


def set_attribute(item, name, text):
    item.attrs[name] = fixed([text]).reshape(())


def write_hdf5(path, title, columns):
    with replacing(path) as part, h5py.File(part, "w") as file:
        set_attribute(file, "title", title)
        for column in columns:
            cells = column.numbers if column.unit else fixed(column.texts)
            dataset = file.create_dataset(column.name, data=cells, track_times=False)
            set_attribute(dataset, "unit", column.unit or "1")


# --- what is said ------------------------------------------------------------------------------


def plural(number, noun):
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def preview(plan, folder_of_tools, results, code):
    """`code`: fingerprint of the sources or programs."""
    sweep, store = read_sweep(plan), PointStore(results / "data/points", code)
    to_compute = [point for point in sweep.points if store.result(point) is None]
    done = len(sweep.points) - len(to_compute)
    count = plural(len(sweep.points), "point")
    print(f"{sweep.title}: {count}: {done} done, {len(to_compute)} to compute")
    if to_compute:
        print("The first of these (its files are deleted afterwards):")
        for command in to_compute[0].commands.values():
            print(f"  {folder_of_tools}/{command}")


def result_of(point, store):
    """The result of the point. Paths in a sentence are those of this folder."""
    sentence = store.stored(point).get("sentence", NOT_REACHED)
    result = store.result(point) or {"status": UNFINISHED}
    return result | {"sentence": sentence.replace(f"{os.getcwd()}/", "")}


def columns_of(sweep, table):
    """Numbers are in the unit of their column, whatever unit they were written with."""
    values = names_of_values(sweep.points)
    names = [*values, *sweep.columns, "status", "sentence", "point"]
    for row in table:
        row |= {n: without_unit(row[n]) for n in values if n in row and sweep.units.get(n)}
    return [Column(n, sweep.units.get(n, ""), [row.get(n) for row in table]) for n in names]


def count_computed(sweep, table, store, started):
    """How many results are younger than `started` [s]."""
    finished = (p for p, row in zip(sweep.points, table) if row["status"] != UNFINISHED)
    return sum(store.path(point).stat().st_mtime >= started for point in finished)


def print_sentences(table, status):
    said = Counter(row["sentence"] for row in table if row["status"] == status)
    if said:
        print(f"{status.capitalize()}:")
    for sentence, times in said.most_common(SHOWN):
        print(f"  {times} x {sentence}")
    if len(said) > SHOWN:
        print(f"  and {plural(len(said) - SHOWN, 'other sentence')}; the table has all")


def print_without_value(sweep, table):
    """Such as the front speed at a block that is not there."""
    for heading, path in sweep.columns.items():
        if all(row[heading] is None for row in table):
            print(f"No point has a value of {path} ({heading}).")


def print_summary(sweep, table, computed):
    counts = Counter(row["status"] for row in table)
    states = ", ".join(f"{counts[s]} {s}" for s in ("done", "failed", "unfinished") if counts[s])
    there = len(table) - counts["unfinished"] - computed
    print(f"\n{sweep.title}: {plural(len(table), 'point')}: {states}.")
    print(f"Computed now: {computed}; there before: {there}.")
    for status in ("failed", "unfinished"):
        print_sentences(table, status)
    if counts["done"]:
        print_without_value(sweep, table)
    return counts["unfinished"]


def report_sweep(plan, results, code, started):
    """The exit code: 1 if points are unfinished. `code`: fingerprint of the sources or programs;
    `started`: when computing began [s since 1970]."""
    sweep, store = read_sweep(plan), PointStore(results / "data/points", code)
    table = list(rows(sweep, lambda point: result_of(point, store)))
    columns = columns_of(sweep, table)
    write_csv(plan.with_suffix(".csv"), columns)
    write_hdf5(plan.with_suffix(".hdf5"), sweep.title, columns)
    unfinished = print_summary(sweep, table, count_computed(sweep, table, store, started))
    stem = plan.resolve().with_suffix("")
    print(f"Table: {stem}.csv and .hdf5", flush=True)  # before anything of Matplotlib
    print(draw(stem, sweep, columns) or f"Picture: {stem}.png and .pdf", flush=True)
    if unfinished:
        print("The same command tries unfinished points again.", file=sys.stderr)
    return 1 if unfinished else 0
