"""Collects the points of a sweep in one table:

    collect.py SWEEP.ini SEED POINTS_FOLDER CODE TABLE.csv

One row per point: its values, its status (and the tool's sentence, if it failed), the columns of
[quantities], and a digest of all that was measured: who reads more than the columns (points_of() in
data/tables.py) can go by the table. Fails if no point is done.
"""

import sys

from data.tables import write_columns
from data.value import find
from sweeps.points import PointStore, digest_of
from sweeps.sweep import names_of_values, read_sweep


def rows(sweep, store):
    """One dict per point."""
    for point in sweep.points:
        result = store.result(point)
        state = {name: result[name] for name in ("status", "sentence")}
        found = {heading: find(result, path) for heading, path in sweep.columns.items()}
        yield {**point.values, **state, **found, "point": point.id, "digest": digest_of(result)}


def main(sweep_file, seed, folder, code, path):
    sweep = read_sweep(sweep_file, seed)
    table = list(rows(sweep, PointStore(folder, code)))
    if table and not any(row["status"] == "done" for row in table):
        sys.exit(f"collect.py: no point of {sweep_file} is done. The first: {table[0]['sentence']}")
    values = names_of_values(sweep.points)
    names = [*values, "status", "sentence", *sweep.columns, "point", "digest"]
    write_columns(path, names, table)
