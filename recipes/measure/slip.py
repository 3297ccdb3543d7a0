"""The friction of each block in an event."""

import numpy as np
import rupture

AFTER = 0.5e-3  # the last rupture [s]; later peaks do not count


def peaks_of(record):
    """When tau/p of each block is largest [s], and tau/p at the start, then, and AFTER the
    last block has ruptured. A block without contact has none."""
    ruptures, tau, p = record.ruptures, record["tau"], record["p"]
    _, first = np.unique(ruptures.block, return_index=True)
    shown = record.time <= ruptures.time[first].max() + AFTER
    ratio = np.divide(tau, p, out=np.full_like(tau, -np.inf), where=p > 0)[shown]
    levels = {"before": ratio[0], "at_peak": ratio.max(axis=0), "after": ratio[-1]}
    return {
        "t_peak": record.time[np.argmax(ratio, axis=0)].tolist(),
        **{n: [x if np.isfinite(x) else None for x in level] for n, level in levels.items()},
    }


def peaks_of_record(path):
    return peaks_of(rupture.open(path))
