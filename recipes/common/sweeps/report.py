"""Says what a user's sweep would compute, and what came out.

Collects the points that there are: writes NAME.csv, NAME.hdf5 and, for one or two varied values,
NAME.png and NAME.pdf beside the plan. A point that is not there is `unfinished`.
"""

import os
import sys
from collections import Counter
from pathlib import Path

from sweeps.collect import rows
from sweeps.picture import SUFFIXES, draw
from sweeps.plural import plural
from sweeps.point_store import PointStore
from sweeps.sweep import names_of_values, read_sweep
from sweeps.table import Column, write_csv, write_hdf5
from sweeps.values import without_unit

SHOWN = 5  # sentences of failed points
NOT_REACHED = "it was not reached, or its process was ended"


def preview(plan, folder_of_tools, results, code):
    """`code`: fingerprint of the sources or programs."""
    sweep, store = read_sweep(plan), PointStore(results / "data/points", code)
    to_compute = [point for point in sweep.points if store.result(point) is None]
    there = len(sweep.points) - len(to_compute)
    count = plural(len(sweep.points), "point")
    print(f"{sweep.title}: {count}, {there} there, {len(to_compute)} to compute.")
    if to_compute:
        print("The first of these (its files are deleted afterwards):")
        for command in to_compute[0].commands.values():
            print(f"  {folder_of_tools}/{command}")


def result_of(point, store):
    """The result of the point. Paths in a sentence are those of this folder."""
    result = store.result(point)
    if result is None:
        result = {"status": "unfinished", "sentence": store.crash(point) or NOT_REACHED}
    return result | {"sentence": result["sentence"].replace(f"{os.getcwd()}/", "")}


def columns_of(sweep, table):
    """Numbers are in the unit of their column, whatever unit they were written with."""
    values = names_of_values(sweep.points)
    names = [*values, *sweep.columns, "status", "sentence", "point"]
    for row in table:
        row |= {n: without_unit(row[n]) for n in values if n in row and sweep.units.get(n)}
    return [Column(n, sweep.units.get(n, ""), [row.get(n) for row in table]) for n in names]


def count_computed(sweep, table, store, started):
    """How many results are younger than `started` [s]."""
    finished = (p for p, row in zip(sweep.points, table) if row["status"] != "unfinished")
    return sum(store.path(point).stat().st_mtime >= started for point in finished)


def print_sentences(table, status):
    said = Counter(row["sentence"] for row in table if row["status"] == status)
    if said:
        print(f"{status.capitalize()}:")
    for sentence, times in said.most_common(SHOWN):
        print(f"  {times} x {sentence}")
    if len(said) > SHOWN:
        print(f"  and {plural(len(said) - SHOWN, 'other sentence')}; the table has them all")


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


def picture(stem, sweep, columns):
    """A line that says why the picture cannot be drawn, if so. The table is there already."""
    try:
        no_picture = draw(stem, sweep, columns)
    except Exception as error:  # of Matplotlib, any
        for suffix in SUFFIXES:
            Path(f"{stem}{suffix}").unlink(missing_ok=True)
        no_picture = f"No picture: {(str(error) or type(error).__name__).splitlines()[0]}"
    return no_picture or f"Picture: {stem}.png and .pdf"


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
    print(picture(stem, sweep, columns), flush=True)
    if unfinished:
        print("The same command tries unfinished points again.", file=sys.stderr)
    return 1 if unfinished else 0
