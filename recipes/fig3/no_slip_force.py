#!/usr/bin/env python3
# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Fronts where junctions that slip carry no force: data and claim 0slip.

no_slip_force.py POINTS FOLDER CLAIMS.json TABLE.csv...

The tables are those of the sweeps, the seed that is shown first; POINTS is the folder with what was
measured of each point.
"""

import sys
from pathlib import Path

from claims.claim import write_claims
from claims.judge import judged
from data.records import report, values
from data.tables import read_rows, write_table
from events.conventions import CONVENTIONS, PRIMARY
from events.fronts import SLOW_BELOW
from maps.front_map import IMPOSSIBLE, SKIP_BELOW_X, TYPES, front_type, place_of

COMMANDS = {  # convention: command of the sweeps; the others only differ in what is called slow
    "stencil 3": "stencil_3",
    "stencil 7": "stencil_7",
    "20 % pinned": "pinned_20",
    "50 % pinned": "pinned_50",
}
WAYS = {  # convention: command, and slow below this times c_s
    name: (COMMANDS.get(name, "front"), options.get("--slow-below", SLOW_BELOW))
    for name, options in CONVENTIONS.items()
    if name in COMMANDS or set(options) <= {"--slow-below"}
}


def types_of(point):
    """{convention: type} of a point; impossible where no interface can be prepared."""
    return {name: front_type(point.get(command), below) for name, (command, below) in WAYS.items()}


def slowest(front):
    """Lowest v_c [m/s] of a front that spans, at stencils beyond the trigger region; else None."""
    if front is None or front["t_rupture"][-1] is None:
        return None
    x_v_c = zip(front["x"], values(front["v_c"]))
    return min((v for x, v in x_v_c if x > SKIP_BELOW_X and v > 0), default=None)


def counts(kinds):
    return {f"{kind} fronts": kinds.count(kind) for kind in TYPES}


def case_under(convention, points):
    return counts([types_of(point)[convention] for point in points])


def units_of(seeds):
    """Of {seed: points}."""
    return {
        f"seed {seed}": {name: [case_under(name, points)] for name in WAYS}
        for seed, points in seeds.items()
    }


def claim(seeds):
    """`seeds`: {seed: points}, the shown one first."""
    shown = next(iter(seeds.values()))
    kinds = [types_of(point)[PRIMARY] for point in shown]
    speeds = [v for point in shown if (v := slowest(point.get("front"))) is not None]
    slow_somehow = [point for point in shown if "slow" in types_of(point).values()]
    case = counts(kinds)
    return judged(
        "0slip",
        shown=case,
        units=units_of(seeds),
        measured={
            "interfaces": len(shown),
            **case,
            "interfaces that cannot be prepared": kinds.count(IMPOSSIBLE),
            "fronts that are slow under any convention": len(slow_somehow),
            "lowest speed of fronts that span [m/s]": min(speeds, default=None),
        },
        note="mu_d = 0, so that tau_bar_0 = tau_0/(mu_s p); sigma_bar = 0 and 0.1, the same"
        " tau_bar_0 at each. A front is slow if one stencil beyond the trigger region is."
        " Seeds act through the slipping times only.",
    )


def read_seeds(tables, points):
    """{seed: [(row, point), ...]}"""
    seeds: dict[int, list] = {}
    for row in (row for table in tables for row in read_rows(table)):
        point = report(Path(points) / f"{row['point']}.json")
        seeds.setdefault(int(row["numerics.seed"]), []).append((row, point))
    return seeds


def main(points, folder, claims_path, *tables):
    seeds = read_seeds(tables, points)
    rows = (
        [seed, *place_of(row), slowest(point.get("front")), *types_of(point).values()]
        for seed, pairs in seeds.items()
        for row, point in pairs
    )
    names = ["seed", "tau-bar", "sigma-bar", "lowest v_c [m/s]", *WAYS]
    write_table(Path(folder) / "no-slip-force.csv", names, rows)
    of_seed = {seed: [point for _, point in pairs] for seed, pairs in seeds.items()}
    write_claims(claims_path, [claim(of_seed)])


if __name__ == "__main__":
    main(*sys.argv[1:])
