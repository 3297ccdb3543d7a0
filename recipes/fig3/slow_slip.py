"""Figure 3 C, inset: the speed of slow slip behind fronts on prepared interfaces, beside that of
Eq. S1. sweeps.md says which parameters go with those that vary, and in which ways k_i does."""

from functools import cache
from types import SimpleNamespace

import numpy as np
from rupture.once import run

from claims.samples import every
from events import FINE, WIDTH, slip_times
from fig3 import slow_fronts as slow
from fig3.commands import continued
from maps import over_seeds
from measure.ways import PRIMARY
from measure.tables import numbers

MM = 1e3  # [mm/m]
ALIKE = 1.2  # ratio of the speeds of neighbouring blocks, at most
STIFFNESSES = (1.5e9, 2.25e9, 4.5e9, 6e9)  # slider.E [Pa]
K_I = {  # the variant in which k_i varies, by the way to measure; primary: as the SI says
    PRIMARY: "k_i",
    "trigger's prestress unchanged": "k_i alone",
    "K scaled with E": "k_i and K",
}


# --- fronts ------------------------------------------------------------------------------------


def stiffer(E):
    """k/k_i and k_i vary with the slider's stiffness, and the time step follows the wave speed."""
    stiffness = {"slider.E": E, "junctions.kappa": 39.2e9 * (E / 3e9) ** 2}
    return stiffness | {"numerics.dt": 2e-7 / (E / 3e9) ** 0.5}


VARIANTS: dict[str, list] = {
    "reference": [{}],
    "t_R": [
        {"junctions.t_R": t_R, "junctions.delta_t_R": 0.3 * t_R}
        for t_R in (0.75e-3, 1e-3, 1.5e-3, 3e-3, 4e-3)
    ],
    "tau_slip": [
        {"junctions.mu_d": mu_d, "junctions.mu_s": 0.4 / 0.17 * mu_d}
        for mu_d in (0.085, 0.1275, 0.255, 0.34)
    ],
    "k_i": [stiffer(E) | {"tau-bar-trigger": 0.3 * (E / 3e9) ** -0.18} for E in STIFFNESSES],
    # Reported beside the claim: fronts nearer to arrest, and a faster one.
    "prestress": [{"tau-bar": tau_bar} for tau_bar in (0.075, 0.085, 0.11)],
    "k_i alone": [stiffer(E) for E in STIFFNESSES],
    "k_i and K": [stiffer(E) | {"driving.K": 4e6 * E / 3e9} for E in STIFFNESSES],
}


@cache
def fronts(seed):
    """The rows of a seed."""
    common = {"sigma-bar": 0.1, "tau-bar": 0.1, "numerics.seed": seed}

    def parameters(**changed):
        return slow.as_typed(common | changed)

    return slow.rows_of(VARIANTS, parameters, f"slow slip, seed {seed}")


def longer(t_R):
    """The row of event II with V = 0 and other slipping times. Its front's speed is that of the
    slow stretch."""
    of = continued("event II")
    changed = f"--set driving.V=0 {slip_times(t_R)} --for 5e-3"
    record = run(f"restart {of.start} -o longer.h5 {changed} {FINE}")["record.h5"]
    found = run(f"analyze slow-slip {record} --x-from 0.028 --x-to 0.07")
    row = {"type": of.fronts[PRIMARY].type, "point": record.work.own, "windows": {PRIMARY: found}}
    return slow.in_window(row) | {"front speed [m/s]": (found.slow or {}).get("speed")}


@cache
def of_event():
    points = [(t_R,) for t_R in (1e-3, 1.5e-3, 2e-3, 3e-3, 4e-3)]
    return slow.usable([*every(longer, points, "event II").values()])


# --- fits --------------------------------------------------------------------------------------


def varied(rows, k_i=K_I[PRIMARY]):
    """What the claim is about, k_i varied in one way; the quantity that varies is `varies`."""
    names = {name: name for name in ("reference", "t_R", "tau_slip")} | {k_i: "k_i"}
    return [row | {"varies": names[row["variant"]]} for row in rows if row["variant"] in names]


def estimate_and_measured(rows):
    return numbers(rows, "estimate [m/s]") * MM, numbers(rows, "slow slip [m/s]") * MM


def fit(rows):
    return slow.fit_through_origin(*estimate_and_measured(rows))


def fit_of(rows):
    """The fit, if each quantity was varied: to two values or more, beside the reference."""
    counts = [sum(row["varies"] == name for row in rows) for name in ("t_R", "tau_slip", "k_i")]
    return fit(rows) if min(counts) >= 2 else slow.NO_FIT


def fits_of(seed):
    """A sample: {way to measure: rows}, those that the claim is about, {way: fit}, and that of
    event II."""
    rows = slow.by_way(fronts(seed))
    ways = {name: (rows[PRIMARY], k_i) for name, k_i in K_I.items()}
    ways |= {name: (of, K_I[PRIMARY]) for name, of in rows.items() if name != PRIMARY}
    fits = {name: fit_of(varied(of, k_i)) for name, (of, k_i) in ways.items()}
    of_SI = varied(rows[PRIMARY])
    return SimpleNamespace(rows=rows, varied=of_SI, fits=fits, event=fit(of_event()))


def each_seed():
    return over_seeds(fits_of, "slow slip")


def inset(of, way):
    """3C-inset"""
    found, speeds = of.fits[way], slow.speeds(of.varied)
    return {
        "slope": found.slope,
        "R^2": found.r_squared,
        "exponent": found.exponent,
        "largest deviation from the line": found.largest,
        "prepared interfaces": len(of.varied),
        "slowest and fastest front [m/s]": [speeds.min(), speeds.max()] if len(speeds) else None,
        "slope, event II": of.event.slope,
    }


def largest_ratio(row):
    """The faster over the slower of two neighbours behind a front; NaN if there are none, or one
    does not slip forwards."""
    blocks = [round(x / WIDTH) for x in row["per_block"]["x"]]
    speed = row["per_block"]["speed"]
    pairs = zip(blocks, blocks[1:], speed, speed[1:])
    if min(speed) <= 0:
        return np.nan
    ratios = (max(v, w) / min(v, w) for one, next_one, v, w in pairs if next_one == one + 1)
    return max(ratios, default=np.nan)


def neighbours(of, way):
    """3C-neighbours: behind the front with the reference parameters, and those of all variants."""
    rows = of.rows[way]
    ratios = [largest_ratio(row) for row in rows]
    ours = [ratio for ratio, row in zip(ratios, rows) if row["variant"] == "reference"]
    return {
        "largest ratio of neighbours": ours[0] if ours else None,
        "fronts of all variants": len(ratios),
        "of these it holds for": sum(ratio <= ALIKE for ratio in ratios),
    }
