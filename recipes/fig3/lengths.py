"""The decay length l_0 of the shear force ahead of slow fronts, those of Figure 3 D with the
reference parameters; and when k_i alone varies, by kappa."""

import math
from functools import cache

import numpy as np
from rupture.once import measured
from rupture.reports import values

import frozen
from claims.samples import every
from fig3.decay_length import METHODS, decay_of_front, median
from fig3.front_speed import REFERENCE, parameters
from fig3.slow_fronts import record_of
from maps import over_seeds, spaced
from measure.ways import PRIMARY

KAPPA = 39.2e9  # of the reference [N/m^2]
KAPPAS = (156.8e9, 78.4e9, 39.2e9, 19.6e9, 9.8e9)  # k_i from twice the reference's to half of it


# --- fronts ------------------------------------------------------------------------------------


def front_at(tau_bar, seed):
    return measured(
        decay_of_front, record_of(parameters(seed, **REFERENCE, **{"tau-bar": tau_bar}))
    )


@cache
def fronts(seed):
    """{tau_bar_0: what decay_length.py reports}"""
    tau_bars = frozen.tau_bars("fig3", spaced(0.07, 0.12, 0.005), 0.005)
    points = [(tau_bar, seed) for tau_bar in tau_bars]
    found = every(front_at, points, f"decay length, seed {seed}")
    return {tau_bar: of for (tau_bar, _), of in found.items()}


def stiffness(kappa, seed):
    prestress = {"sigma-bar": 0.1, "tau-bar": 0.1}
    changed = {"junctions.kappa": kappa, "numerics.seed": seed}
    return measured(decay_of_front, record_of(prestress | changed))


@cache
def fronts_by_stiffness(seed):
    """The fronts of a seed by k_i, from the largest."""
    points = [(kappa, seed) for kappa in KAPPAS]
    return [*every(stiffness, points, f"stiffness, seed {seed}").values()]


# --- what claims measure -----------------------------------------------------------------------


def each_seed():
    return over_seeds(lambda seed: [*fronts(seed).values()], "decay lengths")


def in_mm(lengths):
    return [1e3 * min(lengths), 1e3 * max(lengths)] if lengths else None


def length(fronts, way):
    """3D-length: the median of the fronts, all of the same weight."""
    l_0 = {name: median(of.l_0[name] for of in fronts) for name in METHODS}
    others = [of for name, of in l_0.items() if name != PRIMARY and of is not None]
    each = [of.l_0[PRIMARY] for of in fronts if of.l_0[PRIMARY] is not None]
    return {
        "l_0 [mm]": None if l_0[way] is None else l_0[way] * 1e3,
        "slow fronts": sum(of.profiles > 0 for of in fronts),
        "profiles": sum(of.profiles for of in fronts),
        "least and most of a front [mm]": in_mm(each),
        "least and most in the other ways [mm]": in_mm(others),
    }


def each_stiffness():
    return over_seeds(fronts_by_stiffness, "stiffness")


def by_stiffness(fronts, way):
    """3D-stiffness. k_i = N_s sqrt(kappa f_N): k/k_i over the reference's is sqrt(KAPPA/kappa)."""
    ratios = np.array([math.sqrt(KAPPA / kappa) for kappa in KAPPAS])
    l_0 = values(of.l_0[way] for of in fronts)
    known = np.isfinite(l_0)
    several = sum(known) > 1
    logs = np.log(ratios[known]), np.log(l_0[known])
    return {
        "k/k_i over the reference's": ratios.tolist(),
        "l_0 [mm]": (1e3 * l_0).tolist(),
        "slow fronts": sum(known),
        "each longer than the one before": several and np.diff(l_0[known]).min() > 0,
        "exponent": np.polyfit(*logs, 1)[0] if several else np.nan,
    }
