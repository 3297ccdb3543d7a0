"""Figure S5: effective static friction for two shapes of phi, up to widths beyond the last change
of branch."""

from functools import cache

import numpy as np
from rupture.once import run

from claims.samples import Samples, every
from figS5.quadrature import largest_mean_force, uniform_closed_form

SHAPES = ("uniform", "bell")
SIGMA_BARS = [round(0.02 * n, 12) for n in range(61)]


def strength(shape, sigma_bar):
    return run(f"analyze strength --shape {shape} --sigma-bar {sigma_bar}")


class Strength:
    """The tool's result for one shape, beside quadrature."""

    def __init__(self, shape):
        reports = every(strength, [(shape, s) for s in SIGMA_BARS], shape).values()
        self.shape, self.sigma_bar = shape, np.array(SIGMA_BARS)
        self.mu_bar = np.array([of.mu_bar_eff for of in reports])
        self.mu = np.array([of.mu_eff for of in reports])
        self.quadrature = np.array([largest_mean_force(shape, s) for s in self.sigma_bar])


@cache
def strengths():
    return [Strength(shape) for shape in SHAPES]


def both_shapes():
    return Samples({"": strengths()})


def deviation(strengths, _):
    """S5: from a closed form and from quadrature, which are independent of the tool."""
    uniform, bell = strengths
    closed = np.array([uniform_closed_form(sigma_bar) for sigma_bar in uniform.sigma_bar])
    found = {
        "uniform - closed form": np.abs(np.subtract(uniform.mu_bar, closed)).max(),
        "uniform - quadrature": np.abs(np.subtract(uniform.mu_bar, uniform.quadrature)).max(),
        "bell - quadrature": np.abs(np.subtract(bell.mu_bar, bell.quadrature)).max(),
    }
    return {
        "falls from each to the next": all(np.all(np.diff(of.mu_bar) < 0) for of in strengths),
        "largest deviation of mu-bar": max(found.values()),
        **{f"mu-bar, largest |{name}|": of for name, of in found.items()},
    }
