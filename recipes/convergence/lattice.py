"""Edges between types of fronts on prepared interfaces (measure/edges.py) on another lattice, as
the script of a chain:

    n_113 = script lattice.py 113 100 SLOW FAST {values}

with N_x blocks along x and N_s junctions per block (or per-length, as many per length as on the
paper's lattice), seeks the edges from SLOW and FAST on, under these options of `prepare`. README.md
explains the scaling."""

from measure.conventions import PRIMARY
from measure.fronts import SLOW_BELOW, STENCIL
from measure.edges import Interfaces

STEP = 1e-3  # of tau_bar_0
SCALED = "same length and speed"


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


def main(N_x, N_s, slow, fast, *options):
    per_block = 104 * 56 // (int(N_x) - 1) if N_s == "per-length" else float(N_s)
    values = scaled(int(N_x), per_block)
    words = [word for name in values for word in ("--set", f"{name}={values[name]:.12g}")]
    fronts = Interfaces([*options, *words], STEP, ways(int(N_x), values["slider.M"]))
    near = {"slow": float(slow), "fast": float(fast)}
    return {kind: fronts.edge(kind, guess, SCALED) for kind, guess in near.items()}
