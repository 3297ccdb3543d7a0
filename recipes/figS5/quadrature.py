"""Effective static friction from the definition, written without a look at the tool's formulas.

A block whose junctions carry g_0 + xi, xi distributed as phi on [-a, a], is moved forwards: after a
stretch d, in the unit of g = (f - f_slip)/(f_thres - f_slip), those that were above 1 - d have
broken and bear 0, the others bear d more. The mean of g,

    mean(d) = int_{-a}^{min(a, 1 - d - g_0)} (g_0 + xi + d) phi(xi) dxi,

is (tau/p - mu_d)/(mu_s - mu_d), and its largest value is mu-bar. It does not depend on g_0, which
only shifts d, as long as g_0 + a <= 1: g_0 = 1 - a, the junction that bears most being about to
break, has its maximum at d >= 0.

Uniform phi: mean = (w - w^2/2)/(2a), where w = 2a - d is what is left of the width; at most 2a, and
best 1. So mu-bar = 1 - a if 2a <= 1, else 1/(4a); a = sqrt(3) sigma-bar.
"""

import numpy as np
from scipy.integrate import quad
from scipy.optimize import minimize_scalar


def uniform(xi, a):
    return np.where(np.abs(xi) <= a, 1 / (2 * a), 0.0)


def bell(xi, a):
    y = np.minimum(np.abs(xi / a), 1.0)
    return 5 / (4 * a) * (1 + 3 * y) * (1 - y) ** 3


SHAPES = {"uniform": uniform, "bell": bell}


def sigma_of_unit_width(shape):
    return quad(lambda xi: 2 * xi**2 * SHAPES[shape](xi, 1.0), 0, 1, epsabs=1e-14)[0] ** 0.5


def mean_force(shape, a, g_0, d):
    top = min(a, 1 - d - g_0)
    if top <= -a:
        return 0.0

    def force(xi):
        return (g_0 + xi + d) * SHAPES[shape](xi, a)

    return quad(force, -a, top, points=[min(0.0, top)], epsabs=1e-13)[0]


def largest_mean_force(shape, sigma_bar):
    """mu-bar by quadrature; the best d of a grid is refined between its neighbours."""
    if sigma_bar == 0:
        return 1.0
    a = sigma_bar / sigma_of_unit_width(shape)
    grid = np.linspace(0, 2 * a, 41)
    best = int(np.argmax([mean_force(shape, a, 1 - a, d) for d in grid]))
    found = minimize_scalar(
        lambda d: -mean_force(shape, a, 1 - a, d),
        bounds=(grid[max(best - 1, 0)], grid[min(best + 1, 40)]),
        method="bounded",
        options={"xatol": 1e-9},
    )
    return max(-found.fun, mean_force(shape, a, 1 - a, 0.0))


def uniform_closed_form(sigma_bar):
    a = np.sqrt(3) * sigma_bar
    return 1 - a if 2 * a <= 1 else 1 / (4 * a)
