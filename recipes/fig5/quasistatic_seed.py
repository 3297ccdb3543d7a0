#!/usr/bin/env python3
"""The quasi-static front of another seed: quasistatic_seed.py PROGRAMS SEED UNTIL EVERY FOLDER

Drives the slider at h = 0 from t = 0, and stops the driving at the checkpoint in the middle of the
quasi-static stretch, as for the seed that the figure shows. Runs in FOLDER, which is deleted at the
end. Prints what quasistatic_stretch.measured() says.
"""

import json
import os
import sys
from pathlib import Path

import rupture

import quasistatic_stretch as stretches

from data.scratch import scratch


def run(program, *inputs, output, **options):
    """Returns the record."""
    record = output.with_stem(f"{output.stem}-record")
    rupture.run(program, *inputs, output=output, record=record, record_every=1e-3, **options)
    return record


def measure(seed, until, every, folder):
    drive = {"driving.h": 0, "numerics.seed": int(seed)}
    output = folder / "load.h5"
    load = run("load", output=output, set=drive, until=until, checkpoint_every=every)
    stretch = stretches.quasistatic_stretch(load, float(every))
    t = stretch["branches"][stretches.MIDDLE]
    branch, output = folder / f"load-t{t}.h5", folder / "stopped.h5"
    stopped = run(
        "restart", branch, output=output, set={"driving.V": 0}, for_=stretches.STOPPED_FOR
    )
    driven, undriven = stretches.read_ruptures(load), stretches.read_ruptures(stopped)
    branch = stretches.advances(driven, undriven, stretch["interval_from"], float(t))
    return stretches.measured(stretch, rupture.open(load).c_s, branch)


def main(programs, seed, until, every, folder):
    os.environ["RUPTURE_BIN"] = programs
    with scratch(Path(folder)) as folder:
        print(json.dumps(measure(seed, until, every, folder)))


if __name__ == "__main__":
    main(*sys.argv[1:])
