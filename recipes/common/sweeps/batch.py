#!/usr/bin/env python3
"""Computes some points of a sweep, one after the other:

    batch.py FOLDER_OF_TOOLS SWEEP.ini POINTS_FOLDER CODE OUTPUT ID...

Each point is kept when it is done (point_store.py), so a batch that is interrupted goes on where it
was, and points that are there are not computed again. A point that crashes does not keep the others
from being computed. OUTPUT is written when all are there: a line for each, with a digest of its
result.
"""

import json
import signal
import sys

from rupture.replacing import replacing
from sweeps.point import INTERRUPTIONS, Crash, compute
from sweeps.point_store import PointStore, digest
from sweeps.sweep import read_sweep


def result_of(point, store, folder_of_tools):
    """The stored result, or else the one computed now; None after a crash."""
    result = store.result(point)
    if result is None:
        try:
            result = compute(folder_of_tools, point)
        except Crash as crash:
            print(f"batch.py: {crash}", file=sys.stderr)
            store.note_crash(point, str(crash))
            return None
        store.save(point, result)
    return result


def main(folder_of_tools, sweep, points_folder, code, output, *ids):
    for number in INTERRUPTIONS:  # so that the point's folder is deleted
        signal.signal(number, lambda which, _: sys.exit(128 + which))
    store = PointStore(points_folder, code)
    points = {point.id: point for point in read_sweep(sweep).points}
    results = {each: result_of(points[each], store, folder_of_tools) for each in ids}
    if None in results.values():
        sys.exit(1)
    with replacing(output) as part, part.open("w", encoding="utf-8") as file:
        for each, result in results.items():
            print(digest(json.dumps(result)), each, file=file)


if __name__ == "__main__":
    main(*sys.argv[1:])
