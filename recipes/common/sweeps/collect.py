#!/usr/bin/env python3
"""Collects the points of a sweep in one table: collect.py SWEEP.ini POINTS_FOLDER TABLE.csv

One row per point: its values, its status (and the tool's sentence, if it failed), the columns of
[quantities], and a digest of all that was measured: who reads more than the columns (points_of() in
data/tables.py) can go by the table. Fails if every point failed.
"""

import json
import sys
from pathlib import Path

from data.records import report
from data.tables import write_columns
from data.value import find
from sweeps.points import digest
from sweeps.sweep import names_of_values, read_sweep


def digest_of(result):
    """Not of the programs that it came from: others may give the same."""
    return digest(json.dumps({name: result[name] for name in result if name != "origin"}))


def rows(sweep, result_of):
    """One dict per point; result_of(point) is what its file has."""
    for point in sweep.points:
        result = result_of(point)
        found = {heading: find(result, path) for heading, path in sweep.columns.items()}
        state = {name: result[name] for name in ("status", "sentence")}
        yield {**point.values, **state, **found, "point": point.id, "digest": digest_of(result)}


def main(sweep_file, folder, path):
    sweep = read_sweep(sweep_file)
    table = list(rows(sweep, lambda point: report(Path(folder) / f"{point.id}.json")))
    if table and all(row["status"] == "failed" for row in table):
        sys.exit(
            f"collect.py: every point of {sweep_file} failed. The first: {table[0]['sentence']}"
        )
    values = names_of_values(sweep.points)
    names = [*values, "status", "sentence", *sweep.columns, "point", "digest"]
    write_columns(path, names, table)


if __name__ == "__main__":
    main(*sys.argv[1:])
