#!/usr/bin/python3
"""Compares what the programs of two builds compute, byte for byte: the state of checkpoints, and
the series of records. Parameters, provenance and checksums may differ; the new ones read both.

    compare.py OLD_BIN NEW_BIN [FOLDER]

Runs the pipeline of tests/golden, continuations of the shipped checkpoints and 20 points of
recipes/fig4/map.ini with the programs in both folders. Exit code 0: all are equal. Where the old
programs refuse a command because they lack what is new, that job's later files are reported as
missing."""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(PROJECT / "recipes/common"), str(PROJECT / "python")]
from sweeps.sweep import read_sweep  # noqa: E402

POINTS = 20


def run(command, programs, folder):
    """The exit code."""
    folder.mkdir(parents=True, exist_ok=True)
    path = f"{programs}:{os.environ['PATH']}"
    environment = {**os.environ, "PATH": path}
    return subprocess.run(["bash", "-ec", command], cwd=folder, env=environment).returncode


def jobs():
    """(name, commands) of everything that is run."""
    yield "golden", str(PROJECT / "tests/golden/chain.sh")
    for checkpoint in sorted((PROJECT / "checkpoints").glob("*.h5")):
        yield checkpoint.stem, f"restart '{checkpoint}' -q --for 1e-3 -o end.h5 --record record.h5"
    points = read_sweep(PROJECT / "recipes/fig4/map.ini").points
    for point in points[:: len(points) // POINTS + 1]:  # +1: not all with the same sigma-bar
        steps = [point.commands["prepare"], point.commands["restart"]]
        name = " ".join(f"{key}={value}" for key, value in point.values.items())
        yield f"map {name}", "\n".join(steps)


def compare(old, new, analyze):
    """What differs in `new` besides parameters, or nothing."""
    command = [analyze, "diff", old, new, "--json"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if not done.stdout:
        return done.stderr.strip() or f"analyze diff ended with {done.returncode}"
    paths = [found["path"] for found in json.loads(done.stdout)["differences"]]
    return ", ".join(path for path in paths if not path.startswith("/parameters/"))


def main():
    programs = [Path(folder).resolve() for folder in sys.argv[1:3]]
    work = Path(sys.argv[3] if len(sys.argv) > 3 else tempfile.mkdtemp()).resolve()
    bad = 0
    for number, (name, commands) in enumerate(jobs()):
        folders = [work / side / str(number) for side in ("old", "new")]
        run(commands, programs[0], folders[0])
        if run(commands, programs[1], folders[1]):
            sys.exit(f"{name}: the new programs failed")
        for file in sorted({path.name for folder in folders for path in folder.glob("*.h5")}):
            wrong = compare(folders[0] / file, folders[1] / file, programs[1] / "analyze")
            print(f"{wrong or 'equal'}: {name}: {file}", flush=True)
            bad += bool(wrong)
    print("all are equal" if not bad else f"{bad} differ")
    return 1 if bad else 0


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    sys.exit(main())
