"""The tool's effective static friction beside its definition, as the script of a chain:

    deviation = script deviation.py {all strength}

Reports the largest deviations of mu-bar from a closed form and from quadrature (quadrature.py), and
whether mu-bar falls from each width to the next.
"""

import numpy as np
from quadrature import largest_mean_force, uniform_closed_form

from chains.results import read_points


class Strength:
    """The tool's result for one shape, beside the formula or quadrature."""

    def __init__(self, shape, points):
        of_shape = [point for point in points if point["shape"] == shape]
        self.shape = shape
        self.sigma_bar = np.array([point["sigma-bar"] for point in of_shape])
        self.mu_bar = np.array([point["strength"]["mu_bar_eff"] for point in of_shape])
        self.mu = np.array([point["strength"]["mu_eff"] for point in of_shape])
        self.quadrature = np.array([largest_mean_force(shape, s) for s in self.sigma_bar])


def main(points):
    read = read_points(points)
    uniform, bell = (Strength(shape, read) for shape in ("uniform", "bell"))
    closed = np.array([uniform_closed_form(sigma_bar) for sigma_bar in uniform.sigma_bar])
    falls = np.all(np.diff(uniform.mu_bar) < 0) and np.all(np.diff(bell.mu_bar) < 0)
    return {
        "falls": bool(falls),
        "uniform_closed": float(np.abs(uniform.mu_bar - closed).max()),
        "uniform_quadrature": float(np.abs(uniform.mu_bar - uniform.quadrature).max()),
        "bell_quadrature": float(np.abs(bell.mu_bar - bell.quadrature).max()),
    }
