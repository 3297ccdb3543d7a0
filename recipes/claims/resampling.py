"""Intervals of what is measured over the events of several runs. Events of one run share a history,
so runs are drawn again, with replacement: a cluster bootstrap."""

import numpy as np

RESAMPLES = 2000


def interval_by_runs(statistic, of_runs):
    """90 % interval of a statistic of all values. `of_runs`: a list of values for each run. None
    and None for fewer than two runs with values."""
    runs = [np.asarray(values) for values in of_runs if len(values)]
    if len(runs) < 2:
        return None, None
    drawn = np.random.default_rng(0).integers(len(runs), size=(RESAMPLES, len(runs)))
    found = [statistic(np.concatenate([runs[n] for n in row])) for row in drawn]
    low, high = np.nanquantile(found, (0.05, 0.95))
    return float(low), float(high)
