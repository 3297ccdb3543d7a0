#!/usr/bin/env python3
"""The quasi-static front of another seed: quasistatic_seed.py PROGRAMS SEED UNTIL EVERY FOLDER

Drives the slider at h = 0 from t = 0, and stops the driving at the checkpoint in the middle of the
quasi-static stretch, as for the seed that the figure shows. Runs in FOLDER, which is deleted at the
end. Prints what quasistatic_stretch.measured() says.
"""

import json
import subprocess
import sys
from pathlib import Path

import rupture

from quasistatic_stretch import (
    MIDDLE,
    STOPPED_FOR,
    advances,
    measured,
    quasistatic_stretch,
    read_ruptures,
)

from data.scratch import scratch

RECORD_EVERY = "1e-3"  # [s]


def run(tool, folder, name, *words):
    """Returns the record."""
    record = folder / f"{name}-record.h5"
    options = ["-o", folder / f"{name}.h5", "--quiet", "--record", record]
    command = [tool, *words, *options, "--record-every", RECORD_EVERY]
    subprocess.run(list(map(str, command)), check=True)
    return record


def measure(programs, seed, until, every, folder):
    drive = ["--set", "driving.h=0", "--set", f"numerics.seed={int(seed)}"]
    lasting = ["--until", until, "--checkpoint-every", every]
    load = run(programs / "load", folder, "load", *drive, *lasting)
    stretch = quasistatic_stretch(load, float(every))
    t = stretch["branches"][MIDDLE]
    stop = ["--set", "driving.V=0", "--for", STOPPED_FOR]
    stopped = run(programs / "restart", folder, "stopped", folder / f"load-t{t}.h5", *stop)
    driven, undriven = read_ruptures(load), read_ruptures(stopped)
    branch = advances(driven, undriven, stretch["interval_from"], float(t))
    return measured(stretch, rupture.open(load).c_s, branch)


def main(programs, seed, until, every, folder):
    with scratch(Path(folder)) as folder:
        found = measure(Path(programs), seed, until, every, folder)
    print(json.dumps(found))


if __name__ == "__main__":
    main(*sys.argv[1:])
