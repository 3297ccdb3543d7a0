#!/usr/bin/env python3
"""Decay length ahead of slow fronts of one seed: decay_length_seed.py PROGRAMS SEED FOLDER

Runs fronts over prepared interfaces, those of Figure 3 D that have the reference parameters. Works
in FOLDER, which is deleted at the end. Prints

    "l_0"       {method: l_0 [m]}, the median of the fronts
    "fronts"    {tau_bar_0: what decay_length.of_front() says}
"""

import json
import subprocess
import sys
from pathlib import Path

import h5py
from decay_length import of_front, of_seed

from data.scratch import scratch
from events.conventions import Analysis
from maps.front_map import SKIP_BELOW_X

SIGMA_BAR = 0.1
TAU_BARS = [f"{0.005 * n:g}" for n in range(14, 25)]  # 0.07 to 0.12
RECORD_EVERY = "2e-5"  # [s]


def run(*words):
    subprocess.run([*map(str, words), "--quiet"], stdout=sys.stderr, check=True)


def measure(programs, seed, tau_bar, folder):
    """The front over one prepared interface."""
    start, end, record = (folder / f"{tau_bar}-{name}.h5" for name in ("start", "end", "record"))
    prestress = ["--tau-bar", tau_bar, "--sigma-bar", SIGMA_BAR]
    run(programs / "prepare", *prestress, "--set", f"numerics.seed={seed}", "-o", start)
    recorded = ["--record", record, "--record-every", RECORD_EVERY]
    run(programs / "restart", start, "-o", end, "--until-quiet", *recorded)
    front = Analysis(programs)("front", record, ["--skip-below-x", SKIP_BELOW_X])
    with h5py.File(record) as file:
        return of_front(front, file["series/time"][()], file["series/tau"][()])


def main(programs, seed, folder):
    with scratch(Path(folder)) as folder:
        fronts = {t: measure(Path(programs).resolve(), int(seed), t, folder) for t in TAU_BARS}
    print(json.dumps({"l_0": of_seed(fronts.values()), "fronts": fronts}))


if __name__ == "__main__":
    main(*sys.argv[1:])
