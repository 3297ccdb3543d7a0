"""The speed of slow fronts beside that of slow slip, as the script of a chain:

    scaling = script front_speed.py {all front_speed where numerics.seed == seed}
    scaling = script front_speed.py SIGMA-BAR FRONTS OTHERS

Reports lines through the origin for the full and the simplified model, in each way to measure
("under"); with another width of phi, for that. The simplified law has one spring per block and no
width: another one is that of the full model alone.
"""

import numpy as np

import slow_fronts as slow
from chains.results import read_points
from claims import paper
from measure.conventions import PRIMARY
from measure.tables import numbers

NX = 57
N_S = 100
VARIED = ("v_slow and tau_0", "t_R and tau_0", "t_R", "f_slip", "k_i", "F_N")


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
    return {model: fit(chosen(rows, model)) for model in ("full", "simplified")}


def scaling_of(rows):
    """Without values where a model could not be fitted."""
    full, simplified = fits_of(rows).values()
    both = full and simplified
    names = ("r_squared", "slope", "exponent", "largest")
    return {
        f"{name}_{model}": value
        for model, fit in (("full", full), ("simplified", simplified))
        for name, value in slow.measured(fit, *names).items()
    } | {"difference": abs(full.slope / simplified.slope - 1) if both else None}


def with_width(rows, widths, sigma_bar):
    """The full model's fronts at this width of phi instead; the simplified one has none."""
    others = [row for row in widths if float(row["sigma-bar"]) == sigma_bar]
    return chosen(rows, "simplified") + others


def scalings(points):
    rows = slow.fronts(points)
    found = {PRIMARY: scaling_of(rows)}
    found |= {window: scaling_of(slow.fronts(points, window)) for window in slow.OTHER_WINDOWS}
    found[slow.WITHOUT_NEAR_ARREST] = scaling_of(slow.without_near_arrest(rows))
    return found.pop(PRIMARY) | {"under": found}


def main(*words):
    if len(words) == 1:
        return scalings(read_points(words[0]))
    sigma_bar, *files = words
    rows, widths = (slow.fronts(read_points(file)) for file in files)
    return scaling_of(with_width(rows, widths, float(sigma_bar)))
