"""Edges between types of fronts on prepared interfaces (maps.py) on finer lattices. README.md
explains the scaling."""

from functools import cache

from claims.samples import every
from maps import Interfaces
from measure.fronts import SLOW_BELOW, STENCIL

STEP = 1e-3  # of tau_bar_0
SCALED = "same length and speed"
SIGMA_BARS = (0, 0.1, 0.285)
PER_LENGTH = "N_s per length"  # as many junctions as on the paper's lattice; else 100 per block
HALF, OFF = "--set slider.edge_springs=half", "--set junctions.f_new=f_slip"
SETTINGS = {  # name: options, junctions
    "reference": ("", ""),
    "reference-half": (HALF, ""),
    "no-slow-slip": (OFF, ""),
    "no-slow-slip-half": (f"{OFF} {HALF}", ""),
    "no-slow-slip-per-length": (OFF, PER_LENGTH),
}


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
    return {SCALED: f"--stencil {stencil} --slow-below {SLOW_BELOW * (M / 0.0756) ** 0.5}"}


def edges_on(N_x, setting, sigma_bar, guesses):
    """{kind: edge}, each sought from a guess on."""
    options, junctions = SETTINGS[setting]
    values = scaled(N_x, 104 * 56 // (N_x - 1) if junctions == PER_LENGTH else 100)
    words = " ".join(f"--set {name}={value:.12g}" for name, value in values.items())
    prepared = f"--sigma-bar {sigma_bar} {options} {words}"
    fronts = Interfaces(prepared, STEP, ways(N_x, values["slider.M"]))
    return {kind: fronts.edge(kind, SCALED, guess) for kind, guess in guesses.items()}


def moved_on(edges):
    """Guesses on the next lattice: the last edge, moved on by half its last change."""
    before, last = edges[-2:]
    return {kind: last[kind] + (last[kind] - before[kind]) / 2 for kind in last}


def edges_of(setting, sigma_bar):
    """On lattices from coarse to fine, and on 449 x 241 blocks where nothing creeps: that takes a
    fifth of the time."""
    found = [edges_on(57, setting, sigma_bar, {"slow": 0.1, "fast": 0.1})]
    found.append(edges_on(113, setting, sigma_bar, found[-1]))
    for N_x in (225, 449) if setting == "no-slow-slip" else (225,):
        found.append(edges_on(N_x, setting, sigma_bar, moved_on(found)))
    return found


@cache
def edges():
    """{(setting, sigma_bar): edges on the lattices from coarse to fine}"""
    return every(edges_of, [(name, s) for name in SETTINGS for s in SIGMA_BARS], "lattices")
