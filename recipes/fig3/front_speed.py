"""Figure 3 D: the speed of slow fronts beside that of slow slip, under both laws. sweeps.md says
which parameters go with those that vary.

The simplified law has one spring per block and no width: another width of phi is that of the full
model alone.
"""

from functools import cache, partial

import numpy as np
from rupture.once import run

import frozen
import paper
from claims.samples import Samples
from fig3 import slow_fronts as slow
from maps import over_seeds, places_of, spaced, samples_of_seeds
from measure.ways import PRIMARY
from measure.tables import numbers

NX = 57
N_S = 100
MODELS = ("full", "simplified")
FASTER = 10  # [m/s]; away from arrest
REFERENCE = {"junctions.law": "reference", "junctions.v_slow": 0}
SIMPLIFIED = {"junctions.law": "simplified", "sigma-bar": 0, "junctions.v_slow": 1e-3}
V_SLOW = (0.3e-3, 0.5e-3, 0.75e-3, 1e-3, 1.5e-3, 2e-3, 3e-3, 5e-3)  # [m/s]
T_R, MU_D = "junctions.t_R", "junctions.mu_d"
TIMES = (1e-3, 2e-3, 4e-3)  # t_R [s]
VARIED = ("v_slow and tau_0", "t_R and tau_0", "t_R", "f_slip", "k_i", "F_N")


# --- fronts ------------------------------------------------------------------------------------


def over(name, *values):
    return [{name: value} for value in values]


def on_stress(tau_bars, name, values, step=0.005):
    """On prestress in steps."""
    shifted = frozen.tau_bars("fig3", tau_bars, step)
    return [{"tau-bar": tau_bar, name: value} for tau_bar, value in places_of(shifted, values)]


FULL: dict[str, list] = {  # each with its variants
    "full, f_slip": over(MU_D, 0.085, 0.1275, 0.255, 0.34),
    "full, k_i": over("slider.E", 1.5e9, 2e9, 2.5e9, 3.5e9),
    "full, F_N": over("slider.F_N", 960, 1440, 2880, 3840),
}
OF_SIMPLIFIED = {
    "simplified, v_slow and tau_0": on_stress((0.05, 0.1, 0.15), "junctions.v_slow", V_SLOW, 0.05),
    "simplified, t_R": over(T_R, 1e-3, 1.5e-3, 3e-3, 4e-3),
    "simplified, f_slip": over(MU_D, 0.085, 0.1275, 0.255),
    "simplified, k_i": over("slider.E", 2e9, 4.5e9, 6e9),
    "simplified, F_N": over("slider.F_N", 960, 1440, 2880),
}
VARIANTS = {
    "full, t_R and tau_0": on_stress(spaced(0.07, 0.12, 0.005), T_R, TIMES),
    **FULL,
    **{name: [SIMPLIFIED | of for of in variants] for name, variants in OF_SIMPLIFIED.items()},
}
# Its full model at other widths of phi, around the prestress at which the front is as fast.
WIDTHS = {
    "full, t_R and tau_0": [
        {"sigma-bar": 0} | of for of in on_stress(spaced(0.14, 0.19, 0.005), T_R, TIMES)
    ],
    **{
        name: [{"sigma-bar": sigma, "tau-bar": 0.165 - 0.475 * sigma} | of
               for sigma in (0, 0.2) for of in variants]
        for name, variants in FULL.items()
    },
    "full, t_R and tau_0, wide": [
        {"sigma-bar": 0.2} | of for of in on_stress(spaced(0.04, 0.09, 0.005), T_R, TIMES)
    ],
}  # fmt: skip


def parameters(seed, **changed):
    """f_thres/f_slip, delta_t_R/t_R and k/k_i are kept, and k_i when F_N varies; the time step
    follows the wave speed."""
    of = {"tau-bar": 0.1, "sigma-bar": 0.1, "slider.E": 3e9, "slider.F_N": 1920}
    of |= {"junctions.mu_d": 0.17, "junctions.t_R": 2e-3, "numerics.seed": seed} | changed
    stiffness = of["slider.E"] / 3e9
    following = {
        "junctions.mu_s": 0.4 / 0.17 * of["junctions.mu_d"],
        "junctions.kappa": 39.2e9 * stiffness**2 / (of["slider.F_N"] / 1920),
        "junctions.delta_t_R": 0.3 * of["junctions.t_R"],
        "numerics.dt": 2e-7 / stiffness**0.5,
    }
    return slow.as_typed(of | following)


