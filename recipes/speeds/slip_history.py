#!/usr/bin/env python3
"""How evenly the blocks of a load slipped after they ruptured, and how strong that left them:

    slip_history.py RECORD CHECKPOINT...

Prints a row for each block and rupture, measured at the first checkpoint that is BINNED later, if
the block has not ruptured again by then.
"""

import json
import sys

import numpy as np
import rupture

from events.fronts import LOADING_ZONE

BINNED = 10e-3  # after the rupture [s]: 5 <t_R>
EDGES = np.linspace(0, BINNED, 11)  # of the bins, <t_R>/2 each


def gini(parts):
    """0 if all are equal, 1 - 1/n if one of n has everything; None of nothing."""
    total = np.sum(parts)
    differences = np.abs(np.subtract.outer(parts, parts))
    return float(differences.sum() / (2 * len(parts) * total)) if total > 0 else None


def slip_in_bins(time, u_x, since):
    """Forward slip [m]."""
    return np.clip(np.diff(np.interp(since + EDGES, time, u_x)), 0, None)


def last_ruptures(ruptures, until):
    """{block: time}"""
    before = ruptures.time <= until
    return dict(zip(ruptures.block[before].tolist(), ruptures.time[before]))


def rows_of(record, checkpoints):
    u_x, before = record["u_x"], -np.inf
    for path in checkpoints:
        now = rupture.open(path).time
        strength = rupture.analyze("strength", path)["mu_bar_eff"]
        for block, since in last_ruptures(record.ruptures, now).items():
            slip = slip_in_bins(record.time, u_x[:, block], since)
            if record.x[block] >= LOADING_ZONE and before < since + BINNED <= now:
                yield {
                    "x [m]": record.x[block],
                    "ruptured at [s]": since,
                    "slip [m]": slip.sum(),
                    "Gini coefficient": gini(slip),
                    "mu_bar_eff": strength[block],
                }
        before = now


def main(record, *checkpoints):
    print(json.dumps(list(rows_of(rupture.open(record), checkpoints))))


if __name__ == "__main__":
    main(*sys.argv[1:])
