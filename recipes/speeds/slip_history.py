"""How unevenly the blocks of a load slipped after they ruptured, and how strong that left them."""

import numpy as np
import rupture
from rupture.reports import LOADING_ZONE

BINNED, BINS = 10e-3, 10  # after the rupture [s]: 5 <t_R>, so that a bin is <t_R>/2


def gini(parts):
    """0 if all are equal, 1 - 1/n if one of n has everything; None of nothing."""
    total = np.sum(parts)
    differences = np.abs(np.subtract.outer(parts, parts))
    return float(differences.sum() / (2 * len(parts) * total)) if total > 0 else None


def slip_in_bins(time, u_x, since):
    """Forward slip [m]."""
    edges = since + np.linspace(0, BINNED, BINS + 1)
    return np.clip(np.diff(np.interp(edges, time, u_x)), 0, None)


def rows_of(record, checkpoints):
    record, before = rupture.open(record), -np.inf
    ruptures, u_x = record.ruptures, record["u_x"]
    for path in checkpoints:
        now, strength = rupture.open(path).time, rupture.analyze("strength", path)["mu_bar_eff"]
        past = ruptures.time <= now
        last = dict(zip(ruptures.block[past], ruptures.time[past]))
        for block, since in last.items():
            if record.x[block] >= LOADING_ZONE and before < since + BINNED <= now:
                slip = slip_in_bins(record.time, u_x[:, block], since)
                yield {
                    "x [m]": record.x[block],
                    "ruptured at [s]": since,
                    "slip [m]": slip.sum(),
                    "slip after 2 ms [m]": slip[2:].sum(),
                    "Gini coefficient": gini(slip),
                    "mu_bar_eff": strength[block],
                }
        before = now


def history_of(record, *checkpoints):
    """A row for each block and rupture, measured at the first checkpoint that is BINNED later, if
    the block has not ruptured again by then."""
    return [*rows_of(record, checkpoints)]
