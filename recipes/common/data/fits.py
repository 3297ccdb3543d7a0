"""Fits that several figures make."""

from collections import namedtuple

import numpy as np

# y = slope x. R^2 compares with the mean of y, as for a line with an intercept: it says how much
# better the fit is than no dependence on x at all.
ProportionalFit = namedtuple("ProportionalFit", "slope r_squared points")


def fit_through_origin(x, y):
    x, y = np.asarray(x, float), np.asarray(y, float)
    if len(x) < 2:
        return None
    slope = (x @ y) / (x @ x)
    residual = ((y - slope * x) ** 2).sum()
    return ProportionalFit(slope, 1 - residual / ((y - y.mean()) ** 2).sum(), len(x))
