"""A block in an event: its slip, as `analyze slip --json` reports it, and its friction."""

import numpy as np

from measure.continuations import LEAD


def peaks_of(record):
    """When tau/p of each block is largest [s], and tau/p at the start, then, and LEAD after the
    last block has ruptured. A block without contact has none."""
    ruptures, tau, p = record.ruptures, record["tau"], record["p"]
    _, first = np.unique(ruptures.block, return_index=True)
    shown = record.time <= ruptures.time[first].max() + LEAD
    ratio = np.divide(tau, p, out=np.full_like(tau, -np.inf), where=p > 0)[shown]
    levels = {"before": ratio[0], "at_peak": ratio.max(axis=0), "after": ratio[-1]}
    return {
        "t_peak": record.time[np.argmax(ratio, axis=0)].tolist(),
        **{n: [x if np.isfinite(x) else None for x in level] for n, level in levels.items()},
    }
