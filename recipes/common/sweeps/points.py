#!/usr/bin/env python3
"""Computes some points of a sweep, one after the other:

    points.py FOLDER_OF_TOOLS SWEEP.ini POINTS_FOLDER CODE OUTPUT ID...

The commands of a point run in an empty folder, which is deleted at the end. The result has the
commands, the checksum of every file that they wrote, what those with --json reported, under their
names, and a status: done, failed with the tool's sentence, or unfinished if a program crashed.

Each result is kept when it is there, in results/data/points/ID.json, with its `origin`: a digest
of the sources (or programs), of this file and of the base. Only points without a result of this
origin, and unfinished ones, are computed, so a batch that is interrupted goes on where it was, and
a crash does not keep the other points from being computed. OUTPUT is written when none is
unfinished: a line for each, with a digest of its result.
"""

import hashlib
import json
import os
import shlex
import signal
import subprocess
import sys
import tempfile
from functools import cache
from pathlib import Path

from rupture.replacing import replacing, write_whole
from sweeps.sweep import read_sweep

USER_ERRORS = (1, 2)  # exit codes with which a tool says that the request cannot be met
UNFINISHED = "unfinished"
INTERRUPTIONS = (signal.SIGINT, signal.SIGTERM)
WRITERS = ("load", "modify-phi", "prepare", "restart")
COMPUTED_BY = Path(__file__).read_text(encoding="utf-8")


# --- computing ---------------------------------------------------------------------------------


def arguments_of(command, base):
    """The base is a path from anywhere. Programs that write files note their checksums, too."""
    words = [os.path.abspath(word) if word == base else word for word in shlex.split(command)]
    asks_for_sum = words[0] in WRITERS and "--sum" not in words
    return [*words, "--sum"] if asks_for_sum else words


def run(folder_of_tools, command, base, folder):
    """The finished command."""
    tool, *arguments = arguments_of(command, base)
    program = Path(folder_of_tools).resolve() / tool
    done = subprocess.run(
        [program, *arguments], cwd=folder, capture_output=True, text=True, check=False
    )
    if -done.returncode in INTERRUPTIONS:
        sys.exit(128 - done.returncode)  # the signal was for all that runs
    return done


def fault(command, done):
    """The status of a point whose command ended so: the tool says why, or it crashed."""
    said = done.stderr.strip()
    if done.returncode in USER_ERRORS:
        return {"status": "failed", "sentence": said.splitlines()[-1] if said else command}
    sentence = f"'{command}' ended with {done.returncode}{': ' if said else ''}{said}"
    return {"status": UNFINISHED, "sentence": sentence}


def compute(folder_of_tools, point):
    """The result of a point."""
    result: dict = {"commands": list(point.commands.values()), "status": "done", "sentence": ""}
    with tempfile.TemporaryDirectory(prefix="rupture-point-") as folder:
        for name, command in point.commands.items():
            done = run(folder_of_tools, command, point.base, folder)
            if done.returncode:
                result |= fault(command, done)
                break
            if "--json" in shlex.split(command):
                result[name] = json.loads(done.stdout)
        sums = [path.read_text().split() for path in sorted(Path(folder).glob("*.sum"))]
        result["checksums"] = {name: checksum for *_, checksum, name in sums}
    return result


# --- keeping -----------------------------------------------------------------------------------


def digest(*parts):
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:16]


@cache
def content_of(base):
    """The identity of a base: the checksum of its content, or else of its bytes."""
    if not base:
        return ""
    checksum = Path(f"{base}.sum")
    if checksum.exists():
        return checksum.read_text(encoding="utf-8")
    return hashlib.sha256(Path(base).read_bytes()).hexdigest()


class PointStore:
    def __init__(self, folder, code):
        """`code`: fingerprint of the sources or programs."""
        self.folder, self.code = Path(folder), code

    def path(self, point):
        return self.folder / f"{point.id}.json"

    def origin(self, point):
        return digest(self.code, COMPUTED_BY, content_of(point.base))

    def stored(self, point):
        """What is there of the point, if it has this origin."""
        try:
            stored = json.loads(self.path(point).read_text(encoding="utf-8"))
            is_current = stored.pop("origin", None) == self.origin(point)
        except (OSError, ValueError, AttributeError, TypeError):
            return {}
        return stored if is_current else {}

    def result(self, point):
        """The result of the point; None if it has to be computed."""
        stored = self.stored(point)
        return None if stored.get("status", UNFINISHED) == UNFINISHED else stored

    def save(self, point, result):
        content = json.dumps({**result, "origin": self.origin(point)}) + "\n"
        write_whole(self.path(point), content)


# --- a batch -----------------------------------------------------------------------------------


def result_of(point, store, folder_of_tools):
    """The stored result, or else the one computed now."""
    result = store.result(point)
    if result is None:
        result = compute(folder_of_tools, point)
        store.save(point, result)
    return result


def main(folder_of_tools, sweep, points_folder, code, output, *ids):
    for number in INTERRUPTIONS:  # so that the point's folder is deleted
        signal.signal(number, lambda which, _: sys.exit(128 + which))
    store = PointStore(points_folder, code)
    points = {point.id: point for point in read_sweep(sweep).points}
    results = {each: result_of(points[each], store, folder_of_tools) for each in ids}
    crashes = [r["sentence"] for r in results.values() if r["status"] == UNFINISHED]
    if crashes:
        sys.exit("\n".join(f"points.py: {sentence}" for sentence in crashes))
    with replacing(output) as part, part.open("w", encoding="utf-8") as file:
        for each, result in results.items():
            print(digest(json.dumps(result)), each, file=file)


if __name__ == "__main__":
    main(*sys.argv[1:])
