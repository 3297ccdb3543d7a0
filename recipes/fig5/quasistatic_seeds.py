#!/usr/bin/env python3
"""Quasi-static fronts over seeds: quasistatic_seeds.py results/data/fig5 TIME_OF_STOP 02 03 ...

Per seed: mean speed of the tip from its first advance after the dynamic event to its last in the run, and the blocks by which it advances after the stop, with the driving and without it.
"""

import json
import sys
from pathlib import Path

import numpy as np
from quasistatic_stretch import APART, dynamic_events, read_ruptures, tip_advances

from common.records import shear_wave_speed


def tip_at(time, tip, when):
    return tip[np.searchsorted(time, when, side="right") - 1]


def advance_without_driving(path, tip):
    _, block, _ = read_ruptures(path)
    return max(max(block, default=-1) - tip, 0)


def measure(data, seed, t_stop):
    record = data / f"seed-{seed}-record.h5"
    time, block, x = read_ruptures(record)
    (_, end), *later = dynamic_events(time, block, len(x))
    if later:
        sys.exit(
            f"seed {seed} has a second dynamic event: there is no quasi-static front to measure"
        )
    t, tip = tip_advances(time, block, end + APART, np.inf)
    at_stop = tip_at(t, tip, t_stop)
    speed = (x[tip[-1]] - x[tip[0]]) / (t[-1] - t[0])
    return {
        "seed": seed,
        "speed": speed,
        "c_s/speed": shear_wave_speed(record) / speed,
        "driven": int(tip[-1] - at_stop),
        "stopped": int(advance_without_driving(data / f"seed-{seed}-stopped-record.h5", at_stop)),
    }


def main(data, t_stop, *seeds):
    print(json.dumps([measure(Path(data), seed, float(t_stop)) for seed in seeds], indent=2))


if __name__ == "__main__":
    main(*sys.argv[1:])
