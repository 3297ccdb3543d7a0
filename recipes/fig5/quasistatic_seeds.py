#!/usr/bin/env python3
"""Quasi-static fronts over seeds: quasistatic_seeds.py results/data/fig5 02 03 ...

Per seed: mean speed of the tip from its first advance after the dynamic event to its last in the
run, and the blocks by which it advances when the driving stops at the end of the run.
"""

import json
import sys
from pathlib import Path

import numpy as np
from quasistatic_stretch import (
    APART,
    dynamic_events,
    is_quasistatic,
    read_ruptures,
    tip_advances,
)

from data.records import shear_wave_speed


def measure(data, seed):
    record = data / f"seed-{seed}-record.h5"
    time, block, x = read_ruptures(record)
    (_, end), *later = dynamic_events(time, block, len(x))
    if later:
        sys.exit(f"seed {seed} has a second dynamic event: no quasi-static front to measure")
    t, tip = tip_advances(time, block, end + APART, np.inf)
    speed = (x[tip[-1]] - x[tip[0]]) / (t[-1] - t[0])
    ratio = shear_wave_speed(record) / speed
    _, after, _ = read_ruptures(data / f"seed-{seed}-stopped-record.h5")
    stopped = int(max(max(after, default=-1) - tip[-1], 0))
    return {
        "seed": seed,
        "speed": speed,
        "c_s/speed": ratio,
        "stopped": stopped,
        "holds": bool(is_quasistatic(ratio, stopped)),
    }


def main(data, *seeds):
    print(json.dumps([measure(Path(data), seed) for seed in seeds], indent=2))


if __name__ == "__main__":
    main(*sys.argv[1:])
