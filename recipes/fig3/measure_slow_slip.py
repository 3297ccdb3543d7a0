#!/usr/bin/env python3
# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Slow slip behind the slow fronts of a sweep, in several windows:

    measure_slow_slip.py FOLDER_OF_PROGRAMS TABLE.csv POINTS_FOLDER OUTPUT.json

`analyze slow-slip` ends the time with the slow stretch, whose ends its options set. None of them is
the rupture of the block of the last slow stencil. So the point is run again, and the record is cut
where that stencil ends: no later one can count to the stretch.
"""

import json
import sys
import tempfile
from pathlib import Path

from data.records import report
from data.replacing import write_whole
from data.tables import read_rows
from events.conventions import Analysis, words_of
from slow_fronts import NARROW, SKIP, WINDOWS
from sweeps.point import WRITERS, run

HALF = 2  # blocks of a stencil on either side of its centre
KEPT = ("blocks", "front_speed", "speed", "estimate")


def last_slow_stencil(front):
    """The block in its centre. The stretch leaves out HALF blocks at either end, where stencils
    touch its surroundings."""
    return front["x"].index(front["slow"]["x_to"]) + HALF


def options_until(front, last):
    """Options with which the slow stretch ends at block `last`, for the blocks inside of it."""
    return {
        "--stencils-at-ends": "slow",
        "--to": front["t_rupture"][last + HALF],
        "--x-from": front["slow"]["x_from"],
        "--x-to": front["slow"]["x_to"],
    }


def short(measured):
    """What the figures need of a report."""
    per_block = {name: measured["per_block"][name] for name in ("x", "speed")}
    return {name: measured[name] for name in KEPT} | {"per_block": per_block}


def windows(analyze, record):
    """{window: slow slip} of a record; none where no block is inside the slow stretch."""
    narrow = analyze("slow-slip", record, words_of(SKIP))
    if narrow["slow"] is None:
        return {}
    front = analyze("front", record, words_of(SKIP))
    last = last_slow_stencil(front)
    found = {NARROW: short(narrow)}
    for name, options in WINDOWS.items():
        words = words_of(SKIP | options | options_until(front, last))
        measured = analyze("slow-slip", record, words)
        if measured["slow"] and measured["slow"]["t_to"] == front["t_rupture"][last]:
            found[name] = short(measured)
    return found


def run_again(programs, commands):
    """The windows of a point, from its commands."""
    with tempfile.TemporaryDirectory(prefix="rupture-windows-") as folder:
        for command in commands:
            if command.split()[0] in WRITERS:
                run(programs, command, "", folder)
        return windows(Analysis(programs), Path(folder) / "record.h5")


def measured(programs, row, points):
    """The row with its windows."""
    if row["type"] != "slow":
        return row | {"windows": {}}
    commands = report(Path(points) / f"{row['point']}.json")["commands"]
    return row | {"windows": run_again(programs, commands)}


def main(programs, table, points, output):
    rows = [measured(programs, row, points) for row in read_rows(table)]
    write_whole(output, json.dumps(rows) + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
