#!/usr/bin/env python3
"""Collects the points of a sweep in one table: collect.py SWEEP.ini POINTS_FOLDER TABLE.csv

One row per point: its values, its status (and the tool's sentence, if it failed), the columns that
the sweep's [table] names. Fails if every point failed.
"""

import csv
import json
import os
import sys
from pathlib import Path

from common.sweeps import read_sweep


def look_up(report, path):
    """front.slow.speed; null, and what is not there, is an empty cell."""
    for key in path.split("."):
        if report is None:
            return None
        report = report[int(key)] if isinstance(report, list) else report.get(key)
    return report


def names_of_values(points):
    return list(dict.fromkeys(name for point in points for name in point.values))


def rows(sweep, folder):
    for point in sweep.points:
        report = json.loads((Path(folder) / f"{point.id}.json").read_text(encoding="utf-8"))
        found = {heading: look_up(report, path) for heading, path in sweep.columns.items()}
        state = {name: report[name] for name in ("status", "sentence")}
        yield {**point.values, **state, **found, "point": point.id}


def write(path, names, table):
    temporary = Path(f"{path}.part")
    with temporary.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, names, restval="")
        writer.writeheader()
        writer.writerows(table)
    os.replace(temporary, path)


def main(sweep_file, folder, path):
    sweep = read_sweep(sweep_file)
    table = list(rows(sweep, folder))
    if table and all(row["status"] == "failed" for row in table):
        sys.exit(
            f"collect.py: every point of {sweep_file} failed. The first: {table[0]['sentence']}"
        )
    names = [*names_of_values(sweep.points), "status", "sentence", *sweep.columns, "point"]
    write(path, names, table)


if __name__ == "__main__":
    main(*sys.argv[1:])
