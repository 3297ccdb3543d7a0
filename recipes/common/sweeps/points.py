#!/usr/bin/env python3
"""Computes some points of a sweep, one after the other:

    points.py FOLDER_OF_TOOLS SWEEP.ini SEED POINTS_FOLDER CODE OUTPUT ID...

The commands of a point run in an empty folder, which is deleted at the end. The result has the
commands, the checksum of every file that they wrote, what those with --json reported, under their
names, and a status: done, failed with the tool's sentence, or unfinished if a program crashed.

Each result is kept when it is there, in results/data/points/ID.json, with its `origin`: a digest
of the sources (or programs), of this file and chains/commands.py, and of the base. Only points
without a result of this origin, and unfinished ones, are computed, so an interrupted batch
continues where it was, and a crash does not keep the other points from being computed. OUTPUT is
written when none is unfinished: a line for each, with a digest of its result.
"""

import hashlib
import json
import shlex
import signal
import sys
import tempfile
from contextlib import suppress
from functools import cache
from pathlib import Path

from chains import commands
from chains.commands import INTERRUPTIONS, UNFINISHED, as_run, checksums_in, fault, run
from rupture.replacing import replacing, write_whole
from sweeps.sweep import read_sweep

NOT_REACHED = "it was not reached, or its process was ended"
COMPUTED_BY = "".join(
    Path(file).read_text(encoding="utf-8") for file in (__file__, commands.__file__)
)


# --- computing ---------------------------------------------------------------------------------


def compute(folder_of_tools, point):
    """The result of a point."""
    result: dict = {"commands": list(point.commands.values()), "status": "done", "sentence": ""}
    with tempfile.TemporaryDirectory(prefix="rupture-point-") as folder:
        for name, command in point.commands.items():
            done = run(folder_of_tools, as_run(command), folder, {point.base: point.base})
            if done.returncode:
                result |= fault(command, done)
                break
            if "--json" in shlex.split(command):
                reports = [json.loads(line) for line in done.stdout.splitlines()]
                result[name] = reports if "--also" in shlex.split(command) else reports[0]
        result["checksums"] = checksums_in(folder)
    return result


# --- keeping -----------------------------------------------------------------------------------


def digest(*parts):
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:16]


@cache
def content_of(base):
    checksum = Path(f"{base}.sum")
    if checksum.exists():
        return checksum.read_text(encoding="utf-8")
    return hashlib.sha256(Path(base).read_bytes()).hexdigest()


def digest_of(result):
    return digest(json.dumps(result))


class PointStore:
    """Results in a folder. `code`: fingerprint of the sources or programs."""

    def __init__(self, folder, code):
        self.folder, self.code = Path(folder), code

    def path(self, point):
        return self.folder / f"{point.id}.json"

    def origin(self, point):
        return digest(self.code, COMPUTED_BY, content_of(point.base) if point.base else "")

    def result(self, point):
        """Without its origin. A point that has none of this origin is unfinished, too."""
        with suppress(OSError, ValueError, AttributeError, KeyError, TypeError):
            stored = json.loads(self.path(point).read_text(encoding="utf-8"))
            if stored.pop("origin") == self.origin(point):
                return stored
        return {"status": UNFINISHED, "sentence": NOT_REACHED}

    def unfinished(self, points):
        return [point for point in points if self.result(point)["status"] == UNFINISHED]

    def save(self, point, result):
        write_whole(self.path(point), json.dumps({**result, "origin": self.origin(point)}) + "\n")


# --- a batch -----------------------------------------------------------------------------------


def main(folder_of_tools, sweep, seed, points_folder, code, output, *ids):
    for number in INTERRUPTIONS:  # so that the point's folder is deleted
        signal.signal(number, lambda which, _: sys.exit(128 + which))
    store = PointStore(points_folder, code)
    points = {point.id: point for point in read_sweep(sweep, seed).points}
    batch = [points[each] for each in ids]
    for point in batch:
        if store.unfinished([point]):  # still: another batch may have it, too
            store.save(point, compute(folder_of_tools, point))
    if crashed := store.unfinished(batch):
        sys.exit("\n".join(f"points.py: {store.result(point)['sentence']}" for point in crashed))
    with replacing(output) as part, part.open("w", encoding="utf-8") as file:
        for point in batch:
            print(digest_of(store.result(point)), point.id, file=file)


if __name__ == "__main__":
    main(*sys.argv[1:])
