"""Numbers of the paper beside a median and a range of ours."""

import numpy as np

from claims.claim import Number


def spread(quantity, paper, values, of, **beside):
    """A number with the median and range of these values, those that are known."""
    known = [value for value in values if value is not None]
    low, median, high = np.percentile(known, (5, 50, 95)).tolist() if known else (None,) * 3
    found = {"median": median, "low": low, "high": high, "of": of.format(len(known))}
    return Number(quantity, paper, **found, **beside)
