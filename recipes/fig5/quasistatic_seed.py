"""The quasi-static front of another seed:

    quasistatic_seed.py START SEED UNTIL EVERY FOLDER

Drives the slider at h = 0 from START, the checkpoint of the load that the figure shows from before
any junction broke, until the second dynamic event is over, or to the time UNTIL; then stops the
driving at the checkpoint in the middle of the quasi-static stretch, as for the seed that the figure
shows. Runs in FOLDER, which is deleted at the end. Prints c_s, speed and tip of the front, and how
far it advances from this branch.
"""

from pathlib import Path

import numpy as np
import rupture

import quasistatic_stretch as stretches

from data.scratch import scratch

EARLIEST, LEG = 0.6, 0.01  # when it is first asked whether the event is over, and how often [s]


def run(start, output, **options):
    """Returns the record."""
    record = output.with_stem(f"{output.stem}-record")
    rupture.run("restart", start, output=output, record=record, record_every=1e-3, **options)
    return record


def joined(records):
    """The ruptures of runs that follow each other, as read_ruptures()."""
    times, blocks, x = zip(*map(stretches.read_ruptures, records))
    return np.concatenate(times), np.concatenate(blocks), x[0]


def is_over(ruptures, t, every):
    """Whether all that is measured has happened by the time t."""
    time, block, x = ruptures
    if len(stretches.dynamic_events(time, block, len(x))) < 2:
        return False
    branches = stretches.quasistatic_stretch(ruptures, every)["branches"]
    return float(branches[stretches.MIDDLE]) + stretches.STOPPED_FOR <= t


def driven(start, seed, until, every, folder):
    """The records of the load, in legs; its checkpoints are LEG-tT.h5."""
    records: list[Path] = []
    for leg, t in enumerate(np.arange(EARLIEST, until + LEG / 2, LEG).round(9)):
        options = {"set": {"numerics.seed": seed}, "until": t, "checkpoint_every": every}
        records.append(run(start, folder / f"{leg}.h5", **options))
        if is_over(joined(records), t, every):
            break
        start = folder / f"{leg}.h5"
    return records


def measure(start, seed, until, every, folder):
    records = driven(start, seed, until, every, folder)
    load = joined(records)
    stretch = stretches.quasistatic_stretch(load, every)
    t = stretch["branches"][stretches.MIDDLE]
    (branch,) = folder.glob(f"*-t{t}.h5")
    stop = {"set": {"driving.V": 0}, "for_": stretches.STOPPED_FOR}
    stopped = stretches.read_ruptures(run(branch, folder / "stopped.h5", **stop))
    moved = stretches.advances(load, stopped, stretch["interval_from"], float(t))
    measured = {"speed": stretch["speed"], "tip": stretch["tip"], "branch": moved}
    return {"c_s": rupture.open(records[0]).c_s} | measured


def main(start, seed, until, every, folder):
    with scratch(Path(folder)) as folder:
        return measure(start, int(seed), float(until), float(every), folder)
