"""A run of a small slider, through which a rupture passes, in a folder of its own."""

import os
import tempfile
from functools import cache
from pathlib import Path

import rupture

SMALL = {  # as tests/golden/small.ini
    "slider.Nx": 17,
    "slider.Nz": 9,
    "slider.H": 0.07,
    "driving.h": 0.00875,
    "driving.V": 1,
    "junctions.N_s": 37,
    "junctions.t_R": 2e-4,
    "junctions.delta_t_R": 6e-5,
}


@cache
def folder():
    """Holds small.h5 and small-record.h5, and is the current one from now on."""
    made = tempfile.TemporaryDirectory()
    os.chdir(made.name)
    files = {"output": "small.h5", "record": "small-record.h5"}
    times = {"until": 0.002, "record_every": 2e-6, "checkpoint_every": 5e-4}
    return Path(made.name), rupture.run("load", **files, **times, set=SMALL), made
