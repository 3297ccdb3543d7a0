"""Fronts that have passed 0.14 L, with and without slow slip from there on (docs/sweeps.md):
python3 branches.py > branches.csv"""

import csv
import sys

from rupture.once import each, run

RECORD = "--for 12ms --record record.h5 --record-every 1e-5"
load = run("load -o load.h5 --until 0.7 --checkpoint-every 0.05 --record r.h5 --record-every 1ms")


def front_of(start, options, out):
    """The front after a checkpoint."""
    record = run(f"restart {start} {options} {RECORD} -o {out}")["record.h5"]
    return run(f"analyze front {record} --event 0")


def branch(start, f_new):
    """The type of a front that is changed when block 8 ruptures, and where it arrests."""
    last = load[f"load-t{int(start / 0.05) * 0.05:.9f}.h5"]
    before = run(f"restart {last} --until {start} -o before.h5")["before.h5"]
    rupture = front_of(before, "", "again.h5").t_rupture[8]
    begin = run(f"restart {before} --until {rupture} -o branch.h5")["branch.h5"]
    after = front_of(begin, f"--set junctions.f_new={f_new}", "end.h5")
    return after.type, after.x_arrest


events = run(f"analyze events {load['r.h5']}").events
starts = [round(event.t_start - 0.5e-3, 7) for event in events if event.spanning]
points = [(start, f_new) for start in starts for f_new in ("zero", "f_slip")]
table = csv.writer(sys.stdout)
table.writerow(["start", "junctions.f_new", "type", "arrest [m]"])
table.writerows([*point, *found] for point, found in each(branch, points, "branches"))
