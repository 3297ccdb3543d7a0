"""Edges between types of fronts on prepared interfaces (maps/edges.py) on another lattice:

    lattice.py FOLDER N_X N_S SIGMA_BAR "OPTION ..." [COARSER ...]

N_S junctions per block, options of `prepare`, and what this printed for the coarser lattices.
README.md explains the scaling."""

from pathlib import Path

from data.records import report
from data.scratch import scratch
from events.conventions import PRIMARY
from events.fronts import SLOW_BELOW, STENCIL
from maps.edges import Interfaces
from maps.front_map import TYPES

STEP = 1e-3  # of tau_bar_0
SCALED = "same length and speed"
FIRST_GUESS = 0.1  # on the coarsest lattice


def spacing(N_x):
    """Over that of the paper's lattice."""
    return 56 / (N_x - 1)


def scaled(N_x, N_s):
    """{parameter: value}"""
    r = spacing(N_x)
    N_z = round(30 / r) + 1
    return {
        "slider.Nx": N_x,
        "slider.Nz": N_z,
        "slider.M": 0.0756 * N_x * N_z / (57 * 31) * r**2,
        "slider.F_N": 1920 * N_x / 57 * r,
        "slider.foundation": 0.5 * r,
        "slider.damping": 0.1 / r**2,
        "junctions.N_s": N_s,
        "junctions.kappa": 39.2e9 * r * 100 / N_s,
        "numerics.dt": min(2e-7 * r, 8e-7 * r**2),
    }


def ways(N_x, M):
    """How fronts are measured: with a stencil of the same length, and slow below the same speed, on
    all lattices."""
    stencil = round((STENCIL - 1) / spacing(N_x)) + 1
    return {
        PRIMARY: {},
        SCALED: {"--stencil": stencil, "--slow-below": SLOW_BELOW * (M / 0.0756) ** 0.5},
    }


def guess(coarser):
    """From an edge on coarser lattices: its last change halves."""
    before, last = (2 * (coarser or [FIRST_GUESS]))[-2:]
    return last + (last - before) / 2


def main(folder, N_x, N_s, sigma_bar, options, *coarser):
    values, found = scaled(int(N_x), float(N_s)), [report(path) for path in coarser]
    words = [f"--set {name}={value:.12g}" for name, value in values.items()]
    words = " ".join(["--sigma-bar", sigma_bar, *words, options]).split()
    with scratch(Path(folder)) as folder:
        fronts = Interfaces(folder, words, STEP, ways(int(N_x), values["slider.M"]))
        guesses = {kind: guess([edges[kind] for edges in found]) for kind in TYPES[1:]}
        return {kind: fronts.edge(kind, near, SCALED) for kind, near in guesses.items()}