@cache
def fronts(seed):
    """Rows under both laws."""
    of_seed = partial(parameters, seed, **REFERENCE)
    return slow.rows_of(VARIANTS, of_seed, f"front speeds, seed {seed}")


def front_of_width(variant, parameters):
    """The row of a front."""
    found = run(f"analyze slow-slip {slow.record_of(parameters)}")
    row = {"variant": variant, **parameters, "type": found.type, "windows": {PRIMARY: found}}
    return slow.in_window(row)


@cache
def widths(seed):
    """Usable rows of the full law at other widths of phi."""
    title = f"other widths, seed {seed}"
    return slow.usable(slow.rows_of(WIDTHS, partial(parameters, seed), title, front_of_width))


# --- fits --------------------------------------------------------------------------------------


def scaled_slip(rows):
    """Slow slip times k_i l_0 / (tau_thres - tau_0) [m/s]; of tau-bar, tau_thres is 1."""
    p = numbers(rows, "slider.F_N") / NX
    k_i = N_S * np.sqrt(numbers(rows, "junctions.kappa") * p / N_S)
    mu_s, mu_d = numbers(rows, "junctions.mu_s"), numbers(rows, "junctions.mu_d")
    scale = k_i * paper.L_0 / ((1 - numbers(rows, "tau-bar")) * (mu_s - mu_d) * p)
    return scale * slip(rows)


def slip(rows):
    return numbers(rows, "slow slip [m/s]")


def fit(rows):
    return slow.fit_through_origin(scaled_slip(rows), slow.speeds(rows))


def chosen(rows, model, variants=VARIED):
    """A row is of a variant such as "full, t_R and tau_0, wide": the model, and what varies."""
    variant_of = ((row, row["variant"].split(", ")) for row in rows)
    return [row for row, (of, name, *_) in variant_of if of == model and name in variants]


def fits_of(rows):
    """{model: fit}, and the same of speeds without scaling, and of faster fronts."""
    found: dict = {}
    for model in MODELS:
        of = chosen(rows, model)
        faster = [row for row in of if row["front speed [m/s]"] >= FASTER]
        unscaled = slow.fit_through_origin(slip(of), slow.speeds(of))
        found |= {model: fit(of), f"{model}, unscaled": unscaled, f"{model}, faster": fit(faster)}
    return found


def usable_fronts(seed):
    """{way to measure: usable rows}"""
    return slow.by_way(fronts(seed))


def with_width(rows, widths, sigma_bar):
    """The full model's fronts at this width of phi instead; the simplified one has none."""
    return chosen(rows, "simplified") + [row for row in widths if row["sigma-bar"] == sigma_bar]


def fits(seed):
    """A sample: {way to measure: {model: fit}}"""
    return {way: fits_of(rows) for way, rows in usable_fronts(seed).items()}


def each_seed():
    def at_width(sigma_bar):
        def of_seed(seed):
            rows = with_width(usable_fronts(seed)[PRIMARY], widths(seed), sigma_bar)
            return {PRIMARY: fits_of(rows)}

        return samples_of_seeds(of_seed, f"sigma-bar {sigma_bar}")

    found = over_seeds(fits, "front speeds")
    return Samples(found.shown, found.taken | {f"sigma-bar {s}": at_width(s) for s in (0, 0.2)})


def scaling(fits, way):
    """3D"""
    found = fits[way]
    exponents = {f"exponent, {model}": found[model].exponent for model in MODELS}
    return collapse(fits, way) | exponents | (beside(found) if way == PRIMARY else {})


def beside(found):
    """What stands beside claim 3D."""
    values: dict = {}
    for model in MODELS:
        of, faster = found[model], found[f"{model}, faster"]
        values |= {
            f"exponent, {model}, 90 % interval": slow.exponent_interval(of),
            f"exponent, {model}, fronts of {FASTER} m/s or more": faster.exponent,
            f"speed at no slow slip, {model} [m/s]": of.offset,
            f"largest deviation from the line, {model}": of.largest,
        }
    return values


def collapse(fits, way):
    """3D-collapse"""
    found = fits[way]
    full, simplified = (found[model] for model in MODELS)
    gain = [found[m].r_squared - found[f"{m}, unscaled"].r_squared for m in MODELS]
    return {
        "slope, full": full.slope,
        "slope, simplified": simplified.slope,
        "R^2, full": full.r_squared,
        "R^2, simplified": simplified.r_squared,
        "difference of the slopes": abs(full.slope / simplified.slope - 1),
        "R^2 beyond that without scaling": np.min(gain),
    }
